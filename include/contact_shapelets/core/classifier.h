#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/feature_extractor.h"
#include "contact_shapelets/core/model.h"

/// \file
/// Names the outcome of an episode by a trained model. The classifier node and the offline program both use it.

namespace contact_shapelets::core {

/// The diagnosis of one episode.
struct Diagnosis {
  int cluster = -1;         ///< the nearest cluster; -1 if `novelty` is above 1
  int nearest_cluster = 0;  ///< the nearest cluster, whatever the novelty
  std::string event;        ///< Model::EventOf(cluster)
  float confidence = 0.0F;  ///< [0, 1] share of the nearest cluster if each has a weight of 1 / distance^2
  float novelty = 0.0F;     ///< distance to the nearest centroid, divided by the cluster's novelty limit
};

/// Features and diagnosis of one episode.
struct Classification {
  ShapeletDistances features;  ///< where and how well each shapelet matched
  Diagnosis diagnosis;         ///< what follows from them
};

/// Classifies episodes by one model.
class Classifier {
 public:
  /// Prepares `model`. \throws std::invalid_argument that names every fault of the model.
  explicit Classifier(Model model);

  /// Classifies one episode. An episode of another sample period than the model's is resampled first.
  /// \throws std::invalid_argument if the episode has fewer than 2 samples (before or after resampling), a value that
  /// is not finite, or a sample period that is not in [0.0001, 1] s.
  Classification Classify(const Episode& episode) const;
  /// The same with `memory` of the caller, who keeps it for the next episode. Each thread needs its own.
  Classification Classify(const Episode& episode, FeatureMemory* memory) const;

  /// Sets the label of a cluster. \throws std::invalid_argument if there is no such cluster, or the label is empty or
  /// longer than kLongestLabel.
  void NameCluster(int cluster, const std::string& label);

  /// The model in use.
  const Model& model() const { return model_; }

 private:
  Model model_;
  FeatureExtractor extractor_;
};

}  // namespace contact_shapelets::core

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/feature_extractor.h"
#include "contact_shapelets/core/model.h"

/// \file
/// Names the outcome of an episode by a trained model. Used alike by the classifier node and the offline program.

namespace contact_shapelets::core {

/// What the classifier made of one episode.
struct Diagnosis {
  int cluster = -1;         ///< the nearest cluster; -1 where the episode fits none
  int nearest_cluster = 0;  ///< the nearest cluster, novel or not
  std::string event;        ///< Model::EventOf(cluster)
  float confidence = 0.0F;  ///< [0, 1] share of the nearest cluster against the others
  float novelty = 0.0F;     ///< distance to the nearest centroid over its limit; above 1 fits none
};

/// Features and diagnosis of one episode.
struct Classification {
  ShapeletDistances features;
  Diagnosis diagnosis;
};

/// Applies one model.
class Classifier {
 public:
  /// Prepares `model`. \throws std::invalid_argument naming every fault of the model.
  explicit Classifier(Model model);

  /// Classifies one episode in a single pass. An episode of another sample period is resampled first.
  /// \throws std::invalid_argument where the episode has fewer than 2 samples, before or after that, a value that is
  /// not finite, or a sample period that is not in [0.0001, 1] s.
  Classification Classify(const Episode& episode) const;
  /// The same in memory of the caller, which is kept from one episode to the next; one per thread.
  Classification Classify(const Episode& episode, FeatureMemory* memory) const;

  /// Sets the label of a cluster. \throws std::invalid_argument where there is no such cluster, or the label is empty
  /// or longer than kLongestLabel.
  void NameCluster(int cluster, const std::string& label);

  /// The model in use.
  const Model& model() const { return model_; }

 private:
  Model model_;
  FeatureExtractor extractor_;
};

}  // namespace contact_shapelets::core

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/preparation.h"
#include "contact_shapelets/core/shapelet.h"
#include "contact_shapelets/core/time.h"

/// \file
/// A trained model: what a classifier needs, and how it was trained. ShapeletModel.msg has the same fields.

namespace contact_shapelets::core {

/// Greatest number of shapelets. This and the limits below keep a faulty file from filling the reader's memory.
constexpr int kMostShapelets = 10'000;
constexpr int kMostClusters = 1'000;           ///< greatest number of clusters
constexpr int kMostValues = 10'000'000;        ///< values of all shapelets together, and of all centroids together
constexpr int kGreatestReach = 6'000'000;      ///< [samples] reach of one shapelet: 600 s at the shortest sample period
constexpr std::size_t kLongestLabel = 200;     ///< [bytes] length of a cluster's name, an id or an objective
constexpr std::size_t kLongestPath = 4'096;    ///< [bytes] length of a source's path
constexpr std::size_t kMostSources = 100'000;  ///< greatest number of sources

/// One cluster in feature space.
struct Cluster {
  Eigen::VectorXf centroid;    ///< [K], see Model::Features(), each value in [-100, 100]
  float novelty_limit = 0.0F;  ///< [1e-6, 1e9]; an episode farther from the centroid fits no cluster
  int size = 0;                ///< number of training episodes in it, at least 0
  std::string label;           ///< the event's name; empty if it has none yet
};

/// How a model was trained.
struct Provenance {
  std::vector<std::string> sources;     ///< bag files
  std::string objective;                ///< "contrastive" or "paper"
  std::vector<double> selected_scales;  ///< the scale of each bank, as a part of the median episode, each in (0, 1)
  std::uint64_t seed = 0;               ///< TrainerOptions::seed
  int training_episodes = 0;            ///< N, at least 0
  double typical_duration = 0.0;        ///< [s] median duration of the training episodes, [0, 1e7]
  Nanoseconds trained = 0;              ///< when the training ended, on the machine's clock; 0 if unknown
};

/// Shapelets and clusters.
struct Model {
  std::string id;                   ///< unique
  double sample_period = 0.0;       ///< [s] sample period of the training episodes
  double flat_fraction = 0.3;       ///< windows under this part of the episode's standard deviation never match, [0, 1)
  double log_offset = 0.05;         ///< see Features(), 0 or [1e-6, 1]
  std::vector<Shapelet> shapelets;  ///< [K], one feature each
  std::vector<Cluster> clusters;    ///< [C]
  Provenance provenance;            ///< how it was trained
  Preparation preparation;          ///< how its training episodes were made

  /// Returns the features that clusters are formed on, for distances F [N, K], one series per row:
  /// log(max(F, 0) + log_offset), or max(F, 0) if `log_offset` is 0.
  Eigen::MatrixXf Features(const Eigen::Ref<const Eigen::MatrixXf>& distances) const;

  /// Returns the event that `cluster` stands for: its label, "cluster_<index>" if it has none, "unknown" for -1.
  std::string EventOf(int cluster) const;

  /// Returns every fault of the model, one per line; an empty string if the model is valid. Bounds are those of the
  /// fields above.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core

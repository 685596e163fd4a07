#pragma once

#include <cstdint>
#include <string>

#include "evaluation/clusterer.h"
#include "evaluation/data_set.h"
#include "evaluation/partition_metrics.h"

/// \file
/// The protocol by which methods are compared.

namespace contact_shapelets::evaluation {

/// How one method did on one data set with one seed.
struct EvaluationResult {
  std::string data_set;
  std::string method;
  std::uint64_t seed = 0;
  PartitionScores train;                 ///< of the clusters learned
  PartitionScores test;                  ///< of the test series given to the nearest centroid of those
  PartitionScores test_anew;             ///< of the test series clustered anew on the features learned
  double fit_seconds = 0.0;              ///< [s] of learning and clustering
  double transform_ms_per_series = 0.0;  ///< [ms] of the features of one test series, on average
};

/// Learns `clusterer` on the training series, z-normalised and without their classes, and compares its three partitions
/// with the classes. `method` only names the result. \throws std::invalid_argument as Clusterer::Fit() does.
EvaluationResult Evaluate(const DataSet& data_set, const std::string& method, std::uint64_t seed, Clusterer* clusterer);

/// `data` with every series z-normalised.
LabelledSeries ZNormalisedSeries(const LabelledSeries& data);

/// Splits `all` into a training part of `train_part` (0, 1) of each class and a test part of the rest, by a shuffle
/// from `seed`; a class of 2 or more has at least one series in each. `class_count` is the number of classes in `all`.
DataSet SplitByClass(const std::string& name, const LabelledSeries& all, int class_count, double train_part,
                     std::uint64_t seed);

}  // namespace contact_shapelets::evaluation

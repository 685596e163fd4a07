#pragma once

#include <cstdint>
#include <string>

#include "evaluation/clusterer.h"
#include "evaluation/data_set.h"
#include "evaluation/partition_metrics.h"

/// \file
/// The protocol of an evaluation.

namespace contact_shapelets::evaluation {

/// The scores of one method on one data set with one seed.
struct EvaluationResult {
  std::string data_set;
  std::string method;
  std::uint64_t seed = 0;
  PartitionScores train;                 ///< scores of the clusters of the training series
  PartitionScores test;                  ///< scores of the test series by nearest centroid of these clusters
  PartitionScores test_anew;             ///< scores of the test series clustered anew on the learned features
  double fit_seconds = 0.0;              ///< [s] to learn and cluster
  double transform_ms_per_series = 0.0;  ///< [ms] to compute the features of a test series, on average
};

/// Lets `clusterer` learn on the training series, z-normalised and without their classes, and compares its three
/// partitions with the classes. `method` only names the result. \throws std::invalid_argument as Clusterer::Fit() does.
EvaluationResult Evaluate(const DataSet& data_set, const std::string& method, std::uint64_t seed, Clusterer* clusterer);

/// Returns `data` with every series z-normalised.
LabelledSeries ZNormalisedSeries(const LabelledSeries& data);

/// Splits `all` at random by `seed`: a part `train_part` (0, 1) of each class into the training split, the rest into
/// the test split. A class of 2 or more series has at least one in each; a class of one goes into the training split.
/// `class_count` is the number of classes in `all`.
DataSet SplitByClass(const std::string& name, const LabelledSeries& all, int class_count, double train_part,
                     std::uint64_t seed);

}  // namespace contact_shapelets::evaluation

#include "core/clustering/latent_class.h"

#include <cmath>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

constexpr int kMostRounds = 200;
/// The rounds end when no membership changes by this much.
constexpr double kSettled = 1e-4;
/// Part of each series' membership that the start spreads over all classes, so that a series can change its class.
constexpr double kDoubt = 0.2;
/// Number of series added to each class, spread evenly over a voter's parts, so that no part has probability 0.
constexpr double kPrior = 0.5;

void Check(const std::vector<Eigen::VectorXi>& votes, const Eigen::Ref<const Eigen::VectorXi>& start, int classes) {
  if (votes.empty() || start.size() == 0) {
    throw std::invalid_argument("latent classes need at least one vote and one series");
  }
  if (start.minCoeff() < 0 || start.maxCoeff() >= classes) throw std::invalid_argument("a label is out of range");
  for (const Eigen::VectorXi& vote : votes) {
    if (vote.size() != start.size()) {
      throw std::invalid_argument("a vote and the start differ in their number of series");
    }
    if (vote.minCoeff() < 0) throw std::invalid_argument("a part of a vote is below 0");
  }
}

/// Returns log P(part | class) of one voter, [parts, classes], by the number of series of each class in each part.
Eigen::MatrixXd LogProbabilities(const Eigen::VectorXi& vote, const Eigen::Ref<const Eigen::MatrixXd>& memberships) {
  const int parts = vote.maxCoeff() + 1;
  Eigen::MatrixXd counts = Eigen::MatrixXd::Constant(parts, memberships.cols(), kPrior / parts);
  for (Eigen::Index series = 0; series < vote.size(); ++series) counts.row(vote[series]) += memberships.row(series);
  const Eigen::RowVectorXd totals = counts.colwise().sum();
  return (counts.array().rowwise() / totals.array()).log();
}

/// Returns P(class | votes) of each series, [N, classes]: an E-step with the probabilities that `memberships` give.
Eigen::MatrixXd Reestimated(const std::vector<Eigen::VectorXi>& votes,
                            const Eigen::Ref<const Eigen::MatrixXd>& memberships) {
  const Eigen::RowVectorXd shares = (memberships.colwise().sum().array() + 1.0).log();
  Eigen::MatrixXd logarithms = shares.replicate(memberships.rows(), 1);
  for (const Eigen::VectorXi& vote : votes) {
    const Eigen::MatrixXd probabilities = LogProbabilities(vote, memberships);
    for (Eigen::Index series = 0; series < vote.size(); ++series) {
      logarithms.row(series) += probabilities.row(vote[series]);
    }
  }
  const Eigen::VectorXd largest = logarithms.rowwise().maxCoeff();
  logarithms = (logarithms.colwise() - largest).array().exp();
  const Eigen::VectorXd totals = logarithms.rowwise().sum();
  return logarithms.array().colwise() / totals.array();
}

}  // namespace

Eigen::VectorXi LatentClasses(const std::vector<Eigen::VectorXi>& votes, const Eigen::Ref<const Eigen::VectorXi>& start,
                              int classes) {
  Check(votes, start, classes);
  Eigen::MatrixXd memberships = Eigen::MatrixXd::Constant(start.size(), classes, kDoubt / classes);
  for (Eigen::Index series = 0; series < start.size(); ++series) memberships(series, start[series]) += 1.0 - kDoubt;
  for (int round = 0; round < kMostRounds; ++round) {
    Eigen::MatrixXd next = Reestimated(votes, memberships);
    const double change = (next - memberships).cwiseAbs().maxCoeff();
    memberships.swap(next);
    if (change < kSettled) break;
  }
  Eigen::VectorXi labels(start.size());
  for (Eigen::Index series = 0; series < start.size(); ++series) memberships.row(series).maxCoeff(&labels[series]);
  for (int index = 0; index < classes; ++index) {
    if ((labels.array() == index).count() == 0) return start;
  }
  return labels;
}

}  // namespace contact_shapelets::core

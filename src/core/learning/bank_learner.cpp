#include "core/learning/bank_learner.h"

#include <algorithm>
#include <cmath>

#include "core/learning/membership.h"
#include "core/learning/objective.h"
#include "core/numerics/parallel.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

/// Adds `weight` times the values that a match compares the shapelet with: the z-normalised window, shifted, and zeros
/// outside of the overlap.
void AddMatchedValues(const WindowSet& windows, const Match& match, double weight, Eigen::VectorXd* sum) {
  const int overlap = windows.length() - std::abs(match.shift);
  const auto samples = windows.series().segment(match.window + std::max(0, match.shift), overlap);
  const double mean = windows.mean()[match.window];
  const double inverse = windows.inverse_deviation()[match.window];
  // Rounds as NormalisedWindow() does.
  sum->segment(std::max(0, -match.shift), overlap).array() +=
      weight * ((samples.cast<double>().array() - mean) * inverse).cast<float>().cast<double>();
}

/// It pays to note low blocks if a value of a shapelet moves by at most this from one search of a series to the next: a
/// little over half of the lag of low values.
constexpr double kMostMoved = 0.05;

double Distance(const Match& match) { return match.window < 0 ? 1.0 : 1.0 - static_cast<double>(match.similarity); }

}  // namespace

BankLearner::BankLearner(const std::vector<Eigen::VectorXf>& series, const SeriesDistances& distances,
                         const Eigen::Ref<const Eigen::MatrixXf>& start, const LearnerOptions& options,
                         std::uint64_t seed, int threads)
    : series_(series),
      distances_(distances),
      options_(options),
      threads_(threads),
      random_(seed),
      shapelets_(start.cast<double>()),
      first_moment_(Eigen::MatrixXd::Zero(start.rows(), start.cols())),
      second_moment_(Eigen::MatrixXd::Zero(start.rows(), start.cols())),
      windows_(series.size()),
      matches_(series.size()),
      low_blocks_(series.size()) {}

double BankLearner::Step() {
  const auto count = static_cast<int>(series_.size());
  std::vector<int> chosen = random_.Sample(count, std::min(count, options_.batch));
  std::sort(chosen.begin(), chosen.end());
  Eigen::MatrixXd gradient;
  objective_ = Evaluate(chosen, &gradient);
  AdamStep(gradient);
  return objective_;
}

double BankLearner::Evaluate(const std::vector<int>& chosen, Eigen::MatrixXd* gradient) {
  FindMatches(chosen);
  Eigen::MatrixXd distances(chosen.size(), shapelets_.rows());
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    for (Eigen::Index k = 0; k < shapelets_.rows(); ++k) {
      distances(static_cast<Eigen::Index>(row), k) = Distance(matches_[chosen[row]][static_cast<std::size_t>(k)]);
    }
  }
  const Eigen::MatrixXd membership = Membership(distances);
  const Term spectral = SpectralTerm(membership, BatchWeights(chosen));
  *gradient = ShapeletGradient(chosen, DistanceGradient(distances, membership, spectral.gradient));
  if (options_.diversity == 0.0) return spectral.value;
  const Term diversity = DiversityTerm(shapelets_, 0.5 * static_cast<double>(shapelets_.cols()));
  const double weight = options_.diversity / static_cast<double>(shapelets_.rows() * shapelets_.rows());
  *gradient += weight * diversity.gradient;
  return spectral.value + weight * diversity.value;
}

void BankLearner::FindMatches(const std::vector<int>& chosen) {
  const ShapeletSet set(shapelets_.cast<float>());
  // A step of Adam changes a value by about the learning rate or less.
  const double steps_between = static_cast<double>(series_.size()) / static_cast<double>(chosen.size());
  const bool often = steps_between * options_.learning_rate <= kMostMoved;
  if (often) history_.Add(set);
  ParallelFor(static_cast<int>(chosen.size()), threads_, [&](int row) {
    const int index = chosen[row];
    if (!windows_[index]) {
      const auto length = static_cast<int>(shapelets_.cols());
      windows_[index] = std::make_unique<WindowSet>(ExtendedTo(series_[index], length), length, options_.flat_fraction);
    }
    if (often) {
      FindBestMatchesAgain(*windows_[index], set, history_, &low_blocks_[index], &matches_[index]);
    } else {
      FindBestMatches(*windows_[index], set, matches_[index], MatchOptions{}, &matches_[index]);
    }
  });
}

Eigen::MatrixXd BankLearner::BatchWeights(const std::vector<int>& chosen) const {
  const Eigen::MatrixXd similarity = GaussianSimilarity(distances_.Among(chosen));
  return options_.objective == Objective::kPaper ? PaperWeights(similarity)
                                                 : ContrastiveWeights(similarity, options_.repulsion);
}

Eigen::MatrixXd BankLearner::ShapeletGradient(const std::vector<int>& chosen,
                                              const Eigen::Ref<const Eigen::MatrixXd>& distance_gradient) const {
  // With s^z = (s - mean) / sigma and F = 1 - s^z x / M:
  //   dF/ds = -(x - mean(x) - s^z (s^z x) / M) / (M sigma). It is linear in x, so matches are summed first.
  Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(shapelets_.rows(), shapelets_.cols());
  const auto length = static_cast<double>(shapelets_.cols());
  ParallelFor(static_cast<int>(shapelets_.rows()), threads_, [&](int k) {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(shapelets_.cols());
    for (std::size_t row = 0; row < chosen.size(); ++row) {
      const Match& match = matches_[chosen[row]][static_cast<std::size_t>(k)];
      if (match.window < 0) continue;
      AddMatchedValues(*windows_[chosen[row]], match, distance_gradient(static_cast<Eigen::Index>(row), k), &pull);
    }
    Eigen::VectorXd normalised = shapelets_.row(k).transpose();
    normalised.array() -= normalised.mean();
    const double deviation = std::sqrt(normalised.squaredNorm() / length);
    if (deviation < 1e-9) return;
    normalised /= deviation;
    const double along = normalised.dot(pull) / length;
    gradient.row(k) =
        (-(pull.array() - pull.mean() - normalised.array() * along) / (length * deviation)).matrix().transpose();
  });
  return gradient;
}

void BankLearner::AdamStep(const Eigen::Ref<const Eigen::MatrixXd>& gradient) {
  constexpr double kFirstDecay = 0.9;
  constexpr double kSecondDecay = 0.999;
  ++step_;
  first_moment_ = kFirstDecay * first_moment_ + (1.0 - kFirstDecay) * gradient;
  second_moment_ = kSecondDecay * second_moment_ + (1.0 - kSecondDecay) * gradient.cwiseAbs2();
  const double first_scale = 1.0 / (1.0 - std::pow(kFirstDecay, step_));
  const double second_scale = 1.0 / (1.0 - std::pow(kSecondDecay, step_));
  shapelets_.array() -= options_.learning_rate * first_scale * first_moment_.array() /
                        ((second_scale * second_moment_.array()).sqrt() + 1e-8);
  // A proximal step reaches exact zeros; a sub-gradient would only hover around them.
  if (options_.sparsity > 0.0) ShrinkToZero(options_.learning_rate * options_.sparsity, shapelets_);
}

}  // namespace contact_shapelets::core

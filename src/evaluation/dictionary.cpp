#include "evaluation/dictionary.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learning/learner.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"
#include "evaluation/data_set.h"

namespace contact_shapelets::evaluation {
namespace {

/// Below, a rest or an atom counts as zero: windows have a norm of about the root of their length.
constexpr double kZero = 1e-9;

/// The z-normalised windows of `length` samples of one series, [M, J], flat ones as zeros.
Eigen::MatrixXd NormalisedWindows(const Eigen::Ref<const Eigen::VectorXf>& series, int length) {
  const Eigen::Index count = series.size() - length + 1;
  Eigen::MatrixXd windows(length, count);
  for (Eigen::Index start = 0; start < count; ++start) {
    windows.col(start) = core::ZNormalised(series.segment(start, length)).cast<double>();
  }
  return windows;
}

/// One round of updates: each atom, with its coefficients, becomes the best rank-one fit of what the others leave over.
void UpdateAtoms(const Eigen::Ref<const Eigen::MatrixXd>& windows, Eigen::MatrixXd* atoms, Eigen::MatrixXd* codes) {
  Eigen::MatrixXd rest = windows - *atoms * *codes;
  for (Eigen::Index atom = 0; atom < atoms->cols(); ++atom) {
    const Eigen::VectorXd coefficients = codes->row(atom).transpose();
    if (coefficients.squaredNorm() <= kZero) {
      Eigen::Index worst = 0;
      rest.colwise().squaredNorm().maxCoeff(&worst);
      const double norm = windows.col(worst).norm();
      if (norm > kZero) atoms->col(atom) = windows.col(worst) / norm;
      continue;
    }
    Eigen::MatrixXd own = rest;
    own += atoms->col(atom) * coefficients.transpose();
    const Eigen::VectorXd used = (coefficients.array() != 0.0).cast<double>();
    const Eigen::VectorXd direction = own * coefficients;
    const double norm = direction.norm();
    if (norm <= kZero) continue;
    atoms->col(atom) = direction / norm;
    const Eigen::VectorXd updated = (own.transpose() * atoms->col(atom)).cwiseProduct(used);
    codes->row(atom) = updated.transpose();
    rest = own - atoms->col(atom) * updated.transpose();
  }
}

void Check(const DictionaryOptions& options) {
  if (!(options.scale > 0.0 && options.scale < 1.0)) throw std::invalid_argument("scale must be in (0, 1)");
  if (options.sparsity < 1) throw std::invalid_argument("sparsity must be at least 1");
  if (options.rounds < 1) throw std::invalid_argument("rounds must be at least 1");
  if (options.windows < 2) throw std::invalid_argument("windows must be at least 2");
}

}  // namespace

Eigen::VectorXd SparseCode(const Eigen::Ref<const Eigen::MatrixXd>& atoms,
                           const Eigen::Ref<const Eigen::VectorXd>& window, int sparsity) {
  Eigen::VectorXd code = Eigen::VectorXd::Zero(atoms.cols());
  Eigen::VectorXd rest = window;
  std::vector<Eigen::Index> chosen;
  Eigen::MatrixXd basis(atoms.rows(), 0);
  Eigen::VectorXd coefficients;
  const auto most = std::min<Eigen::Index>(sparsity, atoms.cols());
  while (static_cast<Eigen::Index>(chosen.size()) < most && rest.norm() > kZero) {
    Eigen::Index next = 0;
    const double similarity = (atoms.transpose() * rest).cwiseAbs().maxCoeff(&next);
    if (similarity <= kZero || std::find(chosen.begin(), chosen.end(), next) != chosen.end()) break;
    chosen.push_back(next);
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = atoms.col(next);
    coefficients = basis.colPivHouseholderQr().solve(window);
    rest = window - basis * coefficients;
  }
  for (std::size_t index = 0; index < chosen.size(); ++index) {
    code[chosen[index]] = coefficients[static_cast<Eigen::Index>(index)];
  }
  return code;
}

Dictionary LearnDictionary(const Eigen::Ref<const Eigen::MatrixXd>& windows, int count,
                           const DictionaryOptions& options, std::uint64_t seed) {
  Check(options);
  if (count < 1 || windows.cols() < count) throw std::invalid_argument("there are fewer windows than atoms");
  core::Random random(seed);
  const std::vector<int> start = random.Sample(static_cast<int>(windows.cols()), count);
  Dictionary dictionary;
  dictionary.atoms.resize(windows.rows(), count);
  for (int atom = 0; atom < count; ++atom) {
    const double norm = windows.col(start[atom]).norm();
    // A flat window is no atom; the first update replaces it.
    dictionary.atoms.col(atom) = windows.col(start[atom]) / std::max(norm, 1.0);
  }
  Eigen::MatrixXd codes(count, windows.cols());
  for (int round = 0; round < options.rounds; ++round) {
    for (Eigen::Index index = 0; index < windows.cols(); ++index) {
      codes.col(index) = SparseCode(dictionary.atoms, windows.col(index), options.sparsity);
    }
    dictionary.errors.push_back((windows - dictionary.atoms * codes).squaredNorm() /
                                static_cast<double>(windows.size()));
    UpdateAtoms(windows, &dictionary.atoms, &codes);
  }
  return dictionary;
}

void DictionaryClusterer::Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  Check(options_);
  length_ = core::MedianLength(train);
  const int atom_length = std::max(3, static_cast<int>(options_.scale * length_));
  if (atom_length >= length_) throw std::invalid_argument("the series are too short for a dictionary");
  const Eigen::MatrixXf rows = EqualLengthRows(train, length_);
  const int places = length_ - atom_length + 1;
  const auto all = static_cast<int>(rows.rows()) * places;
  core::Random random(core::StreamSeed(seed, 0));
  const std::vector<int> chosen = random.Sample(all, std::min(all, options_.windows));
  Eigen::MatrixXd windows(atom_length, static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t index = 0; index < chosen.size(); ++index) {
    const Eigen::VectorXf window =
        rows.row(chosen[index] / places).segment(chosen[index] % places, atom_length).transpose();
    windows.col(static_cast<Eigen::Index>(index)) = core::ZNormalised(window).cast<double>();
  }
  const int count = core::ShapeletCount(static_cast<int>(rows.rows()), length_, atom_length, clusters);
  atoms_ =
      LearnDictionary(windows, std::min(count, static_cast<int>(windows.cols())), options_, core::StreamSeed(seed, 1))
          .atoms;
}

Eigen::MatrixXf DictionaryClusterer::Transform(const std::vector<Eigen::VectorXf>& series) const {
  const Eigen::MatrixXf rows = EqualLengthRows(series, length_);
  Eigen::MatrixXf features(rows.rows(), atoms_.cols());
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const Eigen::MatrixXd windows = NormalisedWindows(rows.row(row).transpose(), static_cast<int>(atoms_.rows()));
    Eigen::VectorXd greatest = Eigen::VectorXd::Zero(atoms_.cols());
    for (Eigen::Index index = 0; index < windows.cols(); ++index) {
      greatest = greatest.cwiseMax(SparseCode(atoms_, windows.col(index), options_.sparsity).cwiseAbs());
    }
    features.row(row) = greatest.transpose().cast<float>();
  }
  return features;
}

}  // namespace contact_shapelets::evaluation

#include "evaluation/dictionary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/numerics/random.h"
#include "core/planted_series.h"
#include "evaluation/partition_metrics.h"

namespace contact_shapelets::evaluation {
namespace {

/// `count` unit columns of `length` values, drawn from a normal distribution.
Eigen::MatrixXd UnitColumns(int length, int count, core::Random* random) {
  Eigen::MatrixXd columns(length, count);
  for (Eigen::Index index = 0; index < columns.size(); ++index) columns.data()[index] = random->Normal();
  columns.colwise().normalize();
  return columns;
}

TEST(SparseCode, FindsTheCoefficientsOfOrthogonalAtoms) {
  const Eigen::MatrixXd atoms = Eigen::MatrixXd::Identity(4, 4);
  const Eigen::VectorXd code = SparseCode(atoms, Eigen::Vector4d(0.5, -3.0, 0.0, 2.0), 2);
  EXPECT_EQ(code, Eigen::Vector4d(0.0, -3.0, 0.0, 2.0)) << "the two greatest";
}

TEST(SparseCode, SolvesForAtomsThatOverlap) {
  Eigen::MatrixXd atoms(3, 2);
  atoms << 1.0, std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0, 0.0;
  const Eigen::VectorXd code = SparseCode(atoms, 2.0 * atoms.col(0) + 3.0 * atoms.col(1), 2);
  EXPECT_NEAR(code[0], 2.0, 1e-9);
  EXPECT_NEAR(code[1], 3.0, 1e-9);
}

TEST(SparseCode, OfZeroIsZero) {
  EXPECT_TRUE(SparseCode(Eigen::MatrixXd::Identity(3, 3), Eigen::Vector3d::Zero(), 2).isZero());
}

TEST(LearnDictionary, RecoversThePlantedAtoms) {
  core::Random random(3);
  const Eigen::MatrixXd planted = UnitColumns(20, 4, &random);
  Eigen::MatrixXd windows(20, 400);
  for (Eigen::Index index = 0; index < windows.cols(); ++index) {
    windows.col(index) = (1.0 + random.Uniform()) * planted.col(random.Index(4));
  }
  DictionaryOptions options;
  options.sparsity = 1;
  const Eigen::MatrixXd found = LearnDictionary(windows, 8, options, 1).atoms;
  for (Eigen::Index atom = 0; atom < planted.cols(); ++atom) {
    EXPECT_NEAR((found.transpose() * planted.col(atom)).cwiseAbs().maxCoeff(), 1.0, 1e-6);
  }
}

TEST(LearnDictionary, LowersItsError) {
  core::Random random(4);
  const Eigen::MatrixXd windows = UnitColumns(16, 6, &random) * UnitColumns(6, 300, &random);
  const std::vector<double> errors = LearnDictionary(windows, 6, DictionaryOptions{}, 1).errors;
  EXPECT_LT(errors.back(), 0.8 * errors.front());
}

TEST(LearnDictionary, RefusesFewerWindowsThanAtoms) {
  EXPECT_THROW(LearnDictionary(Eigen::MatrixXd::Ones(5, 3), 4, DictionaryOptions{}, 1), std::invalid_argument);
  DictionaryOptions options;
  options.sparsity = 0;
  EXPECT_THROW(LearnDictionary(Eigen::MatrixXd::Ones(5, 8), 4, options, 1), std::invalid_argument);
}

TEST(DictionaryClusterer, GivesTheSameLabelsForTheSameSeed) {
  std::vector<Eigen::VectorXf> series;
  for (const core::Episode& episode : core::PlantedEpisodes(8, 10, 1)) series.push_back(episode.force);
  DictionaryClusterer one{DictionaryOptions{}};
  DictionaryClusterer other{DictionaryOptions{}};
  EXPECT_EQ(one.Fit(series, 3, 5), other.Fit(series, 3, 5));
  EXPECT_EQ(one.Transform(series).rows(), 24);
}

}  // namespace
}  // namespace contact_shapelets::evaluation

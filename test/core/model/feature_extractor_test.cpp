#include "contact_shapelets/core/feature_extractor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

Eigen::VectorXf Noise(int length, Random* random) {
  Eigen::VectorXf series(length);
  for (int index = 0; index < length; ++index) series[index] = static_cast<float>(random->Normal());
  return series;
}

Eigen::VectorXf Walk(int length, Random* random) {
  Eigen::VectorXf series = Noise(length, random);
  for (int index = 1; index < length; ++index) series[index] += series[index - 1];
  return series;
}

Shapelet Pattern(const Eigen::VectorXf& values, int dilation = 1) { return {0, dilation, ZNormalised(values)}; }

double Deviation(const Eigen::VectorXd& values) { return std::sqrt((values.array() - values.mean()).square().mean()); }

/// Returns F by its definition: every window, every shift, in double precision. Windows of `flat` deviation or less do
/// not count.
double DistanceByDefinition(const Eigen::VectorXf& series, const Shapelet& shapelet, double flat) {
  const auto length = static_cast<int>(shapelet.values.size());
  const Eigen::VectorXd pattern = shapelet.values.cast<double>();
  double best = -std::numeric_limits<double>::infinity();
  for (int start = 0; start + (length - 1) * shapelet.dilation < series.size(); ++start) {
    Eigen::VectorXd window(length);
    for (int m = 0; m < length; ++m) window[m] = series[start + m * shapelet.dilation];
    const double deviation = Deviation(window);
    if (deviation <= flat) continue;
    window = ((window.array() - window.mean()) / deviation).matrix();
    for (int shift = 1 - length; shift < length; ++shift) {
      double sum = 0.0;
      for (int m = std::max(0, -shift); m < std::min(length, length - shift); ++m) {
        sum += pattern[m] * window[m + shift];
      }
      best = std::max(best, sum / length);
    }
  }
  return std::isfinite(best) ? 1.0 - best : 1.0;
}

TEST(FeatureExtractor, GivesTheDistancesOfManySeriesAsThoseOfEachOne) {
  Random random(21);
  const FeatureExtractor extractor({Pattern(Walk(40, &random)), Pattern(Walk(9, &random), 3)}, 0.2);
  const std::vector<Eigen::VectorXf> series{Walk(300, &random), Walk(20, &random), Walk(150, &random)};
  const Eigen::MatrixXf distances = extractor.Distances(series, 2);
  ASSERT_EQ(distances.rows(), 3);
  for (std::size_t row = 0; row < series.size(); ++row) {
    EXPECT_EQ(Eigen::VectorXf(distances.row(static_cast<Eigen::Index>(row))), extractor.Compute(series[row]).distances);
  }
}

TEST(FeatureExtractor, DoesNotDependOnEarlierUsesOfItsMemory) {
  Random random(12);
  const FeatureExtractor extractor({Pattern(Walk(40, &random)), Pattern(Walk(9, &random), 3)}, 0.2);
  FeatureMemory memory;
  for (const int samples : {300, 20, 150}) {
    const Eigen::VectorXf series = Walk(samples, &random);
    const ShapeletDistances expected = extractor.Compute(series);
    const ShapeletDistances found = extractor.Compute(series, &memory);
    EXPECT_EQ(found.distances, expected.distances);
    EXPECT_EQ(found.match_start, expected.match_start);
    EXPECT_EQ(found.match_span, expected.match_span);
  }
}

TEST(FeatureExtractor, DistancesEqualTheDefinition) {
  Random random(1);
  for (const double flat_fraction : {0.0, 0.3}) {
    std::vector<Shapelet> shapelets;
    for (const int length : {2, 3, 8, 17, 8, 40}) {
      for (const int dilation : {1, 2, 3}) shapelets.push_back(Pattern(Walk(length, &random), dilation));
    }
    const FeatureExtractor extractor(shapelets, flat_fraction);
    for (int round = 0; round < 3; ++round) {
      const Eigen::VectorXf series = Walk(150, &random);
      const ShapeletDistances result = extractor.Compute(series);
      const double flat = flat_fraction * StandardDeviation(series);
      for (std::size_t k = 0; k < shapelets.size(); ++k) {
        EXPECT_NEAR(result.distances[static_cast<Eigen::Index>(k)], DistanceByDefinition(series, shapelets[k], flat),
                    1e-5)
            << "shapelet " << k;
      }
    }
  }
}

TEST(FeatureExtractor, FindsAPlantedPatternWhereItIs) {
  Random random(2);
  for (const int dilation : {1, 2, 5}) {
    const Eigen::VectorXf pattern = Noise(12, &random);
    Eigen::VectorXf series = 0.01F * Noise(200, &random);
    for (int m = 0; m < 12; ++m) series[83 + m * dilation] += 5.0F * pattern[m];
    const ShapeletDistances result = FeatureExtractor({Pattern(pattern, dilation)}, 0.0).Compute(series);
    EXPECT_NEAR(result.distances[0], 0.0F, 1e-3F);
    EXPECT_EQ(result.match_start[0], 83);
    EXPECT_EQ(result.match_span[0], 11 * dilation + 1);
  }
}

TEST(FeatureExtractor, KeepsTheOrderOfTheShapelets) {
  Random random(3);
  std::vector<Shapelet> shapelets;
  for (const int length : {9, 4, 9, 30, 4, 9}) shapelets.push_back(Pattern(Walk(length, &random), 1 + length % 2));
  const Eigen::VectorXf series = Walk(120, &random);
  const ShapeletDistances together = FeatureExtractor(shapelets, 0.1).Compute(series);
  for (std::size_t k = 0; k < shapelets.size(); ++k) {
    const auto index = static_cast<Eigen::Index>(k);
    const ShapeletDistances alone = FeatureExtractor({shapelets[k]}, 0.1).Compute(series);
    EXPECT_NEAR(together.distances[index], alone.distances[0], 1e-6F);
    EXPECT_EQ(together.match_start[index], alone.match_start[0]);
    EXPECT_EQ(together.match_span[index], alone.match_span[0]);
  }
}

TEST(FeatureExtractor, ExtendsASeriesThatIsShorterThanAShapelet) {
  Random random(4);
  const Eigen::VectorXf series = Walk(20, &random);
  for (const Shapelet& shapelet : {Pattern(Walk(50, &random)), Pattern(Walk(12, &random), 3)}) {
    const int reach = (static_cast<int>(shapelet.values.size()) - 1) * shapelet.dilation + 1;
    const ShapeletDistances result = FeatureExtractor({shapelet}, 0.0).Compute(series);
    EXPECT_NEAR(result.distances[0], DistanceByDefinition(ExtendedTo(series, reach), shapelet, 0.0), 1e-5);
    EXPECT_EQ(result.match_start[0], 0);
    EXPECT_EQ(result.match_span[0], reach);
  }
}

TEST(FeatureExtractor, FlatWindowsNeverMatch) {
  Random random(5);
  Eigen::VectorXf series = 0.01F * Noise(200, &random);
  series.segment(90, 20).array() += 10.0F;
  // One of 180 windows of noise always resembles the pattern. It must not count.
  const Eigen::VectorXf noise = series.segment(20, 10);
  const ShapeletDistances gated = FeatureExtractor({Pattern(noise)}, 0.3).Compute(series);
  const ShapeletDistances open = FeatureExtractor({Pattern(noise)}, 0.0).Compute(series);
  EXPECT_EQ(open.match_start[0], 20);
  EXPECT_NEAR(open.distances[0], 0.0F, 1e-5F);
  EXPECT_GE(gated.match_start[0], 80);
  EXPECT_LT(gated.match_start[0], 110);
}

TEST(FeatureExtractor, AConstantSeriesMatchesNothing) {
  Random random(6);
  const ShapeletDistances result = FeatureExtractor({Pattern(Walk(9, &random)), Pattern(Walk(5, &random), 2)}, 0.3)
                                       .Compute(Eigen::VectorXf::Constant(50, 3.3F));
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(result.distances[k], 1.0F);
    EXPECT_EQ(result.match_start[k], -1);
    EXPECT_EQ(result.match_span[k], 0);
  }
}

TEST(FeatureExtractor, DistancesDoNotDependOnTheScaleAndOffsetOfTheForce) {
  Random random(7);
  const FeatureExtractor extractor({Pattern(Walk(15, &random)), Pattern(Walk(31, &random))}, 0.3);
  const Eigen::VectorXf series = Walk(100, &random);
  const Eigen::VectorXf other = (20.0F * series.array() + 50.0F).matrix();
  EXPECT_TRUE(extractor.Compute(series).distances.isApprox(extractor.Compute(other).distances, 1e-4F));
}

TEST(FeatureExtractor, RefusesFaultyInput) {
  Random random(8);
  EXPECT_THROW(FeatureExtractor({}, 0.0), std::invalid_argument);
  EXPECT_THROW(FeatureExtractor({{0, 1, Eigen::VectorXf::Ones(1)}}, 0.0), std::invalid_argument);
  EXPECT_THROW(FeatureExtractor({Pattern(Walk(9, &random), 0)}, 0.0), std::invalid_argument);
  const FeatureExtractor extractor({Pattern(Walk(9, &random))}, 0.0);
  EXPECT_THROW(extractor.Compute(Eigen::VectorXf(0)), std::invalid_argument);
  EXPECT_THROW(extractor.Compute(Eigen::VectorXf::Ones(1)), std::invalid_argument);
  Eigen::VectorXf series = Walk(30, &random);
  series[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(extractor.Compute(series), std::invalid_argument);
  series[7] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(extractor.Compute(series), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core

#include "core/stream/resampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/numerics/random.h"
#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

const Eigen::Vector3d kNoTare = Eigen::Vector3d::Zero();

std::vector<WrenchSample> Sampled(const Signal& signal, double begin, double end, double rate) {
  std::vector<WrenchSample> samples;
  for (int index = 0; begin + index / rate <= end + 1e-9; ++index) {
    const double time = begin + index / rate;
    samples.push_back({Time(time), AlongZ(signal(time))});
  }
  return samples;
}

TEST(ResampledMagnitude, IsExactForALineAtAnyRate) {
  const auto line = [](double time) { return 3.0 + 2.0 * time; };
  for (const double rate : {30.0, 100.0, 333.0, 1000.0}) {
    const Eigen::VectorXf force = ResampledMagnitude(Sampled(line, 0.0, 1.2, rate), 0, Time(1.0), 0.01, kNoTare);
    ASSERT_EQ(force.size(), 100);
    // The mean of a line over a period is its value in the middle.
    for (int index = 0; index < 100; ++index) EXPECT_NEAR(force[index], line(0.01 * (index + 0.5)), 1e-5);
  }
}

TEST(ResampledMagnitude, IsExactForALineSampledAtRandomTimes) {
  Random random(1);
  const auto line = [](double time) { return 50.0 - 7.0 * time; };
  std::vector<WrenchSample> samples = {{0, AlongZ(line(0.0))}};
  for (double time = 0.0; time < 2.1;) {
    time += random.Uniform(0.0005, 0.03);
    samples.push_back({Time(time), AlongZ(line(time))});
  }
  const Eigen::VectorXf force = ResampledMagnitude(samples, 0, Time(2.0), 0.02, kNoTare);
  for (int index = 0; index < 100; ++index) EXPECT_NEAR(force[index], line(0.02 * (index + 0.5)), 1e-4);
}

TEST(ResampledMagnitude, KeepsThePrecisionOfTodaysDate) {
  const Nanoseconds today = 1'700'000'000'000'000'000;
  std::vector<WrenchSample> samples;
  for (int index = 0; index <= 100; ++index) samples.push_back({today + index * 1'000'000, AlongZ(index)});
  const Eigen::VectorXf force = ResampledMagnitude(samples, today, today + 100'000'000, 0.01, kNoTare);
  for (int index = 0; index < 10; ++index) EXPECT_NEAR(force[index], 10.0 * index + 5.0, 1e-4);
}

TEST(ResampledMagnitude, BridgesAGapByAStraightLine) {
  const std::vector<WrenchSample> samples = {
      {Time(0.0), AlongZ(1.0)}, {Time(0.1), AlongZ(1.0)}, {Time(0.9), AlongZ(9.0)}, {Time(1.0), AlongZ(9.0)}};
  const Eigen::VectorXf force = ResampledMagnitude(samples, 0, Time(1.0), 0.1, kNoTare);
  ASSERT_EQ(force.size(), 10);
  EXPECT_NEAR(force[0], 1.0, 1e-5);
  for (int index = 1; index < 9; ++index) EXPECT_NEAR(force[index], index + 0.5, 1e-4);
  EXPECT_NEAR(force[9], 9.0, 1e-5);
}

TEST(ResampledMagnitude, SmoothsARateThatIsAboveItsOwn) {
  Random random(2);
  const Signal noise = [&random](double) { return 20.0 + random.Normal(); };
  const Eigen::VectorXf force = ResampledMagnitude(Sampled(noise, 0.0, 10.0, 1000.0), 0, Time(10.0), 0.01, kNoTare);
  const double deviation = std::sqrt((force.array() - force.mean()).square().mean());
  EXPECT_NEAR(deviation, 1.0 / std::sqrt(10.0), 0.05);
}

TEST(ResampledMagnitude, TakesAStreamWhoseRateChanges) {
  const auto line = [](double time) { return 10.0 * time; };
  std::vector<WrenchSample> samples = Sampled(line, 0.0, 0.995, 1000.0);
  for (const WrenchSample& slow : Sampled(line, 1.0, 2.0, 30.0)) samples.push_back(slow);
  const Eigen::VectorXf force = ResampledMagnitude(samples, 0, Time(1.9), 0.01, kNoTare);
  for (int index = 0; index < force.size(); ++index) EXPECT_NEAR(force[index], line(0.01 * (index + 0.5)), 1e-4);
}

TEST(ResampledMagnitude, HoldsTheForceBeforeTheFirstAndBehindTheLastSample) {
  const std::vector<WrenchSample> samples = {{Time(0.5), AlongZ(2.0)}, {Time(0.6), AlongZ(4.0)}};
  const Eigen::VectorXf force = ResampledMagnitude(samples, 0, Time(1.0), 0.1, kNoTare);
  for (int index = 0; index < 5; ++index) EXPECT_NEAR(force[index], 2.0, 1e-5);
  EXPECT_NEAR(force[5], 3.0, 1e-5);
  for (int index = 6; index < 10; ++index) EXPECT_NEAR(force[index], 4.0, 1e-5);
}

TEST(ResampledMagnitude, InterpolatesAcrossItsBeginning) {
  const auto line = [](double time) { return 30.0 + 10.0 * time; };
  const Eigen::VectorXf force = ResampledMagnitude(Sampled(line, -1.005, 1.0, 100.0), 0, Time(0.9), 0.03, kNoTare);
  for (int index = 0; index < 30; ++index) EXPECT_NEAR(force[index], line(0.03 * (index + 0.5)), 1e-4);
}

TEST(ResampledMagnitude, SubtractsTheTareBeforeTheMagnitude) {
  const std::vector<WrenchSample> samples = {{0, Eigen::Vector3d(4.0, 0.0, 5.0)},
                                             {Time(1.0), Eigen::Vector3d(4.0, 0.0, 5.0)}};
  const Eigen::VectorXf force = ResampledMagnitude(samples, 0, Time(1.0), 0.5, Eigen::Vector3d(1.0, 0.0, 1.0));
  ASSERT_EQ(force.size(), 2);
  EXPECT_FLOAT_EQ(force[0], 5.0F);
}

TEST(ResampledMagnitude, HasAsManyValuesAsPeriodsFit) {
  const std::vector<WrenchSample> samples = {{0, AlongZ(1.0)}};
  EXPECT_EQ(ResampledMagnitude(samples, 0, Time(1.0), 0.1, kNoTare).size(), 10);  // 0.1 has no exact double
  EXPECT_EQ(ResampledMagnitude(samples, 0, Time(0.99), 0.1, kNoTare).size(), 9);
  EXPECT_EQ(ResampledMagnitude(samples, 0, Time(0.05), 0.1, kNoTare).size(), 0);
  EXPECT_EQ(ResampledMagnitude(samples, 0, Time(-1.0), 0.1, kNoTare).size(), 0);
}

TEST(ResampledMagnitude, RefusesNoSampleAndNoPeriod) {
  EXPECT_THROW(ResampledMagnitude({}, 0, Time(1.0), 0.1, kNoTare), std::invalid_argument);
  EXPECT_THROW(ResampledMagnitude({{0, AlongZ(1.0)}}, 0, Time(1.0), 0.0, kNoTare), std::invalid_argument);
  EXPECT_THROW(ResampledMagnitude({{0, AlongZ(1.0)}}, 0, Time(1.0), std::nan(""), kNoTare), std::invalid_argument);
}

TEST(MeanForce, CountsTheSamplesFromBeginToEnd) {
  const std::vector<WrenchSample> samples = {{1, AlongZ(1.0)}, {2, AlongZ(2.0)}, {3, AlongZ(6.0)}, {4, AlongZ(100.0)}};
  EXPECT_TRUE(MeanForce(samples, 1, 3).isApprox(AlongZ(3.0)));
  EXPECT_TRUE(MeanForce(samples, 5, 9).isZero());
  EXPECT_TRUE(MeanForce({}, 0, 9).isZero());
}

}  // namespace
}  // namespace contact_shapelets::core

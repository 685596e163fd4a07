#include "core/numerics/series.h"

#include <gtest/gtest.h>

namespace contact_shapelets::core {
namespace {

Eigen::VectorXf Ramp(int count) { return Eigen::VectorXf::LinSpaced(count, 0.0F, static_cast<float>(count - 1)); }

TEST(ZNormalised, HasMeanZeroAndPopulationDeviationOne) {
  const Eigen::VectorXf normalised = ZNormalised((Ramp(10).array() * 3.0F + 1000.0F).matrix());
  EXPECT_NEAR(normalised.mean(), 0.0F, 1e-6F);
  EXPECT_NEAR(normalised.squaredNorm() / 10.0F, 1.0F, 1e-5F);
}

TEST(ZNormalised, GivesZerosForAConstantSeries) {
  EXPECT_TRUE(ZNormalised(Eigen::VectorXf::Constant(7, 12345.678F)).isZero());
}

TEST(ZNormalised, DoesNotDependOnTheUnit) {
  const Eigen::VectorXf series = Ramp(10);
  for (const float scale : {1e-12F, 1e-6F, 1e12F}) {
    EXPECT_TRUE(ZNormalised(scale * series).isApprox(ZNormalised(series), 1e-5F)) << scale;
  }
}

TEST(ZNormalised, GivesZerosForOneValueAndForZeros) {
  EXPECT_TRUE(ZNormalised(Eigen::VectorXf::Ones(1)).isZero());
  EXPECT_TRUE(ZNormalised(Eigen::VectorXf::Zero(5)).isZero());
}

TEST(StandardDeviation, IsThePopulationsAndKeepsItsDigitsFarFromZero) {
  EXPECT_DOUBLE_EQ(StandardDeviation(Eigen::Vector4f(1.0F, 3.0F, 1.0F, 3.0F)), 1.0);
  EXPECT_DOUBLE_EQ(StandardDeviation(Eigen::Vector2f(1000001.0F, 1000003.0F)), 1.0);
  EXPECT_EQ(StandardDeviation(Eigen::VectorXf::Ones(1)), 0.0);
}

TEST(StretchedTo, TakesSeriesOfOneValueAndLengthsOfOne) {
  EXPECT_EQ(StretchedTo(Ramp(5), 1)[0], 0.0F);
  EXPECT_EQ(StretchedTo(Eigen::VectorXf::Constant(1, 7.0F), 4), Eigen::VectorXf::Constant(4, 7.0F));
  EXPECT_EQ(StretchedTo(Ramp(5), 5), Ramp(5));
}

TEST(StretchedTo, EndsAtTheLastValueForEveryLength) {
  for (int length = 2; length < 300; ++length) EXPECT_FLOAT_EQ(StretchedTo(Ramp(101), length)[length - 1], 100.0F);
}

TEST(StretchedTo, KeepsTheEndsAndInterpolatesLinearly) {
  const Eigen::VectorXf stretched = StretchedTo(Ramp(5), 9);
  for (int index = 0; index < 9; ++index) EXPECT_NEAR(stretched[index], 0.5F * static_cast<float>(index), 1e-6F);
}

TEST(ExtendedTo, RepeatsTheLastValue) {
  const Eigen::VectorXf extended = ExtendedTo(Ramp(3), 5);
  EXPECT_EQ(extended[3], 2.0F);
  EXPECT_EQ(extended[4], 2.0F);
  EXPECT_EQ(ExtendedTo(Ramp(3), 2).size(), 3);
}

TEST(EveryNth, TakesEachPhaseOnce) {
  EXPECT_EQ(EveryNth(Ramp(7), 0, 3).size(), 3);
  EXPECT_EQ(EveryNth(Ramp(7), 1, 3).size(), 2);
  EXPECT_EQ(EveryNth(Ramp(7), 1, 3)[1], 4.0F);
  EXPECT_EQ(EveryNth(Ramp(7), 2, 1).size(), 5);
}

TEST(EveryNth, OfAllPhasesHoldsEveryValueOnce) {
  float sum = 0.0F;
  for (int phase = 0; phase < 4; ++phase) sum += EveryNth(Ramp(11), phase, 4).sum();
  EXPECT_EQ(sum, 55.0F);
  EXPECT_EQ(EveryNth(Ramp(3), 2, 9).size(), 1);
}

TEST(MedianLength, OfAnOddNumberIsTheMiddleOne) {
  EXPECT_EQ(MedianLength({Ramp(9), Ramp(4), Ramp(5)}), 5);
  EXPECT_EQ(MedianLength({Ramp(3)}), 3);
}

TEST(MedianLength, IsTheLowerOfTwo) { EXPECT_EQ(MedianLength({Ramp(4), Ramp(9), Ramp(5), Ramp(7)}), 5); }

}  // namespace
}  // namespace contact_shapelets::core

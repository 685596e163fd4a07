#include "contact_shapelets/core/series.h"

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

TEST(MedianLength, IsTheLowerOfTwo) { EXPECT_EQ(MedianLength({Ramp(4), Ramp(9), Ramp(5), Ramp(7)}), 5); }

}  // namespace
}  // namespace contact_shapelets::core

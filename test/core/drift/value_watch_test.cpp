#include "core/drift/value_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

const double kLimit = std::log(100.0);

TEST(ValueWatch, BetsOnTheSideOfTheChange) {
  Random random(1);
  std::vector<double> training(100);
  for (double& value : training) value = random.Normal();
  ValueWatch watch(training);
  for (int episode = 0; episode < 30; ++episode) watch.Append(random.Normal() - 3.0, random.Uniform());
  EXPECT_GT(watch.smaller().LogEvidence(), kLimit);
  EXPECT_LT(watch.greater().LogEvidence(), 0.0);
}

TEST(ValueWatch, HasNoEvidenceInEqualValues) {
  Random random(2);
  ValueWatch watch(std::vector<double>(50, 4.0));
  for (int episode = 0; episode < 1000; ++episode) watch.Append(4.0, random.Uniform());
  EXPECT_LT(watch.smaller().LogEvidence(), kLimit);
  EXPECT_LT(watch.greater().LogEvidence(), kLimit);
}

TEST(ValueWatch, NeedsNoTraining) {
  Random random(3);
  ValueWatch watch({});
  for (int episode = 0; episode < 200; ++episode) watch.Append(random.Normal(), random.Uniform());
  EXPECT_LT(watch.greater().LogEvidence(), kLimit);
  for (int episode = 0; episode < 50; ++episode) watch.Append(random.Normal() + 3.0, random.Uniform());
  EXPECT_GT(watch.greater().LogEvidence(), kLimit);
  EXPECT_NEAR(static_cast<double>(watch.greater().LikelyStart()), 200.0, 5.0);
}

TEST(ValueWatch, TakesTheSmallestRandomNumber) {
  ValueWatch watch({});
  watch.Append(1.0, 0.0);
  EXPECT_TRUE(std::isfinite(watch.greater().LogEvidence()));
  EXPECT_TRUE(std::isfinite(watch.smaller().LogEvidence()));
}

}  // namespace
}  // namespace contact_shapelets::core

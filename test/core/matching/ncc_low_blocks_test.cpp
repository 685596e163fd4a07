#include "core/matching/ncc_low_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/numerics/random.h"
#include "core/planted_series.h"

namespace contact_shapelets::core {
namespace {

constexpr int kShapelets = 18;

struct Case {
  std::string name;
  Eigen::VectorXf series;
  int length;
  double flat_deviation;
  float step;  ///< standard deviation of a shapelet's value from step to step
};

void PrintTo(const Case& value, std::ostream* stream) { *stream << value.name; }

Eigen::VectorXf Noise(Eigen::Index count, double amplitude, std::uint64_t seed) {
  Random random(seed);
  return Eigen::VectorXf::NullaryExpr(count, [&] { return static_cast<float>(amplitude * random.Normal()); });
}

Eigen::VectorXf Walk(Eigen::Index count, std::uint64_t seed) {
  Eigen::VectorXf walk = Noise(count, 1.0, seed);
  for (Eigen::Index index = 1; index < count; ++index) walk[index] += walk[index - 1];
  return walk;
}

/// Returns a force that rises, gives way and rests, several times.
Eigen::VectorXf Pushes(Eigen::Index count, std::uint64_t seed) {
  Eigen::VectorXf force = Noise(count, 0.02, seed);
  for (Eigen::Index index = 0; index < count; ++index) {
    const auto phase = static_cast<double>(index % 180);
    if (phase < 60.0) force[index] += static_cast<float>(phase / 6.0);
    if (phase >= 60.0 && phase < 100.0) force[index] += 4.0F;
  }
  return force;
}

Eigen::VectorXf Plateaus(Eigen::Index count, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXf values(count);
  float level = 0.0F;
  for (Eigen::Index index = 0; index < count; ++index) {
    if (index % 70 == 0) level = static_cast<float>(random.Normal());
    values[index] = level;
  }
  return values + Noise(count, 1e-3, seed + 1);
}

/// Returns a series with three stretches of windows that are not flat.
Eigen::VectorXf Gaps() {
  Eigen::VectorXf series = Noise(1500, 0.01, 3);
  series.segment(100, 200) += Walk(200, 4);
  series.segment(700, 90) += Walk(90, 5);
  series.segment(1200, 200) += Walk(200, 6);
  return series;
}

/// Returns a series with windows that are tiny beside their surroundings: these need double precision.
Eigen::VectorXf FineStructure() {
  Eigen::VectorXf series = Noise(500, 1e-4, 23);
  series.segment(150, 60) += 10.0F * Walk(60, 24);
  return series;
}

std::vector<Case> Cases() {
  return {{"Walk", Walk(433, 1), 86, 0.0, 0.01F},
          {"LongShapelets", Walk(433, 2), 346, 0.0, 0.01F},
          {"ShortShapelets", Walk(433, 7), 40, 0.0, 0.01F},
          {"Pushes", Pushes(433, 8), 120, 0.3, 0.01F},
          {"Plateaus", Plateaus(700, 9), 64, 0.02, 0.01F},
          {"Gaps", Gaps(), 50, 0.3, 0.01F},
          {"FineStructure", FineStructure(), 48, 0.0, 0.01F},
          {"Noise", Noise(433, 1.0, 10), 80, 0.0, 0.01F},
          {"TinySteps", Walk(433, 11), 129, 0.0, 1e-4F},
          {"WideSteps", Walk(433, 12), 129, 0.0, 0.1F},
          {"FastWalk", Walk(433, 14), 40, 0.0, 0.03F},
          {"FastPushes", Pushes(433, 15), 60, 0.3, 0.03F},
          {"FastNoise", Noise(433, 1.0, 16), 40, 0.0, 0.03F},
          {"WholeSeries", Walk(200, 13), 200, 0.0, 0.01F}};
}

/// Shapelets that move as those of a learner do: the direction of their steps changes slowly. Most resemble parts of
/// the series, some do not, and one is constant.
class MovingShapelets {
 public:
  explicit MovingShapelets(const Case& data) : random_(77), step_(data.step) {
    values_ = Eigen::MatrixXf(kShapelets, data.length);
    for (int k = 0; k < kShapelets; ++k) {
      const int first = static_cast<int>(random_.Uniform() * static_cast<double>(data.series.size() - data.length));
      const Eigen::VectorXf part = data.series.segment(first, data.length);
      const Eigen::VectorXf other = Walk(data.length, 100 + static_cast<std::uint64_t>(k));
      const float scale = std::max(1e-6F, (part.array() - part.mean()).matrix().norm());
      const float likeness = k % 4 == 1 ? 0.0F : 1.0F;
      values_.row(k) =
          (likeness * part / scale + 0.3F * other / other.norm()).transpose() * std::sqrt(1.0F * data.length);
    }
    values_.row(3).setConstant(2.0F);
    direction_ = Eigen::MatrixXf::Zero(kShapelets, data.length);
  }

  const Eigen::MatrixXf& values() const { return values_; }

  void Step() {
    for (Eigen::Index index = 0; index < values_.size(); ++index) {
      direction_(index) = 0.8F * direction_(index) + 0.6F * static_cast<float>(random_.Normal());
    }
    direction_.row(3).setZero();
    values_ += step_ * direction_;
  }

 private:
  Random random_;
  float step_;
  Eigen::MatrixXf values_;
  Eigen::MatrixXf direction_;
};

void ExpectEqual(const std::vector<Match>& expected, const std::vector<Match>& found) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    SCOPED_TRACE("shapelet " + std::to_string(k));
    EXPECT_EQ(found[k].similarity, expected[k].similarity);
    EXPECT_EQ(found[k].window, expected[k].window);
    EXPECT_EQ(found[k].shift, expected[k].shift);
  }
}

int CountRenewed(const LowBlocks& low_blocks) {
  return static_cast<int>(std::count_if(low_blocks.noted.begin(), low_blocks.noted.end(),
                                        [](const LowBlocks::Noted& noted) { return noted.renewed; }));
}

class Again : public testing::TestWithParam<Case> {};

TEST_P(Again, FindsTheMatchesOfASearchOfEverything) {
  const WindowSet windows(GetParam().series, GetParam().length, GetParam().flat_deviation);
  for (const tile::Loops& loops : RunnableLoops()) {
    SCOPED_TRACE(loops.name);
    MovingShapelets moving(GetParam());
    ShapeletHistory history;
    LowBlocks low_blocks;
    SearchMemory memory;
    std::vector<Match> expected;
    std::vector<Match> found;
    int known = 0;
    for (int step = 0; step < 60; ++step, moving.Step()) {
      const ShapeletSet shapelets(moving.values());
      history.Add(shapelets);
      if (step % 7 == 3) continue;
      FindBestMatchesWith(loops, windows, shapelets, expected, Pruning::kByBounds, &memory, &expected);
      FindBestMatchesAgain(loops, windows, shapelets, Pruning::kByBounds, history, &memory, &low_blocks, &found);
      ExpectEqual(expected, found);
      known += kShapelets - 1 - CountRenewed(low_blocks);
    }
    EXPECT_TRUE(known > 0 || GetParam().step > 0.05F);
  }
}

INSTANTIATE_TEST_SUITE_P(Series, Again, testing::ValuesIn(Cases()),
                         [](const testing::TestParamInfo<Case>& info) { return info.param.name; });

/// A series that has been searched once.
class LowBlocksOfAWalk : public testing::Test {
 protected:
  LowBlocksOfAWalk() { SearchFor(moving_.values()); }

  void SearchFor(const Eigen::MatrixXf& values) {
    const ShapeletSet shapelets(values);
    history_.Add(shapelets);
    FindBestMatchesAgain(windows_, shapelets, history_, &low_blocks_, &matches_);
  }

  const Case data_{"", Walk(433, 21), 129, 0.0, 1e-3F};
  const WindowSet windows_{data_.series, data_.length, 0.0};
  MovingShapelets moving_{data_};
  ShapeletHistory history_;
  LowBlocks low_blocks_;
  std::vector<Match> matches_;
};

TEST_F(LowBlocksOfAWalk, AreNotedOnlyBySearchesOfEverything) {
  EXPECT_EQ(CountRenewed(low_blocks_), kShapelets - 1);
  const std::vector<tile::BlockBits> noted = low_blocks_.blocks;
  EXPECT_GT(std::count_if(noted.begin(), noted.end(), [](tile::BlockBits bits) { return bits != 0; }), 0);
  moving_.Step();
  SearchFor(moving_.values());
  EXPECT_EQ(CountRenewed(low_blocks_), 0);
  EXPECT_EQ(low_blocks_.blocks, noted);
}

TEST_F(LowBlocksOfAWalk, AreNotSearched) {
  // All partial overlaps are marked low, and the hints are full overlaps.
  std::fill(low_blocks_.blocks.begin(), low_blocks_.blocks.end(), static_cast<tile::BlockBits>(0xFFFF));
  const std::vector<Match> best = matches_;
  for (LowBlocks::Noted& noted : low_blocks_.noted) noted.most = -4.0F;
  for (Match& match : matches_) match.shift = 0;
  SearchFor(moving_.values());
  int partial = 0;
  for (std::size_t k = 0; k < best.size(); ++k) {
    EXPECT_EQ(matches_[k].shift, 0);
    partial += best[k].shift != 0 ? 1 : 0;
  }
  EXPECT_GT(partial, 0);
}

TEST_F(LowBlocksOfAWalk, AreNotedAnewAfterABigStep) {
  SearchFor(-moving_.values());
  EXPECT_EQ(CountRenewed(low_blocks_), kShapelets - 1);
}

TEST_F(LowBlocksOfAWalk, AreNotedAnewOfTheShapeletsThatMoved) {
  Eigen::MatrixXf values = moving_.values();
  values.row(5) = Walk(data_.length, 500).transpose();
  SearchFor(values);
  for (std::size_t k = 0; k < low_blocks_.noted.size(); ++k) EXPECT_EQ(low_blocks_.noted[k].renewed, k == 5) << k;
}

TEST(ShapeletHistory, KnowsHowFarShapeletsHaveMoved) {
  ShapeletHistory history;
  Eigen::MatrixXf values = Eigen::MatrixXf::Zero(2, 4);
  values.row(0) << 1.0F, -1.0F, 1.0F, -1.0F;
  values.row(1) << 1.0F, -1.0F, 1.0F, -1.0F;
  history.Add(ShapeletSet(values));
  values.row(1) << -1.0F, 1.0F, -1.0F, 1.0F;
  history.Add(ShapeletSet(values));
  EXPECT_EQ(history.step(), 1);
  EXPECT_FLOAT_EQ(history.Moved(0, 0), 0.0F);
  EXPECT_FLOAT_EQ(history.Moved(0, 1), 2.0F);
  EXPECT_FLOAT_EQ(history.Moved(1, 1), 0.0F);
  EXPECT_GT(history.Moved(-1, 0), 2.0F);
  for (int step = 0; step < 100; ++step) history.Add(ShapeletSet(values));
  EXPECT_GT(history.Moved(0, 0), 2.0F);
  EXPECT_FLOAT_EQ(history.Moved(history.step() - 1, 0), 0.0F);
}

}  // namespace
}  // namespace contact_shapelets::core

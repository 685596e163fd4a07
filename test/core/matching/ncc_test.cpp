#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/matching/ncc_fftw.h"
#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_search.h"
#include "core/numerics/random.h"
#include "core/planted_series.h"

namespace contact_shapelets::core {
namespace {

constexpr float kTolerance = 1e-5F;

struct Case {
  std::string name;
  Eigen::VectorXf series;
  Eigen::MatrixXf shapelets;
  double flat_deviation = 0.0;
};

void PrintTo(const Case& value, std::ostream* stream) { *stream << value.name; }

Eigen::VectorXf RandomWalk(int count, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXf walk(count);
  double sum = 0.0;
  for (int index = 0; index < count; ++index) walk[index] = static_cast<float>(sum += random.Normal());
  return walk;
}

Eigen::MatrixXf RandomWalks(int count, int length, std::uint64_t seed) {
  Eigen::MatrixXf walks(count, length);
  for (int row = 0; row < count; ++row) walks.row(row) = RandomWalk(length, 1000 * seed + row).transpose();
  return walks;
}

Eigen::VectorXf Noise(int count, double amplitude, std::uint64_t seed) {
  Random random(seed);
  return Eigen::VectorXf::NullaryExpr(count, [&] { return static_cast<float>(amplitude * random.Normal()); });
}

Case WalkCase(int samples, int length, int shapelets) {
  return {"Walk" + std::to_string(samples) + "Length" + std::to_string(length), RandomWalk(samples, 7),
          RandomWalks(shapelets, length, 3)};
}

Case OffsetCase(const std::string& name, float offset) {
  return {name, (RandomWalk(300, 11).array() + offset).matrix(), RandomWalks(5, 40, 5)};
}

/// Windows of one period tie with those of the next to the last digits.
Case PeriodicCase() {
  Eigen::VectorXf series(240);
  for (int q = 0; q < 240; ++q) series[q] = static_cast<float>(std::sin(2.0 * M_PI * (q % 24) / 24.0));
  Eigen::MatrixXf shapelets(2, 24);
  shapelets.row(0) = series.segment(5, 24).transpose();
  shapelets.row(1) = -series.segment(0, 24).transpose();
  return {"Periodic", series, shapelets};
}

Case SpikeCase() {
  Eigen::VectorXf series = Noise(300, 1.0, 21);
  series[40] = 1e6F;
  series[200] = -3e5F;
  return {"Spikes", series, RandomWalks(5, 32, 9)};
}

/// A fine structure of 1e-4 beside a movement of 100. No window is flat, but most are tiny beside the series.
Case FineStructureCase() {
  Eigen::VectorXf series = Noise(400, 1e-4, 23);
  series.segment(150, 60) += 10.0F * RandomWalk(60, 24);
  return {"FineStructure", series, RandomWalks(6, 24, 25)};
}

Case StepCase() {
  Eigen::VectorXf series = Eigen::VectorXf::Constant(200, 3.1F);
  series.tail(90).setConstant(7.7F);
  return {"Step", series, RandomWalks(4, 30, 27)};
}

Case FlatCase() {
  Eigen::VectorXf series = Noise(400, 0.01, 29);
  series.segment(100, 120) += RandomWalk(120, 30);
  return {"MostlyFlat", series, RandomWalks(5, 50, 31), 0.3};
}

/// Three movements with flat gaps between them, a long one and a short one. Shapelets match in the first and the last.
Case FlatGapsCase() {
  Eigen::VectorXf series = Noise(900, 0.01, 51);
  series.segment(60, 50) += RandomWalk(50, 52);
  series.segment(400, 40) += RandomWalk(40, 53);
  series.segment(470, 90) += RandomWalk(90, 54);
  Eigen::MatrixXf shapelets = RandomWalks(7, 20, 55);
  shapelets.row(2) = series.segment(80, 20).transpose();
  shapelets.row(5) = series.segment(500, 20).transpose();
  return {"FlatGaps", series, shapelets, 0.3};
}

Case ConstantShapeletCase() {
  Eigen::MatrixXf shapelets = RandomWalks(6, 20, 33);
  shapelets.row(0).setConstant(4.2F);
  shapelets.row(3).setConstant(-1e5F);
  return {"ConstantShapelets", RandomWalk(150, 34), shapelets};
}

/// Shapelets cut from the series: matches are exact, and nearly everything else is pruned.
Case CutOutCase() {
  Random random(35);
  const Eigen::VectorXf series = PlantedSeries(1, 300, &random);
  Eigen::MatrixXf shapelets(5, 45);
  for (int row = 0; row < 5; ++row) shapelets.row(row) = series.segment(50 * row, 45).transpose();
  return {"CutOut", series, shapelets};
}

/// The ends of shapelets match the first or the last samples of the series, at a far shift.
Case FarShiftCase() {
  Eigen::VectorXf series = Noise(120, 0.2, 37);
  series.head(6) += Eigen::VectorXf::LinSpaced(6, 9.0F, 4.0F);
  series.tail(5).array() += 8.0F;
  Eigen::MatrixXf shapelets(4, 60);
  for (int row = 0; row < 4; ++row) shapelets.row(row) = Noise(60, 0.2, 38 + row).transpose();
  shapelets.row(0).tail(6) += Eigen::RowVectorXf::LinSpaced(6, 9.0F, 4.0F);
  shapelets.row(1).head(5).array() += 8.0F;
  shapelets.row(2).head(30).array() += 2.0F;
  return {"FarShift", series, shapelets};
}

std::vector<Case> Cases() {
  std::vector<Case> cases{WalkCase(433, 2, 5),   WalkCase(433, 3, 3),    WalkCase(433, 16, 19), WalkCase(433, 64, 19),
                          WalkCase(433, 200, 6), WalkCase(433, 432, 2),  WalkCase(433, 433, 3), WalkCase(64, 63, 1),
                          WalkCase(2, 2, 1),     WalkCase(20000, 40, 2), WalkCase(5000, 300, 1)};
  cases.push_back(OffsetCase("Offset1e4", 1e4F));
  cases.push_back(OffsetCase("OffsetMinus1e5", -1e5F));
  cases.push_back(OffsetCase("Offset1e6", 1e6F));
  cases.push_back({"TinyVariance", 1e-6F * RandomWalk(300, 15), 1e-7F * RandomWalks(5, 40, 17)});
  cases.push_back({"WhiteNoise", Noise(433, 1.0, 19), RandomWalks(5, 80, 20)});
  cases.push_back(PeriodicCase());
  cases.push_back(SpikeCase());
  cases.push_back(FineStructureCase());
  cases.push_back(StepCase());
  cases.push_back(FlatCase());
  cases.push_back(FlatGapsCase());
  cases.push_back(ConstantShapeletCase());
  cases.push_back(CutOutCase());
  cases.push_back(FarShiftCase());
  return cases;
}

std::string NameOf(const testing::TestParamInfo<Case>& info) { return info.param.name; }

/// Returns CC_w of one window by equation 2, z-normalised here.
double CrossCorrelation(const Case& data, Eigen::Index shapelet, int window, int shift) {
  const auto length = static_cast<int>(data.shapelets.cols());
  const auto normalised = [](const Eigen::VectorXd& values) {
    const Eigen::ArrayXd centred = values.array() - values.mean();
    return Eigen::VectorXd((centred / std::sqrt(centred.square().mean())).matrix());
  };
  const Eigen::VectorXd s = normalised(data.shapelets.row(shapelet).transpose().cast<double>());
  const Eigen::VectorXd t = normalised(data.series.segment(window, length).cast<double>());
  const int overlap = length - std::abs(shift);
  return (shift >= 0 ? s.head(overlap).dot(t.tail(overlap)) : s.tail(overlap).dot(t.head(overlap))) / length;
}

void ExpectSameMatches(const Case& data, const std::vector<Match>& expected, const std::vector<Match>& found) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    SCOPED_TRACE("shapelet " + std::to_string(k));
    EXPECT_NEAR(found[k].similarity, expected[k].similarity, kTolerance);
    ASSERT_EQ(found[k].window < 0, expected[k].window < 0);
    if (found[k].window < 0) continue;
    EXPECT_NEAR(CrossCorrelation(data, static_cast<Eigen::Index>(k), found[k].window, found[k].shift),
                found[k].similarity, kTolerance);
  }
}

class BestMatch : public testing::TestWithParam<Case> {
 protected:
  const Case& data() const { return GetParam(); }
  const WindowSet windows_{data().series, static_cast<int>(data().shapelets.cols()), data().flat_deviation};
  const ShapeletSet shapelets_{data().shapelets};
  const std::vector<Match> expected_ = BestMatchesByDefinition(windows_, shapelets_);

  void ExpectFound(const std::vector<Match>& hints, Pruning pruning) {
    for (const tile::Loops& loops : RunnableLoops()) {
      SCOPED_TRACE(loops.name);
      std::vector<Match> found;
      SearchMemory memory;
      FindBestMatchesWith(loops, windows_, shapelets_, hints, pruning, &memory, &found);
      ExpectSameMatches(data(), expected_, found);
    }
  }
};

TEST_P(BestMatch, OfTheDefinitionIsAtItsWindowAndShift) { ExpectSameMatches(data(), expected_, expected_); }

TEST_P(BestMatch, ByFftwIsThatOfTheDefinition) {
  FftwMatcher matcher(shapelets_);
  ExpectSameMatches(data(), expected_, matcher.BestMatches(windows_));
}

TEST_P(BestMatch, OfTheUnprunedKernelIsThatOfTheDefinition) { ExpectFound({}, Pruning::kNone); }

TEST_P(BestMatch, OfTheKernelPrunedByEnergyIsThatOfTheDefinition) { ExpectFound({}, Pruning::kByEnergy); }

TEST_P(BestMatch, OfTheKernelPrunedByBoundsIsThatOfTheDefinition) { ExpectFound({}, Pruning::kByBounds); }

TEST_P(BestMatch, IsTheSameFromPerfectHints) {
  ExpectFound(expected_, Pruning::kByEnergy);
  ExpectFound(expected_, Pruning::kByBounds);
}

TEST_P(BestMatch, IsTheSameFromPoorHints) {
  std::vector<Match> hints = expected_;
  const int last = windows_.window_count() - 1;
  for (std::size_t k = 0; k < hints.size(); ++k) {
    // The kernel must not believe the similarity of a hint, which may be that of another shapelet.
    hints[k] = {1.0F, k % 2 == 0 ? 0 : last, k % 3 == 0 ? 0 : windows_.length() - 1};
  }
  ExpectFound(hints, Pruning::kByEnergy);
  ExpectFound(hints, Pruning::kByBounds);
}

INSTANTIATE_TEST_SUITE_P(Hard, BestMatch, testing::ValuesIn(Cases()), NameOf);

TEST(WindowSet, HasTheMeansAndDeviationsOfItsWindowsBesideALargeOffset) {
  const Eigen::VectorXf series = (RandomWalk(500, 41).array() + 1e6F).matrix();
  const WindowSet windows(series, 30, 0.0);
  for (int window = 0; window < windows.window_count(); ++window) {
    const Eigen::ArrayXd values = series.segment(window, 30).cast<double>().array();
    EXPECT_NEAR(windows.mean()[window], values.mean(), 1e-7);
    EXPECT_NEAR(1.0 / windows.inverse_deviation()[window], std::sqrt((values - values.mean()).square().mean()), 1e-6);
  }
}

TEST(WindowSet, LeavesOutFlatWindowsOnly) {
  Eigen::VectorXf series = Eigen::VectorXf::Zero(100);
  series[50] = 10.0F;
  const WindowSet windows(series, 10, 0.1);
  EXPECT_EQ(windows.usable_window_count(), 10);
  for (int window = 0; window < windows.window_count(); ++window) {
    EXPECT_EQ(windows.IsFlat(window), window <= 40 || window > 50) << window;
  }
}

TEST(WindowSet, HasAllWindowsThatAreNotFlatInStretchesWithoutLongFlatParts) {
  Eigen::VectorXf series = Eigen::VectorXf::Zero(4000);
  for (const int spike : {50, 90, 1000, 3900}) series[spike] = 10.0F;
  series.segment(1500, 2000) = RandomWalk(2000, 56);
  const WindowSet windows(series, 10, 0.1);
  std::vector<bool> in_stretch(static_cast<std::size_t>(windows.window_count()), false);
  int end = 0;
  for (const WindowStretch& stretch : windows.stretches()) {
    EXPECT_GE(stretch.first, end);
    end = stretch.first + stretch.count;
    ASSERT_LE(end, windows.window_count());
    EXPECT_FALSE(windows.IsFlat(stretch.first));
    EXPECT_FALSE(windows.IsFlat(end - 1));
    std::fill(in_stretch.begin() + stretch.first, in_stretch.begin() + end, true);
  }
  for (int window = 0; window < windows.window_count(); ++window) {
    EXPECT_TRUE(in_stretch[static_cast<std::size_t>(window)] || windows.IsFlat(window)) << window;
  }
  EXPECT_FALSE(in_stretch[500]);
  EXPECT_FALSE(in_stretch[1200]);
  EXPECT_TRUE(WindowSet(Eigen::VectorXf::Zero(50), 10, 0.1).stretches().empty());
}

TEST(WindowSet, KeepsNothingOfTheSeriesBefore) {
  WindowSet windows(RandomWalk(500, 61), 40, 0.0);
  const Eigen::VectorXf series = Noise(120, 1.0, 62);
  windows.Assign(series, 15, 0.9);
  const WindowSet expected(series, 15, 0.9);
  EXPECT_EQ(windows.length(), expected.length());
  EXPECT_EQ(windows.usable_window_count(), expected.usable_window_count());
  EXPECT_EQ(windows.stretches().size(), expected.stretches().size());
  EXPECT_EQ(windows.series(), expected.series());
  EXPECT_EQ(windows.mean(), expected.mean());
  EXPECT_EQ(windows.inverse_deviation(), expected.inverse_deviation());
}

TEST(WindowSet, RefusesInvalidInput) {
  const Eigen::VectorXf series = RandomWalk(10, 1);
  EXPECT_THROW(WindowSet(series, 11, 0.0), std::invalid_argument);
  EXPECT_THROW(WindowSet(series, 1, 0.0), std::invalid_argument);
  Eigen::VectorXf broken = series;
  broken[4] = std::nanf("");
  EXPECT_THROW(WindowSet(broken, 3, 0.0), std::invalid_argument);
}

TEST(BestMatchesByDefinition, FindsAPlantedShapeletWhereItIs) {
  Eigen::VectorXf series = Noise(200, 0.01, 43);
  const Eigen::VectorXf shapelet = RandomWalk(25, 44);
  series.segment(70, 25) = (3.0F * shapelet.array() + 5.0F).matrix();
  const Match match = BestMatchesByDefinition(WindowSet(series, 25, 0.0), ShapeletSet(shapelet.transpose()))[0];
  EXPECT_NEAR(match.similarity, 1.0F, 1e-5F);
  EXPECT_EQ(match.window, 70);
  EXPECT_EQ(match.shift, 0);
}

TEST(BestMatchesByDefinition, CountsOnlyTheOverlapOfAShiftedWindow) {
  // Both are z-normalised. The second half of one equals the first half of the other.
  const Eigen::Vector4f series(-1.0F, 1.0F, 1.0F, -1.0F);
  const Eigen::RowVector4f shapelet(1.0F, -1.0F, -1.0F, 1.0F);
  const Match match = BestMatchesByDefinition(WindowSet(series, 4, 0.0), ShapeletSet(shapelet))[0];
  EXPECT_FLOAT_EQ(match.similarity, 0.5F);
  EXPECT_EQ(std::abs(match.shift), 2);
}

TEST(FindBestMatches, MatchesNothingInAFlatSeries) {
  const WindowSet windows(Eigen::VectorXf::Constant(50, 2.0F), 10, 0.0);
  std::vector<Match> matches;
  FindBestMatches(windows, ShapeletSet(RandomWalks(3, 10, 45)), {}, {}, &matches);
  ASSERT_EQ(matches.size(), 3U);
  for (const Match& match : matches) {
    EXPECT_EQ(match.window, -1);
    EXPECT_EQ(match.similarity, -1.0F);
  }
}

TEST(FindBestMatches, RefusesLengthsAndCountsThatDiffer) {
  const WindowSet windows(RandomWalk(50, 46), 10, 0.0);
  std::vector<Match> matches;
  EXPECT_THROW(FindBestMatches(windows, ShapeletSet(RandomWalks(2, 9, 47)), {}, {}, &matches), std::invalid_argument);
  EXPECT_THROW(FindBestMatches(windows, ShapeletSet(RandomWalks(2, 10, 47)), {Match{}}, {}, &matches),
               std::invalid_argument);
}

TEST(FindBestMatches, DoesNotDependOnEarlierUsesOfItsMemory) {
  for (const tile::Loops& loops : RunnableLoops()) {
    SCOPED_TRACE(loops.name);
    SearchMemory kept;
    for (const int samples : {1200, 90, 433, 60}) {
      for (const Pruning pruning : {Pruning::kByBounds, Pruning::kByEnergy, Pruning::kNone}) {
        const ShapeletSet shapelets(RandomWalks(6, samples / 3, 57));
        const WindowSet windows((RandomWalk(samples, 58).array() * 1e3F).matrix(), shapelets.length(), 0.0);
        SearchMemory fresh;
        std::vector<Match> expected;
        std::vector<Match> found;
        FindBestMatchesWith(loops, windows, shapelets, {}, pruning, &fresh, &expected);
        FindBestMatchesWith(loops, windows, shapelets, {}, pruning, &kept, &found);
        for (std::size_t k = 0; k < expected.size(); ++k) {
          EXPECT_EQ(found[k].similarity, expected[k].similarity);
          EXPECT_EQ(found[k].window, expected[k].window);
          EXPECT_EQ(found[k].shift, expected[k].shift);
        }
      }
    }
  }
}

TEST(FindBestMatches, MayWriteOverItsHints) {
  const WindowSet windows(RandomWalk(300, 59), 25, 0.0);
  const ShapeletSet shapelets(RandomWalks(5, 25, 60));
  const std::vector<Match> expected = BestMatchesByDefinition(windows, shapelets);
  std::vector<Match> matches = expected;
  std::reverse(matches.begin(), matches.end());
  FindBestMatches(windows, shapelets, matches, {}, &matches);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(matches[k].similarity, expected[k].similarity, kTolerance);
  }
}

TEST(FftwMatcher, MayBeMadeOnSeveralThreadsAtTheSameTime) {
  const WindowSet windows(RandomWalk(100, 48), 20, 0.0);
  const ShapeletSet shapelets(RandomWalks(3, 20, 49));
  const std::vector<Match> expected = BestMatchesByDefinition(windows, shapelets);
  std::vector<std::vector<Match>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<Match>& matches : found) {
    threads.emplace_back([&] {
      for (int round = 0; round < 20; ++round) matches = FftwMatcher(shapelets).BestMatches(windows);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<Match>& matches : found) {
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(matches[k].similarity, expected[k].similarity, kTolerance);
    }
  }
}

}  // namespace
}  // namespace contact_shapelets::core

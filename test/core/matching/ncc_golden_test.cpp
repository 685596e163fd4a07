// Equation 2 and min-pooling, against values computed by NumPy.
#include <gtest/gtest.h>

#include <vector>

#include "core/matching/ncc_definition.h"
#include "core/matching/ncc_fftw.h"
#include "core/matching/ncc_kernel.h"
#include "golden/golden_values.h"

namespace contact_shapelets::core {
namespace {

/// Compares what `search` finds in each golden series.
template <typename Search>
void ExpectGoldenMatches(const Search& search) {
  const std::vector<Eigen::VectorXf> series = test::GoldenSeries("matching.series");
  const ShapeletSet shapelets(test::Golden("matching.shapelets").cast<float>());
  const Eigen::MatrixXd distances = test::Golden("matching.distances");
  const Eigen::MatrixXd windows = test::Golden("matching.windows");
  const Eigen::MatrixXd shifts = test::Golden("matching.shifts");
  for (std::size_t row = 0; row < series.size(); ++row) {
    const std::vector<Match> matches = search(WindowSet(series[row], shapelets.length(), 0.0), shapelets);
    ASSERT_EQ(static_cast<Eigen::Index>(matches.size()), distances.cols());
    for (std::size_t k = 0; k < matches.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(row);
      const auto column = static_cast<Eigen::Index>(k);
      EXPECT_NEAR(1.0 - matches[k].similarity, distances(i, column), 1e-6) << "series " << row << ", shapelet " << k;
      EXPECT_EQ(matches[k].window, windows(i, column)) << "series " << row << ", shapelet " << k;
      EXPECT_EQ(matches[k].shift, shifts(i, column)) << "series " << row << ", shapelet " << k;
    }
  }
}

TEST(GoldenMatches, OfTheDefinition) { ExpectGoldenMatches(BestMatchesByDefinition); }

TEST(GoldenMatches, OfTheKernel) {
  ExpectGoldenMatches([](const WindowSet& windows, const ShapeletSet& shapelets) {
    std::vector<Match> matches;
    FindBestMatches(windows, shapelets, {}, MatchOptions{}, &matches);
    return matches;
  });
}

TEST(GoldenMatches, OfTheTransform) {
  ExpectGoldenMatches([](const WindowSet& windows, const ShapeletSet& shapelets) {
    return FftwMatcher(shapelets).BestMatches(windows);
  });
}

}  // namespace
}  // namespace contact_shapelets::core

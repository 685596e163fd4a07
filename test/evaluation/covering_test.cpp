#include "evaluation/covering.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace contact_shapelets::evaluation {
namespace {

TEST(Covering, IsOneForTheTrueChangePointsInAnyOrder) { EXPECT_DOUBLE_EQ(Covering({3, 5}, {5, 3}, 8), 1.0); }

TEST(Covering, IsOneWhereNeitherHasAny) { EXPECT_DOUBLE_EQ(Covering({}, {}, 8), 1.0); }

TEST(Covering, IsTheShareOfEachTrueSegmentWhereNothingIsFound) {
  // Segments of 2, 3 and 5 samples, each within the one found segment of 10.
  EXPECT_DOUBLE_EQ(Covering({2, 5}, {}, 10), (2.0 * 0.2 + 3.0 * 0.3 + 5.0 * 0.5) / 10.0);
}

TEST(Covering, TakesForEachTrueSegmentTheFoundOneThatFitsBest) {
  // True {0..5}; found {0..3} covers 4 of its 6.
  EXPECT_DOUBLE_EQ(Covering({}, {4}, 6), 4.0 / 6.0);
  // True {0..2}, {3..5}; found {0, 1}, {2, 3}, {4, 5}: 2 of 3 each.
  EXPECT_DOUBLE_EQ(Covering({3}, {2, 4}, 6), 2.0 / 3.0);
}

TEST(Covering, WeighsTheTrueSegmentsByTheirLengths) {
  // True {0..2}, {3..5}; found {0..2}, {3, 4}, {5}: 1 for three samples, 2 of 3 for three.
  EXPECT_DOUBLE_EQ(Covering({3}, {3, 5}, 6), 5.0 / 6.0);
  // The other way round the segments of 2 and 1 weigh less: 3 of 3, 2 of 3, 1 of 3.
  EXPECT_DOUBLE_EQ(Covering({3, 5}, {3}, 6), (3.0 + 2.0 * 2.0 / 3.0 + 1.0 / 3.0) / 6.0);
}

TEST(Covering, RefusesChangePointsAtTheEndsAndBeyond) {
  EXPECT_THROW(Covering({0}, {}, 8), std::invalid_argument);
  EXPECT_THROW(Covering({}, {8}, 8), std::invalid_argument);
  EXPECT_THROW(Covering({}, {}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::evaluation

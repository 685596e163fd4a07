#include "core/numerics/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace contact_shapelets::core {
namespace {

class ParallelForTest : public testing::TestWithParam<int> {};

TEST_P(ParallelForTest, CallsEveryIndexOnce) {
  std::vector<std::atomic<int>> calls(101);
  for (std::atomic<int>& count : calls) count = 0;
  ParallelFor(101, GetParam(), [&calls](int index) { ++calls.at(static_cast<std::size_t>(index)); });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
}

TEST_P(ParallelForTest, CallsNothingForNoIndices) {
  std::atomic<int> calls{0};
  ParallelFor(0, GetParam(), [&calls](int) { ++calls; });
  EXPECT_EQ(calls, 0);
}

TEST_P(ParallelForTest, ThrowsWhatTheWorkThrew) {
  try {
    ParallelFor(50, GetParam(), [](int index) {
      if (index == 17) throw std::runtime_error("index 17");
    });
    FAIL() << "no exception came through";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "index 17");
  }
}

TEST_P(ParallelForTest, ThrowsOneOfManyFailures) {
  EXPECT_THROW(ParallelFor(50, GetParam(), [](int) { throw std::invalid_argument("all fail"); }),
               std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelForTest, testing::Values(-1, 0, 1, 2, 3, 16, 1000));

TEST(ParallelFor, StopsEarlyAfterAFailure) {
  int calls = 0;
  EXPECT_THROW(ParallelFor(1000, 1,
                           [&calls](int index) {
                             ++calls;
                             if (index == 3) throw std::runtime_error("stop");
                           }),
               std::runtime_error);
  EXPECT_EQ(calls, 4);
}

TEST(ParallelFor, WorksOnTheCallingThreadIfOneThreadIsAskedFor) {
  std::set<std::thread::id> threads;
  ParallelFor(20, 1, [&threads](int) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ParallelFor, RunsCallsAtTheSameTime) {
  // Each of two calls waits for the other. With one thread this would never end.
  std::atomic<int> arrived{0};
  ParallelFor(2, 2, [&arrived](int) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(ThreadCount, KeepsARequestAndOtherwiseTakesAtLeastOne) {
  EXPECT_EQ(ThreadCount(3), 3);
  EXPECT_GE(ThreadCount(0), 1);
}

TEST(ThreadCount, LeavesSpareCoresButAlwaysTakesOne) {
  EXPECT_EQ(ThreadCount(0, 1), std::max(1, ThreadCount(0) - 1));
  EXPECT_EQ(ThreadCount(0, 1'000'000), 1);
  EXPECT_EQ(ThreadCount(5, 1), 5) << "asked for by number";
}

}  // namespace
}  // namespace contact_shapelets::core

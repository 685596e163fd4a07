// The committed values are those that generate.py computes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

namespace {

constexpr int kNoNumPy = 77;

TEST(GoldenValues, AreWhatTheScriptComputes) {
  const int status = std::system("test/golden/generate.py --check");
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNoNumPy) GTEST_SKIP() << "NumPy is not installed (Debian: python3-numpy)";
  EXPECT_EQ(WEXITSTATUS(status), 0) << "see above for the values that differ";
}

}  // namespace

#include "core/drift/run_monitor.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

Model TwoClusters() {
  Model model;
  model.clusters.resize(2);
  model.clusters[1].label = "switched";
  return model;
}

/// Appends `count` pushes of cluster 1 with about this force [N].
void Append(int count, double force, Random* random, RunMonitor* monitor) {
  for (int push = 0; push < count; ++push) {
    Episode episode;
    episode.id = "push_" + std::to_string(monitor->count());
    episode.start = FromSeconds(100.0 + static_cast<double>(monitor->count()));
    episode.sample_period = 0.01;
    episode.force = Eigen::VectorXf::LinSpaced(100, 0.0F, static_cast<float>(force * (1.0 + 0.03 * random->Normal())));
    Diagnosis diagnosis;
    diagnosis.cluster = diagnosis.nearest_cluster = 1;
    diagnosis.event = "switched";
    diagnosis.novelty = static_cast<float>(0.5 + 0.1 * random->Uniform());
    monitor->Append(episode, diagnosis, TwoClusters());
  }
}

TEST(RunMonitor, ComparesWithTheFirstEpisodes) {
  Random random(1);
  RunMonitor monitor(50, ChangeOptions{});
  Append(50, 20.0, &random, &monitor);
  EXPECT_FALSE(monitor.LogEvidence());
  Append(50, 20.0, &random, &monitor);
  ASSERT_TRUE(monitor.LogEvidence());
  EXPECT_LT(*monitor.LogEvidence(), 0.0);
  EXPECT_FALSE(monitor.change());
  Append(30, 30.0, &random, &monitor);
  ASSERT_TRUE(monitor.change());
  EXPECT_NEAR(static_cast<double>(monitor.change()->index), 100.0, 8.0);
  EXPECT_EQ(monitor.change()->episode, "push_" + std::to_string(monitor.change()->index));
  EXPECT_EQ(monitor.change()->start, FromSeconds(100.0 + static_cast<double>(monitor.change()->index)));
  EXPECT_NE(monitor.change()->text.find("force"), std::string::npos) << monitor.change()->text;
  EXPECT_NE(monitor.change()->text.find("is higher by"), std::string::npos) << monitor.change()->text;
}

TEST(RunMonitor, RefusesOptionsOutOfRangeAtOnce) {
  EXPECT_THROW(RunMonitor(-1, ChangeOptions{}), std::invalid_argument);
  EXPECT_THROW(RunMonitor(50, ChangeOptions{2.0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core

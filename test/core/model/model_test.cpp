#include "contact_shapelets/core/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace contact_shapelets::core {
namespace {

Model Valid() {
  Model model;
  model.sample_period = 0.01;
  model.shapelets = {{0, 1, Eigen::Vector3f(-1.2F, 0.0F, 1.2F)}, {1, 2, Eigen::Vector2f(1.0F, -1.0F)}};
  model.clusters = {{Eigen::Vector2f(0.1F, 0.2F), 1.0F, 5, ""}, {Eigen::Vector2f(0.3F, 0.4F), 2.0F, 7, "switched"}};
  return model;
}

TEST(Model, HasNoFaultsIfAllValuesAreValid) { EXPECT_EQ(Valid().Faults(), ""); }

TEST(Model, ListsEveryFaultAtOnce) {
  Model model = Valid();
  model.sample_period = 0.0;
  model.flat_fraction = 1.0;
  model.log_offset = -0.1;
  model.shapelets[0].values = Eigen::VectorXf::Ones(1);
  model.shapelets[1].values[0] = std::numeric_limits<float>::quiet_NaN();
  model.shapelets[0].dilation = 0;
  model.clusters[0].centroid = Eigen::Vector3f::Zero();
  model.clusters[0].novelty_limit = -1.0F;
  model.clusters[1].centroid[1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(model.Faults(),
            "the sample period is not in [0.0001, 1] s\n"
            "the flat fraction is not in [0, 1)\n"
            "the log offset is not 0 or in [1e-06, 1]\n"
            "shapelet 0 has fewer than 2 values\n"
            "shapelet 0 has a dilation below 1\n"
            "shapelet 1 holds a value that is not finite\n"
            "cluster 0 has 3 features, but there are 2 shapelets\n"
            "cluster 0 has a novelty limit that is not in [1e-06, 1000000000]\n"
            "cluster 1 holds a value that is not finite\n");
}

TEST(Model, NamesWhatIsMissing) {
  EXPECT_EQ(Model().Faults(),
            "the sample period is not in [0.0001, 1] s\n"
            "the model has no shapelet\n"
            "the model has no cluster\n");
}

TEST(Model, RefusesNanAndInfinityWhereverANumberIsExpected) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Model model = Valid();
    model.sample_period = value;
    EXPECT_NE(model.Faults(), "");
    model = Valid();
    model.flat_fraction = value;
    EXPECT_NE(model.Faults(), "");
    model = Valid();
    model.log_offset = value;
    EXPECT_NE(model.Faults(), "");
  }
  Model model = Valid();
  model.clusters[0].novelty_limit = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(model.Faults(), "");
}

TEST(Model, FeaturesAreLogarithmsOfTheDistances) {
  Model model = Valid();
  model.log_offset = 0.05;
  Eigen::MatrixXf distances(2, 2);
  distances << 0.0F, 0.5F, -1e-7F, 2.0F;
  const Eigen::MatrixXf features = model.Features(distances);
  EXPECT_NEAR(features(0, 0), std::log(0.05), 1e-5);
  EXPECT_NEAR(features(0, 1), std::log(0.55), 1e-5);
  EXPECT_NEAR(features(1, 0), std::log(0.05), 1e-5);
  EXPECT_NEAR(features(1, 1), std::log(2.05), 1e-5);
}

TEST(Model, FeaturesAreTheDistancesThemselvesWithoutAnOffset) {
  Model model = Valid();
  model.log_offset = 0.0;
  EXPECT_EQ(model.Faults(), "");
  EXPECT_EQ(model.Features(Eigen::RowVector3f(0.5F, -1e-7F, 2.0F)), Eigen::RowVector3f(0.5F, 0.0F, 2.0F));
}

TEST(Model, EventsAreLabelsOrNumbersIfThereIsNoLabel) {
  const Model model = Valid();
  EXPECT_EQ(model.EventOf(0), "cluster_0");
  EXPECT_EQ(model.EventOf(1), "switched");
  EXPECT_EQ(model.EventOf(-1), "unknown");
  EXPECT_EQ(model.EventOf(2), "unknown");
}

}  // namespace
}  // namespace contact_shapelets::core

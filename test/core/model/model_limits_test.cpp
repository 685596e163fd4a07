/// Each field of a model at its extremes, beyond them, and where it is no number.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "contact_shapelets/core/classifier.h"
#include "contact_shapelets/core/model.h"

namespace contact_shapelets::core {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kGreatestInt = std::numeric_limits<int>::max();
constexpr int kLeastInt = std::numeric_limits<int>::min();

Model Sound() {
  Model model;
  model.id = "sound";
  model.sample_period = 0.01;
  model.shapelets = {{0, 1, Eigen::Vector3f(-1.2F, 0.0F, 1.2F)}, {1, 2, Eigen::Vector2f(1.0F, -1.0F)}};
  model.clusters = {{Eigen::Vector2f(0.1F, 0.2F), 1.0F, 5, ""}, {Eigen::Vector2f(0.3F, 0.4F), 2.0F, 7, "switched"}};
  model.provenance = {{"one.bag"}, "contrastive", {0.1, 0.3}, 7, 12, 1.5, 1'700'000'000'000'000'000};
  return model;
}

/// A field that holds a number, and what it may be.
struct Field {
  std::string name;
  std::function<void(Model*, double)> set;
  std::vector<double> allowed;
  std::vector<double> refused;
};

float Float(double value) { return static_cast<float>(value); }

std::vector<Field> RealFields() {
  return {
      {"sample_period", [](Model* model, double value) { model->sample_period = value; }, {1e-4, 1.0}, {9.9e-5, 1.001}},
      {"flat_fraction",
       [](Model* model, double value) { model->flat_fraction = value; },
       {0.0, std::nextafter(1.0, 0.0)},
       {-1e-9, 1.0}},
      {"log_offset",
       [](Model* model, double value) { model->log_offset = value; },
       {0.0, 1e-6, 1.0},
       {-1e-9, 1e-300, 9.9e-7, 1.0001}},
      {"shapelet value",
       [](Model* model, double value) { model->shapelets[1].values[0] = Float(value); },
       {-1e4, 1e4},
       {-1.0001e4, 1.0001e4, std::numeric_limits<float>::max()}},
      {"centroid",
       [](Model* model, double value) { model->clusters[1].centroid[1] = Float(value); },
       {-100.0, 100.0},
       {-100.1, 100.1, std::numeric_limits<float>::lowest()}},
      {"novelty_limit",
       [](Model* model, double value) { model->clusters[0].novelty_limit = Float(value); },
       {1.0001e-6, 1e9},
       {0.0, -1.0, 9.9e-7, 1.001e9}},
      {"selected_scales",
       [](Model* model, double value) { model->provenance.selected_scales[1] = value; },
       {1e-9, std::nextafter(1.0, 0.0)},
       {0.0, 1.0, -0.1}},
      {"typical_duration",
       [](Model* model, double value) { model->provenance.typical_duration = value; },
       {0.0, 1e7},
       {-1e-9, 1.0001e7}},
  };
}

std::vector<Field> WholeFields() {
  return {
      {"scale",
       [](Model* model, double value) { model->shapelets[0].scale = static_cast<int>(value); },
       {0, 99},
       {-1, 100, kGreatestInt, kLeastInt}},
      {"dilation",
       [](Model* model, double value) { model->shapelets[1].dilation = static_cast<int>(value); },
       {1, kGreatestReach - 1},
       {0, -1, kGreatestReach, 1 << 30, kGreatestInt, kLeastInt}},
      {"size",
       [](Model* model, double value) { model->clusters[0].size = static_cast<int>(value); },
       {0, kGreatestInt},
       {-1, kLeastInt}},
      {"training_episodes",
       [](Model* model, double value) { model->provenance.training_episodes = static_cast<int>(value); },
       {0, kGreatestInt},
       {-1, kLeastInt}},
  };
}

/// Expects that the model with this value is accepted, and that it classifies to finite numbers.
void ExpectUsable(const Field& field, double value) {
  Model model = Sound();
  field.set(&model, value);
  ASSERT_EQ(model.Faults(), "") << field.name << " " << value;
  Episode episode;
  episode.sample_period = model.sample_period;
  episode.force = Eigen::VectorXf::LinSpaced(40, 0.0F, 3.0F);
  const Classification result = Classifier(model).Classify(episode);
  EXPECT_TRUE(std::isfinite(result.diagnosis.novelty)) << field.name << " " << value;
  EXPECT_TRUE(std::isfinite(result.diagnosis.confidence)) << field.name << " " << value;
}

void ExpectRefused(const Field& field, double value) {
  Model model = Sound();
  field.set(&model, value);
  EXPECT_NE(model.Faults(), "") << field.name << " " << value;
}

TEST(ModelLimits, EachFieldMayTakeItsExtremesAndNothingBeyond) {
  std::vector<Field> fields = RealFields();
  const std::vector<Field> whole = WholeFields();
  fields.insert(fields.end(), whole.begin(), whole.end());
  for (const Field& field : fields) {
    for (const double value : field.allowed) ExpectUsable(field, value);
    for (const double value : field.refused) ExpectRefused(field, value);
  }
}

TEST(ModelLimits, NoFieldMayBeNanOrInfinite) {
  for (const Field& field : RealFields()) {
    for (const double value : {std::nan(""), kInfinity, -kInfinity}) ExpectRefused(field, value);
  }
}

TEST(ModelLimits, ALongDilatedShapeletMayReachAsFarAsTheLongestEpisode) {
  Model model = Sound();
  model.shapelets[0] = {0, 1000, Eigen::VectorXf::LinSpaced(6000, -1.0F, 1.0F)};
  EXPECT_EQ(model.Faults(), "");
  model.shapelets[0].dilation = 1001;
  EXPECT_EQ(model.Faults(), "shapelet 0 reaches over more than 6000000 samples\n");
}

TEST(ModelLimits, TextsHaveAGreatestLength) {
  const std::vector<std::pair<std::size_t, std::function<std::string*(Model*)>>> texts{
      {kLongestLabel, [](Model* model) { return &model->id; }},
      {kLongestLabel, [](Model* model) { return &model->clusters[0].label; }},
      {kLongestLabel, [](Model* model) { return &model->provenance.objective; }},
      {kLongestPath, [](Model* model) { return &model->provenance.sources[0]; }}};
  for (const auto& [longest, text] : texts) {
    Model model = Sound();
    *text(&model) = std::string(longest, 'x');
    EXPECT_EQ(model.Faults(), "");
    *text(&model) += 'x';
    EXPECT_NE(model.Faults(), "");
  }
}

TEST(ModelLimits, TheTimeOfTrainingFitsAStamp) {
  for (const Nanoseconds well : {Nanoseconds{0}, Nanoseconds{4'294'967'295'999'999'999}}) {
    Model model = Sound();
    model.provenance.trained = well;
    EXPECT_EQ(model.Faults(), "");
  }
  for (const Nanoseconds wrong : {Nanoseconds{-1}, Nanoseconds{4'294'967'296'000'000'000},
                                  std::numeric_limits<Nanoseconds>::max(), std::numeric_limits<Nanoseconds>::min()}) {
    Model model = Sound();
    model.provenance.trained = wrong;
    EXPECT_NE(model.Faults(), "");
  }
}

/// A model of so many shapelets of `values` values each, and so many clusters.
Model Large(int shapelets, int values, int clusters) {
  Model model = Sound();
  model.shapelets.assign(static_cast<std::size_t>(shapelets), {0, 1, Eigen::VectorXf::Zero(values)});
  model.clusters.assign(static_cast<std::size_t>(clusters), {Eigen::VectorXf::Zero(shapelets), 1.0F, 1, ""});
  return model;
}

TEST(ModelLimits, ThereAreNotMoreThanSoManyShapeletsClustersAndValues) {
  EXPECT_EQ(Large(kMostShapelets, 2, 3).Faults(), "");
  EXPECT_EQ(Large(kMostShapelets + 1, 2, 3).Faults(), "the model has more than 10000 shapelets\n");
  EXPECT_EQ(Large(3, 2, kMostClusters).Faults(), "");
  EXPECT_EQ(Large(3, 2, kMostClusters + 1).Faults(), "the model has more than 1000 clusters\n");
  EXPECT_EQ(Large(10, kMostValues / 10, 2).Faults(), "");
  EXPECT_EQ(Large(10, kMostValues / 10 + 1, 2).Faults(), "the shapelets have more than 10000000 values together\n");
  EXPECT_EQ(Large(kMostShapelets, 2, 1000).Faults(), "");
  Model model = Large(kMostShapelets, 2, 1000);
  model.clusters[0].centroid = Eigen::VectorXf::Zero(kMostShapelets + 1);
  EXPECT_EQ(model.Faults(), "the clusters have more than 10000000 features together\n");
}

TEST(ModelLimits, ThereAreNotMoreThanSoManyScalesAndSources) {
  Model model = Sound();
  model.provenance.selected_scales.assign(100, 0.5);
  model.provenance.sources.assign(kMostSources, "a.bag");
  EXPECT_EQ(model.Faults(), "");
  model.provenance.selected_scales.push_back(0.5);
  model.provenance.sources.emplace_back("b.bag");
  EXPECT_EQ(model.Faults(), "the model has more than 100000 sources\nthe model has more than 100 scales\n");
}

TEST(ModelLimits, ANameMayBeAsLongAsALabel) {
  Classifier classifier(Sound());
  classifier.NameCluster(0, std::string(kLongestLabel, 'x'));
  EXPECT_EQ(classifier.model().Faults(), "");
  EXPECT_THROW(classifier.NameCluster(0, std::string(kLongestLabel + 1, 'x')), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core

/// The classifier node alone: models from files and topics, early diagnoses, names, bad models.

#include <contact_shapelets/Diagnosis.h>
#include <contact_shapelets/Episode.h>
#include <contact_shapelets/NameCluster.h>
#include <contact_shapelets/ShapeletFeatures.h>
#include <contact_shapelets/ShapeletModel.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <filesystem>
#include <limits>

#include "contact_shapelets/ros/episode_bag_reader.h"
#include "contact_shapelets/ros/model_bag.h"
#include "ros/messages/conversions.h"
#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;

std::string PathParameter(const std::string& name) {
  std::string path;
  EXPECT_TRUE(ros::param::get("/paths/" + name, path)) << name;
  return path;
}

/// Returns the first episode of the shipped test bag as a message.
Episode AnEpisode() {
  return ToMessage(ReadEpisodes(PathParameter("bags") + "/switch_push_test.bag", BagReaderOptions()).episodes.front());
}

/// A classifier node in a namespace, with connections to all of its topics.
class RunningClassifier {
 public:
  explicit RunningClassifier(const std::string& name)
      : diagnoses(name + "/diagnosis"),
        events(name + "/event"),
        features(name + "/features"),
        name_(name),
        episode_publisher_(node_handle_.advertise<Episode>(name + "/episode", 10)),
        progress_publisher_(node_handle_.advertise<Episode>(name + "/episode_progress", 10)) {}

  bool WaitForConnections() {
    return diagnoses.WaitForPublisher() && events.WaitForPublisher() && features.WaitForPublisher() &&
           WaitUntil([this] {
             return episode_publisher_.getNumSubscribers() > 0 && progress_publisher_.getNumSubscribers() > 0;
           });
  }
  void End(const Episode& episode) { episode_publisher_.publish(episode); }
  void Progress(const Episode& episode) { progress_publisher_.publish(episode); }
  NameCluster::Response Name(int cluster, const std::string& label) {
    NameCluster name;
    name.request.cluster = cluster;
    name.request.label = label;
    const std::string service = name_ + "/classifier_node/name_cluster";
    EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(kLimit)));
    EXPECT_TRUE(ros::service::call(service, name));
    return name.response;
  }
  /// Waits for the node's results for `episode` and copies them.
  bool Diagnosed(const Episode& episode, Diagnosis* diagnosis) {
    const std::size_t before = diagnoses.messages().size();
    End(episode);
    if (!diagnoses.WaitForCount(before + 1)) return false;
    *diagnosis = diagnoses.messages().back();
    return true;
  }

  Inbox<Diagnosis> diagnoses;
  Inbox<std_msgs::String> events;
  Inbox<ShapeletFeatures> features;

 private:
  ros::NodeHandle node_handle_;
  std::string name_;
  ros::Publisher episode_publisher_;
  ros::Publisher progress_publisher_;
};

TEST(Classifier, GivesWhatTheCoreGives) {
  RunningClassifier node("file");
  ASSERT_TRUE(node.WaitForConnections());
  const Episode episode = AnEpisode();
  const core::Classifier core(LoadModel(PathParameter("model")));
  const core::Classification expected = core.Classify(FromMessage(episode));
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(episode, &diagnosis));
  EXPECT_TRUE(diagnosis.final);
  EXPECT_EQ(diagnosis.episode_id, episode.episode_id);
  EXPECT_EQ(diagnosis.model_id, core.model().id);
  EXPECT_EQ(diagnosis.cluster, expected.diagnosis.cluster);
  EXPECT_NEAR(diagnosis.novelty, expected.diagnosis.novelty, 1e-6);
  ASSERT_TRUE(node.events.WaitForCount(1) && node.features.WaitForCount(1));
  EXPECT_EQ(node.events.messages().front().data, diagnosis.event);
  const ShapeletFeatures& features = node.features.messages().front();
  ASSERT_EQ(features.distances.size(), core.model().shapelets.size());
  for (std::size_t index = 0; index < features.distances.size(); ++index) {
    EXPECT_NEAR(features.distances[index], expected.features.distances[static_cast<Eigen::Index>(index)], 1e-6);
  }
}

TEST(Classifier, DiagnosesOpenEpisodesEarlyButOnlyWhileTheyAreOpen) {
  RunningClassifier node("file");
  ASSERT_TRUE(node.WaitForConnections());
  Episode episode = AnEpisode();
  episode.episode_id = "early";
  Episode open = episode;
  open.complete = false;
  open.force.resize(episode.force.size() / 10);
  node.Progress(open);  // too short for a diagnosis
  open.force.assign(episode.force.begin(),
                    episode.force.begin() + static_cast<std::ptrdiff_t>(episode.force.size() / 2));
  node.Progress(open);
  ASSERT_TRUE(node.diagnoses.WaitForCount(1));
  EXPECT_FALSE(node.diagnoses.messages().front().final);
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(episode, &diagnosis));
  EXPECT_TRUE(diagnosis.final);
  node.Progress(open);  // the end came first
  open.episode_id = "next";
  node.Progress(open);
  ASSERT_TRUE(node.diagnoses.WaitForCount(3));
  EXPECT_EQ(node.diagnoses.messages().back().episode_id, "next");
  EXPECT_EQ(node.events.messages().size(), 1U) << "early diagnoses are no events";
}

TEST(Classifier, DiagnosesEarlyAlsoWhereAllEpisodesHaveOneName) {
  RunningClassifier node("file");
  ASSERT_TRUE(node.WaitForConnections());
  Episode first = AnEpisode();
  first.episode_id = "push";
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(first, &diagnosis));
  Episode second = first;
  second.header.stamp += ros::Duration(first.sample_period * static_cast<double>(first.force.size()) + 1.0);
  for (Episode* const episode : {&first, &second}) {
    episode->complete = false;
    episode->force.resize(episode->force.size() / 2);
    node.Progress(*episode);  // the end of the first episode came before its progress
  }
  ASSERT_TRUE(node.diagnoses.WaitForCount(2));
  EXPECT_FALSE(node.diagnoses.messages().back().final);
  EXPECT_EQ(node.diagnoses.messages().back().header.stamp, second.header.stamp);
}

TEST(Classifier, NamesOfTwoNodesInOneFileBothStay) {
  RunningClassifier one("twin_1");
  RunningClassifier other("twin_2");
  EXPECT_TRUE(one.Name(0, "first").success);
  EXPECT_TRUE(other.Name(1, "second").success);
  EXPECT_TRUE(one.Name(2, "third").success);
  const core::Model saved = LoadModel(PathParameter("twin_model"));
  EXPECT_EQ(saved.clusters[0].label, "first");
  EXPECT_EQ(saved.clusters[1].label, "second");
  EXPECT_EQ(saved.clusters[2].label, "third");
  EXPECT_EQ(saved.provenance.trained, LoadModel(PathParameter("model")).provenance.trained);
}

TEST(Classifier, TakesNoModelByTopicThatIsOlderThanItsFile) {
  ros::NodeHandle node_handle;
  RunningClassifier node("aged");
  Diagnostics diagnostics;
  ASSERT_TRUE(node.WaitForConnections());
  core::Model model = LoadModel(PathParameter("model"));
  const std::string in_file = model.id;
  const core::Nanoseconds trained = model.provenance.trained;
  ros::Publisher publisher = node_handle.advertise<ShapeletModel>("aged/model", 1, true);
  model.id = "older";
  model.provenance.trained = trained - 1'000'000'000;
  publisher.publish(ToMessage(model));
  EXPECT_TRUE(
      diagnostics.WaitFor("aged/classifier_node", DiagnosticStatus::WARN, "model older from the topic was refused"));
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(AnEpisode(), &diagnosis));
  EXPECT_EQ(diagnosis.model_id, in_file);
  model.id = "newer";
  model.provenance.trained = trained + 1'000'000'000;
  publisher.publish(ToMessage(model));
  EXPECT_TRUE(diagnostics.WaitForValue("aged/classifier_node", "model", "newer"));
}

TEST(Classifier, NamesAClusterAndSavesTheName) {
  RunningClassifier node("named");
  ASSERT_TRUE(node.WaitForConnections());
  const Episode episode = AnEpisode();
  Diagnosis before;
  ASSERT_TRUE(node.Diagnosed(episode, &before));
  ASSERT_GE(before.cluster, 0);
  const NameCluster::Response response = node.Name(before.cluster, "clicked");
  EXPECT_TRUE(response.success) << response.message;
  Diagnosis after;
  ASSERT_TRUE(node.Diagnosed(episode, &after));
  EXPECT_EQ(after.event, "clicked");
  const core::Model saved = LoadModel(PathParameter("named_model"));
  EXPECT_EQ(saved.clusters[static_cast<std::size_t>(before.cluster)].label, "clicked");
}

TEST(Classifier, SaysThatANameWasNotSaved) {
  RunningClassifier node("named");
  const std::string path = PathParameter("named_model");
  std::filesystem::rename(path, path + ".away");
  const NameCluster::Response response = node.Name(1, "clicked");
  std::filesystem::rename(path + ".away", path);
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("not saved: " + path), std::string::npos) << response.message;
}

TEST(Classifier, RefusesANameForNoClusterAndAnEmptyName) {
  RunningClassifier node("file");
  EXPECT_FALSE(node.Name(99, "far").success);
  EXPECT_FALSE(node.Name(-1, "none").success);
  EXPECT_FALSE(node.Name(0, "").success);
}

TEST(Classifier, TakesANewModelByTopicWithoutARestartAndKeepsItsNames) {
  ros::NodeHandle node_handle;
  RunningClassifier node("topic");
  Diagnostics diagnostics;
  ASSERT_TRUE(node.WaitForConnections());
  EXPECT_TRUE(diagnostics.WaitFor("topic/classifier_node", DiagnosticStatus::ERROR, "no model yet"));
  core::Model model = LoadModel(PathParameter("model"));
  for (const char* id : {"first", "second"}) {
    model.id = id;
    ros::Publisher publisher = node_handle.advertise<ShapeletModel>("topic/model", 1, true);
    publisher.publish(ToMessage(model));
    ASSERT_TRUE(diagnostics.WaitForValue("topic/classifier_node", "model", id));
    EXPECT_TRUE(node.Name(0, std::string("zero of ") + id).success);
    Diagnosis diagnosis;
    ASSERT_TRUE(node.Diagnosed(AnEpisode(), &diagnosis));
    EXPECT_EQ(diagnosis.model_id, id);
    publisher.publish(ToMessage(model));
    const NameCluster::Response response = node.Name(1, "one");
    EXPECT_NE(response.message.find("not saved"), std::string::npos) << response.message;
  }
}

TEST(Classifier, TakesNamesThatTheSameModelByTopicGotLater) {
  ros::NodeHandle node_handle;
  RunningClassifier node("topic");
  Diagnostics diagnostics;
  ASSERT_TRUE(node.WaitForConnections());
  core::Model model = LoadModel(PathParameter("model"));
  model.id = "named later";
  for (core::Cluster& cluster : model.clusters) cluster.label.clear();
  ros::Publisher publisher = node_handle.advertise<ShapeletModel>("topic/model", 1, true);
  publisher.publish(ToMessage(model));
  ASSERT_TRUE(diagnostics.WaitForValue("topic/classifier_node", "model", model.id));
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(AnEpisode(), &diagnosis));
  EXPECT_EQ(diagnosis.event, "cluster_" + std::to_string(diagnosis.cluster));
  for (core::Cluster& cluster : model.clusters) cluster.label = "told";
  publisher.publish(ToMessage(model));
  EXPECT_TRUE(WaitUntil([&] { return node.Diagnosed(AnEpisode(), &diagnosis) && diagnosis.event == "told"; }));
}

TEST(Classifier, RefusesABadModelByTopicAndKeepsTheOldOne) {
  ros::NodeHandle node_handle;
  RunningClassifier node("file");
  Diagnostics diagnostics;
  ASSERT_TRUE(node.WaitForConnections());
  ShapeletModel bad = ToMessage(LoadModel(PathParameter("model")));
  bad.model_id = "bad";
  bad.shapelets.front().values.front() = std::numeric_limits<float>::quiet_NaN();
  ros::Publisher publisher = node_handle.advertise<ShapeletModel>("file/model", 1, true);
  publisher.publish(bad);
  EXPECT_TRUE(diagnostics.WaitFor("file/classifier_node", DiagnosticStatus::WARN, "refused"));
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(AnEpisode(), &diagnosis));
  EXPECT_NE(diagnosis.model_id, "bad");
}

TEST(Classifier, RefusesABadEpisodeAndRecovers) {
  RunningClassifier node("named");
  Diagnostics diagnostics;
  ASSERT_TRUE(node.WaitForConnections());
  Episode episode = AnEpisode();
  episode.force.front() = std::numeric_limits<float>::quiet_NaN();
  node.End(episode);
  EXPECT_TRUE(diagnostics.WaitFor("named/classifier_node", DiagnosticStatus::WARN, "not finite"));
  // At the model's period no memory could hold the samples.
  Episode endless = AnEpisode();
  endless.sample_period = 1e8;
  node.End(endless);
  EXPECT_TRUE(diagnostics.WaitFor("named/classifier_node", DiagnosticStatus::WARN, "sample period"));
  Diagnosis diagnosis;
  ASSERT_TRUE(node.Diagnosed(AnEpisode(), &diagnosis));
  EXPECT_TRUE(diagnostics.WaitFor("named/classifier_node", DiagnosticStatus::OK, "model in use"));
}

TEST(Classifier, StaysUpAndSaysWhichModelFileIsMissing) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("missing/classifier_node", DiagnosticStatus::ERROR, "/no/such/model.bag"));
  EXPECT_TRUE(diagnostics.WaitFor("relative/classifier_node", DiagnosticStatus::ERROR, "expected an absolute path"));
}

TEST(Classifier, StaysUpAndSaysWhichModelFileIsNoBag) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("broken/classifier_node", DiagnosticStatus::ERROR, "package.xml: expected a bag"));
}

TEST(Classifier, StaysUpAndSaysWhichBagHoldsNoModel) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("other/classifier_node", DiagnosticStatus::ERROR, "switch_push_test.bag: expected"));
}

TEST(Classifier, StaysUpAndNamesAParameterOutOfRange) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("faulty/classifier_node", DiagnosticStatus::ERROR, "early_minimum"));
  RunningClassifier node("faulty");
  EXPECT_FALSE(node.Name(0, "zero").success) << "there is no model";
}

}  // namespace
}  // namespace contact_shapelets::test

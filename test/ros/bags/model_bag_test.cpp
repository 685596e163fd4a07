#include "contact_shapelets/ros/model_bag.h"

#include <rosbag/view.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <topic_tools/shape_shifter.h>

#include <csignal>
#include <cstring>
#include <vector>

#include "ros/bags/bag_fixture.h"
#include "ros/messages/conversions.h"

namespace contact_shapelets {
namespace {

using ModelBagTest = BagTest;

core::Model Trained(const std::string& id = "model_1") {
  core::Model model;
  model.id = id;
  model.sample_period = 0.01;
  model.flat_fraction = 0.3;
  model.log_offset = 0.05;
  model.shapelets = {{0, 1, Eigen::Vector3f(-1.224F, 1.0e-8F, 1.224F)},
                     {2, 3, Eigen::Vector4f(1.0F, -1.0F, 1.0F, -1.0F)}};
  model.clusters = {{Eigen::Vector2f(0.1F, -0.2F), 1.7F, 12, ""},
                    {Eigen::Vector2f(1.0F / 3.0F, 0.4F), 0.9F, 30, "already_on"}};
  model.provenance = {{"one.bag", "two.bag"},   "contrastive", {0.1, 1.0 / 3.0}, 0xFFFFFFFFFFFFFFFFULL, 42, 2.17,
                      1'600'000'000'123'456'789};
  return model;
}

/// Writes one message of `type` with this MD5 on `model`.
void WriteShape(const std::string& path, const std::string& md5, const std::string& type) {
  topic_tools::ShapeShifter shape;
  shape.morph(md5, type, "uint32 format_version\n", "");
  rosbag::Bag(path, rosbag::bagmode::Write).write("model", ros::Time(1.0), shape);
}

void WriteMessages(const std::string& path, const std::vector<ShapeletModel>& messages) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (const ShapeletModel& message : messages) bag.write("model", ros::Time(1.0), message);
}

TEST_F(ModelBagTest, ASavedModelIsLoadedToTheLastBit) {
  const core::Model model = Trained();
  SaveModel(Path("model.bag"), model);
  const core::Model loaded = LoadModel(Path("model.bag"));
  EXPECT_EQ(loaded.id, model.id);
  EXPECT_EQ(loaded.sample_period, model.sample_period);
  EXPECT_EQ(loaded.flat_fraction, model.flat_fraction);
  EXPECT_EQ(loaded.log_offset, model.log_offset);
  ASSERT_EQ(loaded.shapelets.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(loaded.shapelets[k].scale, model.shapelets[k].scale);
    EXPECT_EQ(loaded.shapelets[k].dilation, model.shapelets[k].dilation);
    EXPECT_EQ(loaded.shapelets[k].values, model.shapelets[k].values);
  }
  ASSERT_EQ(loaded.clusters.size(), 2U);
  for (std::size_t cluster = 0; cluster < 2; ++cluster) {
    EXPECT_EQ(loaded.clusters[cluster].centroid, model.clusters[cluster].centroid);
    EXPECT_EQ(loaded.clusters[cluster].novelty_limit, model.clusters[cluster].novelty_limit);
    EXPECT_EQ(loaded.clusters[cluster].size, model.clusters[cluster].size);
    EXPECT_EQ(loaded.clusters[cluster].label, model.clusters[cluster].label);
  }
  EXPECT_EQ(loaded.provenance.sources, model.provenance.sources);
  EXPECT_EQ(loaded.provenance.objective, model.provenance.objective);
  EXPECT_EQ(loaded.provenance.selected_scales, model.provenance.selected_scales);
  EXPECT_EQ(loaded.provenance.seed, model.provenance.seed);
  EXPECT_EQ(loaded.provenance.training_episodes, model.provenance.training_episodes);
  EXPECT_EQ(loaded.provenance.typical_duration, model.provenance.typical_duration);
  EXPECT_EQ(loaded.provenance.trained, model.provenance.trained);
}

TEST_F(ModelBagTest, KeepsThePreparation) {
  core::Model model = Trained();
  core::Preparation& preparation = model.preparation;
  preparation.segmentation.emplace().segmentation = core::SegmentationMode::kContact;
  preparation.segmentation->tare = core::TareSource::kFreeAir;
  preparation.segmentation->contact_on = 6.5;
  preparation.segmentation->baseline_duration = 2.5;
  preparation.topic = "/iiwa/wrench";
  preparation.frame_id = "flange";
  preparation.rate = 125.0;
  preparation.least_duration = 1.5;
  preparation.greatest_duration = 2.5;
  preparation.least_peak = 9.0;
  preparation.greatest_peak = 21.0;
  SaveModel(Path("model.bag"), model);
  const core::Preparation loaded = LoadModel(Path("model.bag")).preparation;
  ASSERT_TRUE(loaded.segmentation);
  EXPECT_EQ(core::DifferencesOf(*loaded.segmentation, *preparation.segmentation), "");
  EXPECT_EQ(loaded.segmentation->sample_period, preparation.segmentation->sample_period);
  EXPECT_EQ(loaded.topic, preparation.topic);
  EXPECT_EQ(loaded.frame_id, preparation.frame_id);
  EXPECT_EQ(loaded.rate, preparation.rate);
  EXPECT_EQ(loaded.least_duration, preparation.least_duration);
  EXPECT_EQ(loaded.greatest_duration, preparation.greatest_duration);
  EXPECT_EQ(loaded.least_peak, preparation.least_peak);
  EXPECT_EQ(loaded.greatest_peak, preparation.greatest_peak);
}

TEST_F(ModelBagTest, ReadsAModelOfTheFirstVersionWithoutAPreparation) {
  const ShapeletModel message = ToMessage(Trained());
  const std::uint32_t added = ros::serialization::serializationLength(message.preparation);
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream output(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(output, message);
  topic_tools::ShapeShifter shape;
  shape.morph("4a3b71522a44f33cc756b9ccf6c0fec6", "contact_shapelets/ShapeletModel", "uint32 format_version\n", "");
  ros::serialization::IStream input(bytes.data(), static_cast<std::uint32_t>(bytes.size()) - added);
  shape.read(input);
  rosbag::Bag(Path("model.bag"), rosbag::bagmode::Write).write("model", ros::Time(1.0), shape);
  const core::Model loaded = LoadModel(Path("model.bag"));
  EXPECT_EQ(loaded.provenance.typical_duration, 2.17);
  EXPECT_EQ(loaded.clusters.size(), 2U);
  EXPECT_FALSE(loaded.preparation.segmentation);
}

TEST_F(ModelBagTest, IsABagWithOneModelOnItsTopic) {
  SaveModel(Path("model.bag"), Trained());
  rosbag::Bag bag(Path("model.bag"));
  rosbag::View view(bag);
  ASSERT_EQ(view.size(), 1U);
  EXPECT_EQ(view.begin()->getTopic(), "model");
  EXPECT_EQ(view.begin()->getDataType(), "contact_shapelets/ShapeletModel");
}

TEST_F(ModelBagTest, SavingReplacesTheOldModelAndLeavesNothingElse) {
  SaveModel(Path("model.bag"), Trained("old"));
  SaveModel(Path("model.bag"), Trained("new"));
  EXPECT_EQ(LoadModel(Path("model.bag")).id, "new");
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(ModelBagTest, ASaveThatRunsOutOfSpaceLeavesTheOldModelAndNoTemporary) {
  SaveModel(Path("model.bag"), Trained("old"));
  const std::string before = Contents(Path("model.bag"));
  // A limit on the size of files stands for a full disk.
  rlimit whole{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &whole), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{1024, whole.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &little), 0);
  const std::string message = MessageOf([this] { SaveModel(Path("model.bag"), Trained("new")); });
  setrlimit(RLIMIT_FSIZE, &whole);
  std::signal(SIGXFSZ, handler);
  ExpectWords(message, {Path("model.bag"), "cannot be written"});
  EXPECT_EQ(Contents(Path("model.bag")), before);
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(ModelBagTest, ASaveThatCannotReplaceItsTargetNamesItAndLeavesNoTemporary) {
  std::filesystem::create_directory(folder_ / "model.bag");
  Write(Path("model.bag/within"), "kept");
  ExpectWords(MessageOf([this] { SaveModel(Path("model.bag"), Trained()); }), {Path("model.bag"), "cannot be written"});
  EXPECT_EQ(Contents(Path("model.bag/within")), "kept");
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(ModelBagTest, ASaveIntoAFolderThatIsNotThereNamesTheFile) {
  ExpectWords(MessageOf([this] { SaveModel(Path("none/model.bag"), Trained()); }),
              {Path("none/model.bag"), "cannot be written"});
}

TEST_F(ModelBagTest, RefusesAFileThatIsNotThere) {
  ExpectWords(MessageOf([this] { LoadModel(Path("none.bag")); }), {Path("none.bag"), "ShapeletModel", "no such file"});
}

TEST_F(ModelBagTest, RefusesAFolder) {
  ExpectWords(MessageOf([this] { LoadModel(folder_.string()); }), {folder_.string(), "ShapeletModel", "not a file"});
}

TEST_F(ModelBagTest, RefusesAnEmptyFile) {
  Write(Path("model.bag"), "");
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }), {Path("model.bag"), "ShapeletModel", "is empty"});
}

TEST_F(ModelBagTest, RefusesAFileThatIsNotABag) {
  Write(Path("model.bag"), "shapelets: [1, 2, 3]\nclusters: 3\n");
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }), {Path("model.bag"), "ShapeletModel"});
}

TEST_F(ModelBagTest, RefusesAModelThatWasCutOffAnywhere) {
  SaveModel(Path("model.bag"), Trained());
  const std::string whole = Contents(Path("model.bag"));
  for (std::size_t length = 1; length < whole.size(); length += 97) {
    Write(Path("cut.bag"), whole.substr(0, length));
    ExpectWords(MessageOf([this] { LoadModel(Path("cut.bag")); }), {Path("cut.bag"), "ShapeletModel"});
  }
}

TEST_F(ModelBagTest, RefusesAModelWithAChangedByte) {
  SaveModel(Path("model.bag"), Trained());
  const std::string whole = Contents(Path("model.bag"));
  const std::size_t chunk = whole.find("compression=lz4");
  const std::size_t index = whole.find("chunk_pos=");
  ASSERT_NE(chunk, std::string::npos);
  ASSERT_NE(index, std::string::npos);
  // After the chunk's header, which takes some 40 bytes, and before its index.
  constexpr std::size_t kHeader = 60;
  constexpr std::size_t kContents = 600;
  ASSERT_GT(index, chunk + kHeader + kContents);
  for (std::size_t place = chunk + kHeader; place < chunk + kHeader + kContents; place += 23) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ 0x10);
    Write(Path("changed.bag"), changed);
    ExpectWords(MessageOf([this] { LoadModel(Path("changed.bag")); }), {Path("changed.bag"), "ShapeletModel"});
  }
}

TEST_F(ModelBagTest, RefusesABagWithoutAModel) {
  BagWriter(Path("model.bag")).Outcome(0.0, "switched");
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }), {Path("model.bag"), "ShapeletModel", "holds 0"});
}

TEST_F(ModelBagTest, RefusesABagWithTwoModels) {
  const ShapeletModel message = ToMessage(Trained());
  WriteMessages(Path("model.bag"), {message, message});
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }), {Path("model.bag"), "holds 2"});
}

TEST_F(ModelBagTest, RefusesAnotherVersionOfTheMessageByItsDigest) {
  const std::string other = "0123456789abcdef0123456789abcdef";
  WriteShape(Path("model.bag"), other, "contact_shapelets/ShapeletModel");
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }),
              {Path("model.bag"), "another version", other, ros::message_traits::md5sum<ShapeletModel>()});
}

TEST_F(ModelBagTest, RefusesAnotherFormatVersion) {
  ShapeletModel message = ToMessage(Trained());
  message.format_version = 99;
  WriteMessages(Path("model.bag"), {message});
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }),
              {Path("model.bag"), "format version 99, expected 1"});
}

TEST_F(ModelBagTest, RefusesFaultyContentsAndNamesThem) {
  ShapeletModel message = ToMessage(Trained());
  message.sample_period = -1.0;
  message.centroids[0].values.pop_back();
  WriteMessages(Path("model.bag"), {message});
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }),
              {Path("model.bag"), "the sample period is not in [0.0001, 1] s", "cluster 0 has 1 features"});
}

TEST_F(ModelBagTest, DoesNotSaveAModelThatItWouldNotLoad) {
  core::Model model = Trained();
  model.shapelets[1].dilation = 1 << 30;
  ExpectWords(MessageOf([&] { SaveModel(Path("model.bag"), model); }),
              {Path("model.bag"), "shapelet 1 reaches over more than 6000000 samples"});
  EXPECT_FALSE(std::filesystem::exists(Path("model.bag")));
}

/// The bytes of the model's message, with this number in place of the one of its shapelets.
std::vector<std::uint8_t> BytesWithShapelets(std::uint32_t number) {
  core::Model model = Trained();
  const ShapeletModel message = ToMessage(model);
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  // Before them: header, id, format version and three numbers.
  const std::size_t place = 3 * 4 + 4 + message.header.frame_id.size() + 4 + message.model_id.size() + 4 + 3 * 8;
  std::memcpy(bytes.data() + place, &number, sizeof(number));
  return bytes;
}

TEST_F(ModelBagTest, RefusesAnArrayThatIsSaidToBeLongerThanTheFile) {
  for (const std::uint32_t number : {3U, 1U << 27U, 0xFFFFFFFFU}) {
    std::vector<std::uint8_t> bytes = BytesWithShapelets(number);
    topic_tools::ShapeShifter shape;
    shape.morph(ros::message_traits::md5sum<ShapeletModel>(), ros::message_traits::datatype<ShapeletModel>(),
                ros::message_traits::definition<ShapeletModel>(), "");
    ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    shape.read(stream);
    rosbag::Bag(Path("model.bag"), rosbag::bagmode::Write).write("model", ros::Time(1.0), shape);
    // Without the memory that such an array takes, a test of this ends at once.
    rlimit whole{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &whole), 0);
    const rlimit little{rlim_t{4} << 30U, whole.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_AS, &little), 0);
    const std::string message = MessageOf([this] { LoadModel(Path("model.bag")); });
    setrlimit(RLIMIT_AS, &whole);
    ExpectWords(message, {Path("model.bag"), "ends before its last field"});
  }
}

TEST_F(ModelBagTest, NamesAClusterAndKeepsTheTimeOfTraining) {
  SaveModel(Path("model.bag"), Trained());
  const core::Model named = NameClustersInFile(Path("model.bag"), "model_1", {{0, "broken"}});
  EXPECT_EQ(named.clusters[0].label, "broken");
  const core::Model loaded = LoadModel(Path("model.bag"));
  EXPECT_EQ(loaded.clusters[0].label, "broken");
  EXPECT_EQ(loaded.clusters[1].label, "already_on");
  EXPECT_EQ(loaded.provenance.trained, Trained().provenance.trained);
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "the file of the lock was left";
}

TEST_F(ModelBagTest, DoesNotNameClustersOfAnotherModel) {
  SaveModel(Path("model.bag"), Trained("other"));
  const std::string before = Contents(Path("model.bag"));
  ExpectWords(MessageOf([this] {
                NameClustersInFile(Path("model.bag"), "model_1", {{0, "broken"}});
              }),
              {Path("model.bag"), "holds another model, other, expected model_1"});
  ExpectWords(MessageOf([this] {
                NameClustersInFile(Path("model.bag"), "other", {{2, "broken"}});
              }),
              {"there is no cluster 2"});
  EXPECT_EQ(Contents(Path("model.bag")), before);
}

TEST_F(ModelBagTest, NamesOfProcessesThatSaveAtTheSameTimeAllStay) {
  constexpr int kProcesses = 4;
  constexpr int kNamesEach = 8;
  core::Model model = Trained();
  model.clusters.assign(kProcesses * kNamesEach, model.clusters[0]);
  SaveModel(Path("model.bag"), model);
  std::vector<pid_t> processes;
  for (int process = 0; process < kProcesses; ++process) {
    processes.push_back(fork());
    if (processes.back() != 0) continue;
    const std::string fault = MessageOf([&] {
      for (int index = 0; index < kNamesEach; ++index) {
        const int cluster = kProcesses * index + process;
        NameClustersInFile(Path("model.bag"), model.id, {{cluster, "name_" + std::to_string(cluster)}});
      }
    });
    _exit(fault.empty() ? 0 : 1);
  }
  for (const pid_t process : processes) {
    int status = 0;
    waitpid(process, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const core::Model named = LoadModel(Path("model.bag"));
  for (std::size_t cluster = 0; cluster < named.clusters.size(); ++cluster) {
    EXPECT_EQ(named.clusters[cluster].label, "name_" + std::to_string(cluster));
  }
}

TEST_F(ModelBagTest, ALockThatADeadProcessLeftIsNoObstacle) {
  SaveModel(Path("model.bag"), Trained());
  Write(Path("model.bag.lock"), "");
  EXPECT_EQ(NameClustersInFile(Path("model.bag"), "model_1", {{0, "broken"}}).clusters[0].label, "broken");
}

TEST_F(ModelBagTest, RefusesLabelsThatDoNotBelongToTheClusters) {
  ShapeletModel message = ToMessage(Trained());
  message.cluster_labels.pop_back();
  WriteMessages(Path("model.bag"), {message});
  ExpectWords(MessageOf([this] { LoadModel(Path("model.bag")); }), {Path("model.bag"), "2 clusters, but 1 labels"});
}

}  // namespace
}  // namespace contact_shapelets

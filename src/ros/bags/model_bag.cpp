#include "contact_shapelets/ros/model_bag.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "ros/bags/bag_topics.h"
#include "ros/bags/bag_writer.h"
#include "ros/bags/file_lock.h"
#include "ros/bags/output_file.h"
#include "ros/messages/conversions.h"
#include "ros/messages/message_definition.h"
#include "ros/messages/names.h"
#include "ros/messages/text.h"

namespace contact_shapelets {
namespace {

/// \throws std::exception if the model is invalid or cannot be written.
void Write(const std::string& path, const core::Model& model) {
  const std::string faults = model.Faults();
  if (!faults.empty()) throw std::invalid_argument("it could not be used: " + faults);
  OutputFile file(path);
  const ros::WallTime now = ros::WallTime::now();
  BagWriter writer(file.unfinished());
  writer.bag().write(topics::kModel, ros::Time(now.sec, now.nsec), ToMessage(model));
  writer.Close();
  file.Finish();
}

/// MD5 of the message before it had a preparation. Its fields come first in the message of today.
constexpr char kFirstVersion[] = "4a3b71522a44f33cc756b9ccf6c0fec6";
/// [bytes] More than the fields added since take if they are empty.
constexpr std::size_t kAddedFields = 1024;

/// Reads a message of this version or of the first. The fields that the first lacks are zero or empty, which is how
/// they are serialised as zero bytes. \throws std::exception if the message is of another version or states an array
/// that is longer than the message.
ShapeletModel ReadMessage(const rosbag::MessageInstance& instance) {
  const std::string version = instance.getMD5Sum();
  const bool first = version == kFirstVersion;
  if (!first && version != ros::message_traits::md5sum<ShapeletModel>()) {
    throw std::invalid_argument("its message is of another version (MD5 " + version + ", expected " +
                                ros::message_traits::md5sum<ShapeletModel>() + ")");
  }
  std::vector<std::uint8_t> bytes(instance.size() + (first ? kAddedFields : 0));
  ros::serialization::OStream output(bytes.data(), instance.size());
  instance.write(output);
  const MessageDefinition definition(ros::message_traits::datatype<ShapeletModel>(),
                                     ros::message_traits::definition<ShapeletModel>());
  definition.CheckLengths(bytes.data(), bytes.size());
  ros::serialization::IStream input(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ShapeletModel message;
  ros::serialization::deserialize(input, message);
  return message;
}

}  // namespace

void SaveModel(const std::string& path, const core::Model& model) {
  try {
    // The lock keeps NameClustersInFile() from writing the old model back.
    const FileLock lock(path);
    Write(path, model);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": the model cannot be written: " + OneLine(error.what()));
  }
}

core::Model LoadModel(const std::string& path) {
  rosbag::Bag bag;
  OpenBag(path, &bag, "a bag with one contact_shapelets/ShapeletModel");
  try {
    rosbag::View view(bag, rosbag::TypeQuery("contact_shapelets/ShapeletModel"));
    if (view.size() != 1) throw std::invalid_argument("it holds " + std::to_string(view.size()) + " of them");
    const rosbag::MessageInstance instance = *view.begin();
    return FromMessage(ReadMessage(instance));
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": expected a bag with one contact_shapelets/ShapeletModel, but " +
                             OneLine(error.what()));
  }
}

core::Model NameClustersInFile(const std::string& path, const std::string& model_id,
                               const std::map<int, std::string>& names) {
  const FileLock lock(path);
  core::Model model = LoadModel(path);
  // A training may have replaced the model. The names do not fit another one.
  if (model.id != model_id) {
    throw std::runtime_error(path + " holds another model, " + model.id + ", expected " + model_id);
  }
  for (const auto& [cluster, name] : names) {
    if (cluster < 0 || cluster >= static_cast<int>(model.clusters.size())) {
      throw std::runtime_error(path + ": there is no cluster " + std::to_string(cluster));
    }
    model.clusters[static_cast<std::size_t>(cluster)].label = name;
  }
  try {
    Write(path, model);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": the model cannot be written: " + OneLine(error.what()));
  }
  return model;
}

}  // namespace contact_shapelets

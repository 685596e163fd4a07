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

/// \throws std::runtime_error if the message states an array that is longer than the message.
void CheckLengths(const rosbag::MessageInstance& instance) {
  std::vector<std::uint8_t> bytes(instance.size());
  ros::serialization::OStream stream(bytes.data(), instance.size());
  instance.write(stream);
  const MessageDefinition definition(ros::message_traits::datatype<ShapeletModel>(),
                                     ros::message_traits::definition<ShapeletModel>());
  definition.CheckLengths(bytes.data(), bytes.size());
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
    if (instance.getMD5Sum() != ros::message_traits::md5sum<ShapeletModel>()) {
      throw std::invalid_argument("its message is of another version (MD5 " + instance.getMD5Sum() + ", expected " +
                                  ros::message_traits::md5sum<ShapeletModel>() + ")");
    }
    CheckLengths(instance);
    return FromMessage(*instance.instantiate<ShapeletModel>());
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

#include "contact_shapelets/ros/model_bag.h"

#include <fcntl.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include "ros/bags/bag_topics.h"
#include "ros/bags/output_file.h"
#include "ros/messages/conversions.h"
#include "ros/messages/text.h"
#include "ros/messages/topics.h"

namespace contact_shapelets {
namespace {

/// Waits until the file is on the disk, so that a rename never leaves an empty one behind.
void Synchronise(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY);
  if (descriptor < 0) throw std::runtime_error(path + ": cannot be opened again");
  const bool well = fsync(descriptor) == 0;
  close(descriptor);
  if (!well) throw std::runtime_error(path + ": cannot be written to the disk");
}

}  // namespace

void SaveModel(const std::string& path, const core::Model& model) {
  const std::string temporary = TemporaryName(path);
  try {
    const ros::WallTime now = ros::WallTime::now();
    const ros::Time stamp(now.sec, now.nsec);
    rosbag::Bag bag(temporary, rosbag::bagmode::Write);
    // Compressed for its checksum: a damaged model is refused instead of being believed.
    bag.setCompression(rosbag::compression::LZ4);
    bag.write(topics::kModel, stamp, ToMessage(model, stamp));
    bag.close();
    Synchronise(temporary);
    if (std::rename(temporary.c_str(), path.c_str()) != 0) throw std::runtime_error("it cannot be replaced");
  } catch (const std::exception& error) {
    std::remove(temporary.c_str());
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
    const ShapeletModel::ConstPtr message = instance.instantiate<ShapeletModel>();
    if (!message) {
      throw std::invalid_argument("its message is of another version (MD5 " + instance.getMD5Sum() + ", expected " +
                                  ros::message_traits::md5sum<ShapeletModel>() + ")");
    }
    return FromMessage(*message);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": expected a bag with one contact_shapelets/ShapeletModel, but " +
                             OneLine(error.what()));
  }
}

}  // namespace contact_shapelets

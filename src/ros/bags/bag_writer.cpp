#include "ros/bags/bag_writer.h"

namespace contact_shapelets {

BagWriter::BagWriter(const std::string& path) : bag_(std::make_unique<rosbag::Bag>(path, rosbag::bagmode::Write)) {
  bag_->setCompression(rosbag::compression::LZ4);
}

BagWriter::~BagWriter() {
  try {
    bag_->close();
  } catch (const std::exception&) {
    // It stays open, and its destructor would throw as well. One lost descriptor is the lesser harm.
    static_cast<void>(bag_.release());
  }
}

}  // namespace contact_shapelets

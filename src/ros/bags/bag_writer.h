#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <string>

namespace contact_shapelets {

/// A bag that is written with LZ4 compression, whose checksums let a reader refuse damaged parts. If writing fails, as
/// on a full disk, the library's own destructor would write again, throw, and end the process. This one does not.
class BagWriter {
 public:
  /// Creates the bag at `path`. \throws rosbag::BagException if it cannot.
  explicit BagWriter(const std::string& path);
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// The bag to write to.
  rosbag::Bag& bag() { return *bag_; }
  /// Writes the index and closes the bag. \throws rosbag::BagException if it cannot.
  void Close() { bag_->close(); }

 private:
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace contact_shapelets

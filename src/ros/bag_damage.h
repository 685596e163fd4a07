#pragma once

#include <console_bridge/console.h>

#include <string>

namespace contact_shapelets {

/// Takes what rosbag's library says of a damaged bag, message by message, while this exists, and says it in one line at
/// the end. To be made before the bag is opened, which reads its index. Bags are read one at a time, since the
/// library's log is the process's.
class BagDamage : public console_bridge::OutputHandler {
 public:
  /// For the bag `path`.
  explicit BagDamage(std::string path);
  /// Logs one error with the path where the library left out a part and went on.
  ~BagDamage() override;
  BagDamage(const BagDamage&) = delete;
  BagDamage& operator=(const BagDamage&) = delete;

  /// Keeps the first error.
  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override;

 private:
  std::string path_;
  console_bridge::OutputHandler* outer_;
  std::string first_;
};

}  // namespace contact_shapelets

#pragma once

#include <console_bridge/console.h>

#include <functional>
#include <optional>
#include <string>

namespace contact_shapelets {

/// Takes the errors that rosbag's library logs, while this exists. Other messages go where they went before. The
/// library's log is the process's, so that the one made last is the first to go.
class BagLog : public console_bridge::OutputHandler {
 public:
  /// Calls `take` with each error.
  explicit BagLog(std::function<void(const std::string&)> take);
  ~BagLog() override;
  BagLog(const BagLog&) = delete;
  BagLog& operator=(const BagLog&) = delete;

  /// Called by the library.
  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override;

 private:
  std::function<void(const std::string&)> take_;
  console_bridge::OutputHandler* outer_;
};

/// Says in one line at the end what the library says of a damaged bag, message by message, while this exists. To be
/// made before the bag is opened, which reads its index. Bags are read one at a time.
class BagDamage {
 public:
  /// For the bag `path`.
  explicit BagDamage(const std::string& path);
  /// Logs one error with the path where the library left out a part and went on.
  ~BagDamage();
  BagDamage(const BagDamage&) = delete;
  BagDamage& operator=(const BagDamage&) = delete;

 private:
  std::string path_;
  std::string first_;
  std::optional<BagLog> log_;
};

}  // namespace contact_shapelets

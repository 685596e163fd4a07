#pragma once

#include <console_bridge/console.h>

#include <functional>
#include <optional>
#include <string>

namespace contact_shapelets {

/// Takes the errors that rosbag's library logs, as long as this object lives. Other messages go where they went before.
/// The process has one such log: destroy the newest object first.
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

/// Reports the damage of a bag in one line, where the library logs one for each message. Make it before you open the
/// bag, because opening reads the index. Read one bag at a time.
class BagDamage {
 public:
  /// Watches the reading of the bag `path`.
  explicit BagDamage(const std::string& path);
  /// Logs one error with the path if the library left out a part of the bag.
  ~BagDamage();
  BagDamage(const BagDamage&) = delete;
  BagDamage& operator=(const BagDamage&) = delete;

 private:
  std::string path_;
  std::string first_;
  std::optional<BagLog> log_;
};

}  // namespace contact_shapelets

#include "ros/bags/bag_damage.h"

#include <exception>
#include <utility>

#include "ros/messages/text.h"

namespace contact_shapelets {

BagLog::BagLog(std::function<void(const std::string&)> take)
    : take_(std::move(take)), outer_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

BagLog::~BagLog() { console_bridge::useOutputHandler(outer_); }

void BagLog::log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) {
  if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
    take_(text);
  } else if (outer_ != nullptr) {
    outer_->log(text, level, file, line);
  }
}

BagDamage::BagDamage(const std::string& path) : path_(path) {
  log_.emplace([this](const std::string& text) {
    if (first_.empty()) first_ = text;
  });
}

BagDamage::~BagDamage() {
  log_.reset();
  // An exception reports the damage itself.
  if (first_.empty() || std::uncaught_exceptions() > 0) return;
  CONSOLE_BRIDGE_logError("%s: the bag is damaged, and a part was left out: %s", path_.c_str(),
                          OneLine(first_).c_str());
}

}  // namespace contact_shapelets

#include "ros/bag_damage.h"

#include <exception>
#include <utility>

#include "ros/text.h"

namespace contact_shapelets {

BagDamage::BagDamage(std::string path) : path_(std::move(path)), outer_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

BagDamage::~BagDamage() {
  console_bridge::useOutputHandler(outer_);
  // An exception says of its own what is wrong with the bag.
  if (first_.empty() || std::uncaught_exceptions() > 0) return;
  CONSOLE_BRIDGE_logError("%s: the bag is damaged, and a part was left out: %s", path_.c_str(),
                          OneLine(first_).c_str());
}

void BagDamage::log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/, int /*line*/) {
  if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
}

}  // namespace contact_shapelets

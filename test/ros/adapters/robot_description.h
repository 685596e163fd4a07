#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace contact_shapelets::test {

/// The text of a URDF file of this folder. \throws std::runtime_error if there is no such file.
inline std::string RobotDescription(const std::string& name) {
  const std::string path = "test/ros/adapters/" + name;
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace contact_shapelets::test

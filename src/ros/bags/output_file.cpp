#include "ros/bags/output_file.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "ros/bags/bag_topics.h"

namespace contact_shapelets {

namespace filesystem = std::filesystem;

void CheckOutput(const std::string& what, const std::string& path, const std::vector<std::string>& bags) {
  std::error_code ignored;
  const filesystem::path folder = filesystem::path(path).parent_path();
  const std::string folder_name = folder.empty() ? "." : folder.string();
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(what + (path.empty() ? "" : " ") + path + ": " + why);
  };
  if (path.empty()) refuse("expected the path of a file to write, but it is empty");
  if (!filesystem::is_directory(folder_name, ignored)) refuse("there is no folder " + folder_name);
  if (filesystem::is_directory(path, ignored)) refuse("expected a file, but it is a folder");
  if (access(folder_name.c_str(), W_OK) != 0) refuse("the folder " + folder_name + " cannot be written to");
  if (filesystem::exists(path, ignored) && access(path.c_str(), W_OK) != 0) refuse("it is there, and write-protected");
  for (const std::string& bag : bags) {
    if (filesystem::equivalent(path, bag, ignored)) refuse("it is one of the bags that are read; choose another name");
  }
}

void CheckModelOutput(const std::string& what, const std::string& path, const std::vector<std::string>& bags) {
  CheckOutput(what, path, bags);
  std::error_code ignored;
  if (!filesystem::exists(path, ignored)) return;
  rosbag::Bag bag;
  OpenBag(path, &bag, "a new file or an older model");
  if (BagTopics(bag).OfType("contact_shapelets/ShapeletModel").empty()) {
    throw std::runtime_error(what + ' ' + path + ": expected a new file or an older model, but found another bag; " +
                             "choose another name");
  }
}

std::string TemporaryName(const std::string& path) { return path + ".part" + std::to_string(getpid()); }

}  // namespace contact_shapelets

#include <rosbag/view.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "ros/bags/bag_topics.h"
#include "ros/bags/output_file.h"

namespace contact_shapelets {

namespace filesystem = std::filesystem;

namespace {

/// Returns true if both names mean the same file, whether it exists or not.
bool AreOneFile(const std::string& first, const std::string& second) {
  if (first.empty() || second.empty()) return false;
  std::error_code error;
  if (filesystem::equivalent(first, second, error)) return true;
  const filesystem::path whole_first = filesystem::weakly_canonical(filesystem::absolute(first), error);
  return !error && whole_first == filesystem::weakly_canonical(filesystem::absolute(second), error) && !error;
}

bool IsAmong(const std::string& path, const std::vector<std::string>& paths) {
  return std::any_of(paths.begin(), paths.end(), [&path](const std::string& other) { return AreOneFile(path, other); });
}

[[noreturn]] void Refuse(const std::string& what, const std::string& path, const std::string& why) {
  throw std::runtime_error(what + (path.empty() ? "" : " ") + path + ": " + why);
}

}  // namespace

void CheckOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                 const std::vector<std::string>& written) {
  std::error_code ignored;
  const filesystem::path folder = filesystem::path(path).parent_path();
  const std::string folder_name = folder.empty() ? "." : folder.string();
  const auto refuse = [&](const std::string& why) { Refuse(what, path, why); };
  if (path.empty()) refuse("expected the path of a file to write, but it is empty");
  if (!filesystem::is_directory(folder_name, ignored)) refuse("there is no folder " + folder_name);
  if (filesystem::is_directory(path, ignored)) refuse("expected a file, but it is a folder");
  const bool direct = filesystem::exists(path, ignored) && !filesystem::is_regular_file(path, ignored);
  if (!direct && access(folder_name.c_str(), W_OK) != 0) {
    refuse("the folder " + folder_name + " cannot be written to");
  }
  if (filesystem::exists(path, ignored) && access(path.c_str(), W_OK) != 0) refuse("it is there, and write-protected");
  if (IsAmong(path, read)) refuse("it is one of the files that are read; choose another name");
  if (IsAmong(path, written)) refuse("another output goes to the same file; choose another name");
}

void CheckTextOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                     const std::vector<std::string>& written) {
  CheckOutput(what, path, read, written);
  std::error_code ignored;
  if (!filesystem::is_regular_file(path, ignored)) return;
  std::string start(9, '\0');
  std::ifstream(path).read(&start[0], static_cast<std::streamsize>(start.size()));
  if (start == "#ROSBAG V") Refuse(what, path, "there is a bag already; choose another name");
}

void CheckBagOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                    const std::vector<std::string>& written) {
  CheckOutput(what, path, read, written);
  std::error_code ignored;
  if (filesystem::exists(path, ignored) && !filesystem::is_regular_file(path, ignored)) {
    Refuse(what, path, "expected a file, but it is a device or a pipe");
  }
}

void CheckModelOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read) {
  CheckBagOutput(what, path, read);
  std::error_code ignored;
  if (!filesystem::exists(path, ignored)) return;
  rosbag::Bag bag;
  OpenBag(path, &bag, "a new file or an older model");
  rosbag::View view(bag);
  // A recording may also hold models.
  const bool model = view.size() == 1 && view.begin()->getDataType() == "contact_shapelets/ShapeletModel";
  if (!model) {
    Refuse(what, path, "expected a new file or an older model, but found another bag; choose another name");
  }
}

}  // namespace contact_shapelets

// The core is plain C++: it must build and run where there is no ROS.
#include <gtest/gtest.h>
#include <link.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "contact_shapelets/core/parallel.h"

namespace {

/// "file:line: text" of each line of the files under `folder` that includes a header of ROS or of this package's ROS
/// part.
std::vector<std::string> RosIncludes(const std::filesystem::path& folder, int* files) {
  const std::regex include(
      R"(^\s*#\s*include\s*[<"](ros/|ros\.h|rosbag/|roscpp|\w+_msgs/|std_srvs/|actionlib|diagnostic_updater/|topic_tools/)"
      R"(|xmlrpcpp/|XmlRpc|contact_shapelets/(?!core/)).*)");
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    ++*files;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      if (std::regex_search(line, include)) {
        found.push_back(entry.path().string() + ":" + std::to_string(number) + ": " + line);
      }
    }
  }
  return found;
}

/// Names of the libraries that `library` was linked with.
std::vector<std::string> LinkedLibraries(const struct link_map& library) {
  const char* strings = nullptr;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader's interface.
    if (entry->d_tag == DT_STRTAB) strings = reinterpret_cast<const char*>(entry->d_un.d_ptr);
  }
  std::vector<std::string> names;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_NEEDED) names.emplace_back(strings + entry->d_un.d_val);
  }
  return names;
}

TEST(Core, IncludesNoRos) {
  int files = 0;
  for (const char* folder : {"src/core", "include/contact_shapelets/core"}) {
    EXPECT_EQ(RosIncludes(folder, &files), std::vector<std::string>());
  }
  EXPECT_GT(files, 30) << "the test looks at the wrong place";
}

TEST(Core, TheSearchFindsTheIncludesOfTheRosPart) {
  int files = 0;
  EXPECT_GT(RosIncludes("src/ros", &files).size(), 10U);
}

TEST(Core, LinksNoRosLibrary) {
  ASSERT_GE(contact_shapelets::core::ThreadCount(0), 1) << "a call, so that the linker keeps the library";
  const struct link_map* library = _r_debug.r_map;
  while (library != nullptr && std::string(library->l_name).find("libcontact_shapelets_core") == std::string::npos) {
    library = library->l_next;
  }
  ASSERT_NE(library, nullptr);
  const std::vector<std::string> linked = LinkedLibraries(*library);
  ASSERT_FALSE(linked.empty());
  const std::regex ros(
      "libros|libxmlrpc|libactionlib|libdiagnostic|libtopic_tools|libcpp_common|librosbag|libconsole_bridge");
  for (const std::string& name : linked) EXPECT_FALSE(std::regex_search(name, ros)) << name;
}

}  // namespace

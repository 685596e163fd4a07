// Tests the architecture: the core is plain C++ and runs without ROS, and each room uses only rooms below it.
#include <gtest/gtest.h>
#include <link.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "core/numerics/parallel.h"

namespace {

/// An `#include` line.
struct Include {
  std::string file;  ///< path of the file with this line, from the package's root
  int line = 0;
  std::string header;  ///< the text between the quotes or brackets
};

std::vector<Include> IncludesIn(const std::string& folder) {
  const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      std::smatch match;
      if (std::regex_search(line, match, pattern)) includes.push_back({entry.path().string(), number, match[1]});
    }
  }
  return includes;
}

/// Returns the height of each room. A file may include from lower rooms and from its own.
const std::map<std::string, int>& Heights() {
  static const std::map<std::string, int> heights{
      {"core/numerics", 0},   {"core/change_points", 1}, {"core/stream", 1},  {"core/matching", 1},
      {"core/clustering", 1}, {"core/learning", 2},      {"core/model", 3},   {"core/drift", 4},
      {"evaluation", 4},      {"ros/messages", 5},       {"ros/adapters", 6}, {"ros/bags", 7},
      {"ros/parameters", 7},  {"ros/nodes", 8},          {"nodes", 9},        {"cli", 9},
  };
  return heights;
}

/// Returns the room of each public header: that of the source that implements it, or the lowest room that needs it.
const std::map<std::string, std::string>& RoomsOfPublicHeaders() {
  static const std::map<std::string, std::string> rooms{
      {"core/cancelled.h", "core/numerics"},
      {"core/classifier.h", "core/model"},
      {"core/episode.h", "core/numerics"},
      {"core/episode_edge.h", "core/stream"},
      {"core/feature_extractor.h", "core/model"},
      {"core/finding.h", "core/numerics"},
      {"core/learner_options.h", "core/learning"},
      {"core/model.h", "core/model"},
      {"core/preparation.h", "core/model"},
      {"core/segmentation_options.h", "core/stream"},
      {"core/shapelet.h", "core/numerics"},
      {"core/stream_summary.h", "core/stream"},
      {"core/time.h", "core/numerics"},
      {"core/trainer.h", "core/model"},
      {"core/wrench_stream.h", "core/stream"},
      {"ros/episode_bag_reader.h", "ros/bags"},
      {"ros/model_bag.h", "ros/bags"},
      {"ros/wrench_source.h", "ros/adapters"},
  };
  return rooms;
}

/// Returns the room of a file by its path below src/ or include/; an empty string if it is in none.
std::string RoomOf(const std::string& path) {
  const std::string own = "contact_shapelets/";
  if (path.compare(0, own.size(), own) == 0) {
    const auto found = RoomsOfPublicHeaders().find(path.substr(own.size()));
    return found == RoomsOfPublicHeaders().end() ? "" : found->second;
  }
  for (const auto& [room, height] : Heights()) {
    if (path.compare(0, room.size() + 1, room + "/") == 0) return room;
  }
  return "";
}

/// Returns "file:line: header" for each of `includes` that leads to another room that is not lower.
std::vector<std::string> WrongArrows(const std::vector<Include>& includes) {
  std::vector<std::string> wrong;
  for (const Include& include : includes) {
    const std::string from = RoomOf(include.file.substr(include.file.find('/') + 1));
    const std::string to = RoomOf(include.header);
    if (to.empty() || from == to) continue;
    if (from.empty() || Heights().at(to) >= Heights().at(from)) {
      wrong.push_back(include.file + ":" + std::to_string(include.line) + ": " + include.header);
    }
  }
  return wrong;
}

/// Returns "file:line: header" for each of `includes` that names a header of ROS or of this package's ROS part.
std::vector<std::string> RosIncludes(const std::vector<Include>& includes) {
  const std::regex ros(
      R"(^(ros/|ros\.h|rosbag/|roscpp|\w+_msgs/|std_srvs/|actionlib|diagnostic_updater/|topic_tools/|xmlrpcpp/|XmlRpc)"
      R"(|contact_shapelets/(?!core/)))");
  std::vector<std::string> found;
  for (const Include& include : includes) {
    if (std::regex_search(include.header, ros)) {
      found.push_back(include.file + ":" + std::to_string(include.line) + ": " + include.header);
    }
  }
  return found;
}

/// Returns the names of the libraries that `library` is linked with.
std::vector<std::string> LinkedLibraries(const struct link_map& library) {
  const char* strings = nullptr;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives an integer.
    if (entry->d_tag == DT_STRTAB) strings = reinterpret_cast<const char*>(entry->d_un.d_ptr);
  }
  std::vector<std::string> names;
  for (const ElfW(Dyn)* entry = library.l_ld; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_NEEDED) names.emplace_back(strings + entry->d_un.d_val);
  }
  return names;
}

TEST(Rooms, UseOnlyRoomsBelowThem) {
  std::vector<Include> includes = IncludesIn("src");
  EXPECT_GT(includes.size(), 500U) << "the test looks at the wrong place";
  for (const Include& include : IncludesIn("include")) includes.push_back(include);
  EXPECT_EQ(WrongArrows(includes), std::vector<std::string>());
}

TEST(Rooms, AnArrowUpwardOrSidewaysIsFound) {
  const std::vector<Include> up{{"src/core/matching/a.cpp", 1, "core/learning/objective.h"}};
  const std::vector<Include> sideways{{"src/core/matching/a.cpp", 1, "core/stream/resampler.h"}};
  const std::vector<Include> published{
      {"include/contact_shapelets/core/model.h", 1, "contact_shapelets/core/trainer.h"},
      {"src/core/stream/a.h", 2, "contact_shapelets/core/model.h"}};
  EXPECT_EQ(WrongArrows(up).size(), 1U);
  EXPECT_EQ(WrongArrows(sideways).size(), 1U);
  EXPECT_EQ(WrongArrows(published).size(), 1U) << "headers of one room may include each other";
}

TEST(Rooms, EveryFileIsInOne) {
  for (const char* folder : {"src", "include"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string path = entry.path().string();
      if (!entry.is_regular_file()) continue;
      EXPECT_NE(RoomOf(path.substr(path.find('/') + 1)), "") << path;
    }
  }
}

TEST(PublicHeaders, IncludeNoPrivateOne) {
  for (const Include& include : IncludesIn("include")) {
    EXPECT_TRUE(include.header.compare(0, 18, "contact_shapelets/") == 0 || RoomOf(include.header).empty())
        << include.file << ": " << include.header;
  }
}

TEST(Core, IncludesNoRos) {
  EXPECT_EQ(RosIncludes(IncludesIn("src/core")), std::vector<std::string>());
  EXPECT_EQ(RosIncludes(IncludesIn("src/evaluation")), std::vector<std::string>());
  EXPECT_EQ(RosIncludes(IncludesIn("include/contact_shapelets/core")), std::vector<std::string>());
}

TEST(Core, TheSearchFindsTheIncludesOfTheRosPart) { EXPECT_GT(RosIncludes(IncludesIn("src/ros")).size(), 10U); }

TEST(Core, LinksNoRosLibrary) {
  // Without a call, the linker would leave out the library.
  ASSERT_GE(contact_shapelets::core::ThreadCount(0), 1);
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

/// The offline program reads a parameter file as rosparam does.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "ros/parameters/parameters.h"

namespace contact_shapelets::test {
namespace {

/// Returns the value of `name` as a reader gives it for each type.
template <typename Value>
std::string Reading(ParameterReader reader, const std::string& name, Value value) {
  reader.Read(name, &value);
  std::ostringstream text;
  text.precision(17);
  if constexpr (std::is_same_v<Value, std::vector<double>>) {
    for (const double item : value) text << item << ' ';
  } else {
    text << value;
  }
  return text.str() + "; " + reader.Faults();
}

TEST(ParameterFile, ReadsTheSameByRosparamAndWithoutRos) {
  std::string file;
  ASSERT_TRUE(ros::param::get("/paths/spellings", file));
  const auto by_rosparam = [] { return ParameterReader(ros::NodeHandle("/spellings")); };
  const auto by_file = [&file] { return ParameterReader::FromYaml({file}); };
  const std::vector<std::string> names = by_file().Unread();
  ASSERT_EQ(names, by_rosparam().Unread());
  EXPECT_GT(names.size(), 40U);
  for (const std::string& name : names) {
    EXPECT_EQ(Reading(by_file(), name, false), Reading(by_rosparam(), name, false)) << name;
    EXPECT_EQ(Reading(by_file(), name, -7), Reading(by_rosparam(), name, -7)) << name;
    EXPECT_EQ(Reading(by_file(), name, -7.5), Reading(by_rosparam(), name, -7.5)) << name;
    EXPECT_EQ(Reading(by_file(), name, std::string("-")), Reading(by_rosparam(), name, std::string("-"))) << name;
    EXPECT_EQ(Reading(by_file(), name, std::vector<double>()), Reading(by_rosparam(), name, std::vector<double>()))
        << name;
  }
}

}  // namespace
}  // namespace contact_shapelets::test

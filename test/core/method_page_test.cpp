// docs/method.md leads to functions that exist.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

std::string Contents(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(MethodPage, NamesEachFunctionInTheFileThatHasIt) {
  const std::string page = Contents("docs/method.md");
  const std::regex reference(R"(`((?:\w+::)?(\w+))\(\)`\s+in\s+`([^`]+)`)");
  int count = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), reference); match != std::sregex_iterator(); ++match) {
    const std::string file = Contents((*match)[3]);
    EXPECT_FALSE(file.empty()) << (*match)[3] << " is not there";
    // In a class's header its functions stand without its name.
    const bool header = (*match)[3].str().find(".h") != std::string::npos;
    const std::string name = header ? (*match)[2].str() : (*match)[1].str();
    EXPECT_NE(file.find(name + "("), std::string::npos) << (*match)[3] << " has no " << name << "()";
    ++count;
  }
  EXPECT_GT(count, 20) << "the test no longer understands the page";
}

}  // namespace

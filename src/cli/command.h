#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace contact_shapelets::cli {

/// The command line is wrong: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One command of the program, such as `train`.
struct Command {
  std::string name;
  std::string description;  ///< for --help
  std::string usage;        ///< the arguments after the name: "BAG... --model OUT.bag"
  boost::program_options::options_description options;
  boost::program_options::options_description
      places;  ///< the positional arguments, which have no name on the command line
  boost::program_options::positional_options_description positional;
  std::function<int()> run;  ///< runs after the options have their values; returns the exit status
};

/// Parses the arguments after the command's name, then runs it or prints its help. Returns the exit status. \throws
/// UsageError
int RunCommand(const Command& command, const std::vector<std::string>& arguments);

/// Returns the names in "A,B,C", the value of `option`. \throws UsageError naming `option` if a name is empty.
std::vector<std::string> SplitAtCommas(const std::string& option, const std::string& text);

/// Returns a check of an option's value. It throws UsageError naming `option` if the value is not one of `words`.
std::function<void(const std::string&)> OneOf(const std::string& option, const std::vector<std::string>& words);

/// Returns a check of an option's value. It throws UsageError naming `option` if the value is not in [least, greatest].
std::function<void(int)> InRange(const std::string& option, int least, int greatest);

}  // namespace contact_shapelets::cli

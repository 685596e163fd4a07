#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace contact_shapelets::cli {

/// The command line is not as it has to be: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One command of the program, such as `train`.
struct Command {
  std::string name;
  std::string description;  ///< for --help
  std::string usage;        ///< what follows the name: "BAG... --model OUT.bag"
  boost::program_options::options_description options;
  boost::program_options::options_description places;  ///< of `positional`, which have no name on the command line
  boost::program_options::positional_options_description positional;
  std::function<int()> run;  ///< once the arguments are where the options say; returns the exit status
};

/// Parses what follows the command's name and runs it, or prints its help. Returns the exit status. \throws UsageError
int RunCommand(const Command& command, const std::vector<std::string>& arguments);

/// The names in "A,B,C", the value of `option`. \throws UsageError naming it where a name is empty.
std::vector<std::string> SplitAtCommas(const std::string& option, const std::string& text);

/// A check of an option's value. \throws UsageError naming `option` where the value is not one of `words`.
std::function<void(const std::string&)> OneOf(const std::string& option, const std::vector<std::string>& words);

/// A check of an option's value. \throws UsageError naming `option` where the value is not in [least, greatest].
std::function<void(int)> InRange(const std::string& option, int least, int greatest);

}  // namespace contact_shapelets::cli

#include "cli/command.h"

#include <algorithm>
#include <iostream>
#include <sstream>

#include "cli/text.h"

namespace contact_shapelets::cli {

namespace po = boost::program_options;

namespace {

/// \throws UsageError if a positional argument was given by a name.
void RefuseNamedPlaces(const Command& command, const po::parsed_options& parsed) {
  for (const po::option& option : parsed.options) {
    const bool by_name = option.position_key < 0;
    if (by_name && command.places.find_nothrow(option.string_key, false) != nullptr) {
      throw UsageError(command.name + ": expected " + command.usage + ", but found --" + option.string_key);
    }
  }
}

}  // namespace

int RunCommand(const Command& command, const std::vector<std::string>& arguments) {
  po::options_description shown = command.options;
  shown.add_options()("help,h", "Prints this help");
  po::options_description all;
  all.add(shown).add(command.places);
  po::variables_map values;
  try {
    const po::parsed_options parsed =
        po::command_line_parser(arguments)
            .options(all)
            .positional(command.positional)
            // Only whole names: a new option could break an abbreviation in a user's script.
            .style(po::command_line_style::default_style & ~po::command_line_style::allow_guessing)
            .run();
    RefuseNamedPlaces(command, parsed);
    po::store(parsed, values);
    if (values.count("help") > 0) {
      std::cout << command.description << "\nUsage: shapelets " << command.name << ' ' << command.usage << '\n'
                << shown;
      return 0;
    }
    po::notify(values);
  } catch (const po::required_option& missing) {
    const std::string option = missing.get_option_name();
    throw UsageError(command.name + ": expected " + command.usage + ", but " +
                     option.substr(option.find_first_not_of('-')) + " is missing");
  } catch (const po::unknown_option& unknown) {
    std::vector<std::string> names;
    for (const auto& option : shown.options()) names.push_back("--" + option->long_name());
    const std::string likely = Likely(unknown.get_option_name(), names);
    throw UsageError(command.name + ": " + unknown.what() + (likely.empty() ? "" : "; did you mean " + likely + "?"));
  } catch (const po::error& error) {
    throw UsageError(command.name + ": " + error.what());
  }
  return command.run();
}

std::vector<std::string> SplitAtCommas(const std::string& option, const std::string& text) {
  std::vector<std::string> names;
  // An empty name also follows a comma at the end.
  std::istringstream stream(text + ',');
  for (std::string name; std::getline(stream, name, ',');) {
    if (name.empty()) throw UsageError(option + " must be names separated by commas, but is \"" + text + '"');
    names.push_back(name);
  }
  return names;
}

std::function<void(const std::string&)> OneOf(const std::string& option, const std::vector<std::string>& words) {
  return [option, words](const std::string& value) {
    if (std::find(words.begin(), words.end(), value) != words.end()) return;
    throw UsageError(option + " must be one of " + Joined(words, ", ") + ", but is " + value);
  };
}

std::function<void(int)> InRange(const std::string& option, int least, int greatest) {
  return [option, least, greatest](int value) {
    if (value >= least && value <= greatest) return;
    throw UsageError(option + " must be from " + std::to_string(least) + " to " + std::to_string(greatest) +
                     ", but is " + std::to_string(value));
  };
}

}  // namespace contact_shapelets::cli

#include <console_bridge/console.h>
#include <ros/time.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/classify_command.h"
#include "cli/command.h"
#include "cli/drift_command.h"
#include "cli/evaluate_command.h"
#include "cli/inspect_command.h"
#include "cli/name_command.h"
#include "cli/report_command.h"
#include "cli/segment_command.h"
#include "cli/text.h"
#include "cli/train_command.h"
#include "ros/bags/bag_damage.h"
#include "ros/bags/output_file.h"
#include "ros/messages/text.h"

namespace {

using contact_shapelets::cli::Command;

constexpr int kBadInput = 1;
constexpr int kWrongUsage = 2;

/// Keeps the errors about damaged bags as long as this object lives, so that they do not mix with the progress line.
class BagErrors {
 public:
  void Print() const {
    for (const std::string& line : lines_) std::cerr << "shapelets: " << line << '\n';
  }

 private:
  void Take(const std::string& text) {
    const std::string line = contact_shapelets::OneLine(text);
    // A command may read a bag twice.
    if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
  }

  std::vector<std::string> lines_;
  contact_shapelets::BagLog log_{[this](const std::string& text) { Take(text); }};
};

int PrintHelp(const std::vector<Command>& commands) {
  std::cout << "Learns force patterns from recorded episodes, and names the outcome of new ones.\n"
               "Usage: shapelets COMMAND ... (shapelets COMMAND --help lists its options)\n";
  for (const Command& command : commands) {
    std::cout << "  " << contact_shapelets::cli::Padded(command.name, 10) << command.description << '\n';
  }
  return 0;
}

int Run(const std::vector<Command>& commands, const std::vector<std::string>& arguments) {
  const std::string name = arguments.empty() ? "none" : arguments.front();
  if (name == "--help" || name == "-h") return PrintHelp(commands);
  if (name == "--version") {
    std::cout << "shapelets " << SHAPELETS_VERSION << '\n';
    return 0;
  }
  const auto command =
      std::find_if(commands.begin(), commands.end(), [&name](const Command& other) { return other.name == name; });
  if (command != commands.end()) return RunCommand(*command, {arguments.begin() + 1, arguments.end()});
  std::vector<std::string> names;
  for (const Command& other : commands) names.push_back(other.name);
  const std::string likely = contact_shapelets::cli::Likely(name, names);
  throw contact_shapelets::cli::UsageError("expected one of the commands " +
                                           contact_shapelets::cli::Joined(names, ", ") + ", but found " + name +
                                           (likely.empty() ? "" : "; did you mean " + likely + "?"));
}

}  // namespace

int main(int argc, char** argv) {
  const contact_shapelets::RemovalOnSignals removal;
  // `shapelets ... | head` closes the pipe early; the files that a command writes are finished all the same.
  std::signal(SIGPIPE, SIG_IGN);
  ros::Time::init();
  // Some versions of librosbag warn of their own plugins after a write that failed.
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  BagErrors bag_errors;
  try {
    const int status = Run({contact_shapelets::cli::TrainCommand(), contact_shapelets::cli::ClassifyCommand(),
                            contact_shapelets::cli::EvaluateCommand(), contact_shapelets::cli::InspectCommand(),
                            contact_shapelets::cli::NameCommand(), contact_shapelets::cli::ReportCommand(),
                            contact_shapelets::cli::SegmentCommand(), contact_shapelets::cli::DriftCommand()},
                           {argv + 1, argv + argc});
    bag_errors.Print();
    std::cout.flush();
    if (std::fflush(stdout) != 0 || !std::cout) throw std::runtime_error("the results cannot be written to stdout");
    return status;
  } catch (const contact_shapelets::cli::UsageError& error) {
    std::cerr << "shapelets: " << contact_shapelets::OneLine(error.what()) << " (see shapelets --help)\n";
    return kWrongUsage;
  } catch (const std::exception& error) {
    bag_errors.Print();
    std::cerr << "shapelets: " << contact_shapelets::OneLine(error.what()) << '\n';
    return kBadInput;
  }
}

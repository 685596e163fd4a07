#include <ros/time.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "cli/classify_command.h"
#include "cli/evaluate_command.h"
#include "cli/inspect_command.h"
#include "cli/report_command.h"
#include "cli/train_command.h"

namespace {

constexpr int kBadInput = 1;
constexpr int kWrongUsage = 2;

/// The message in one line: lists of faults have one in each.
std::string OneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) text.replace(at, 1, "; ");
  return text;
}

/// What is wrong with the first argument, where it is no command; CLI11 only says that one is required.
std::string UnknownCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return "";
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return std::string("expected one of the commands ") + names + ", but found " + argv[1];
}

}  // namespace

int main(int argc, char** argv) {
  ros::Time::init();
  CLI::App app("Learns force patterns from recorded episodes, and names the outcome of new ones.", "shapelets");
  app.require_subcommand(1);
  contact_shapelets::cli::AddTrainCommand(&app);
  contact_shapelets::cli::AddClassifyCommand(&app);
  contact_shapelets::cli::AddEvaluateCommand(&app);
  contact_shapelets::cli::AddInspectCommand(&app);
  contact_shapelets::cli::AddReportCommand(&app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for_help) {
    return app.exit(asked_for_help);
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    const std::string unknown = UnknownCommand(app, argc, argv);
    std::cerr << "shapelets: " << OneLine(unknown.empty() ? error.what() : unknown)
              << " (shapelets --help says more)\n";
    return kWrongUsage;
  } catch (const std::exception& error) {
    std::cerr << "shapelets: " << OneLine(error.what()) << '\n';
    return kBadInput;
  }
  return 0;
}

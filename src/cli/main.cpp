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
    std::cerr << "shapelets: " << OneLine(error.what()) << " (shapelets --help says more)\n";
    return kWrongUsage;
  } catch (const std::exception& error) {
    std::cerr << "shapelets: " << OneLine(error.what()) << '\n';
    return kBadInput;
  }
  return 0;
}

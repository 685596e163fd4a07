#include <ros/time.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "cli/classify_command.h"
#include "cli/train_command.h"

int main(int argc, char** argv) {
  ros::Time::init();
  CLI::App app("Learns force patterns from recorded episodes, and names the outcome of new ones.", "shapelets");
  app.require_subcommand(1);
  int status = 0;
  contact_shapelets::cli::AddTrainCommand(&app);
  contact_shapelets::cli::AddClassifyCommand(&app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "shapelets: " << error.what() << '\n';
    status = 1;
  }
  return status;
}

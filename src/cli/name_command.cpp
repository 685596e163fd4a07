#include "cli/name_command.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <memory>

#include "cli/text.h"
#include "contact_shapelets/ros/model_bag.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  std::string model;
  std::vector<std::string> names;
};

/// Returns the clusters with their new names in "2=broken". \throws UsageError
std::map<int, std::string> ParseNames(const std::vector<std::string>& texts) {
  std::map<int, std::string> names;
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    const std::string number = text.substr(0, sign);
    const bool digits = !number.empty() && std::all_of(number.begin(), number.end(),
                                                       [](unsigned char letter) { return std::isdigit(letter) != 0; });
    if (sign == std::string::npos || !digits || number.size() > 6) {
      throw UsageError("name: expected CLUSTER=NAME, such as 2=broken, but found " + text);
    }
    if (!names.emplace(std::stoi(number), text.substr(sign + 1)).second) {
      throw UsageError("name: cluster " + number + " has two names");
    }
  }
  return names;
}

void PrintClusters(const core::Model& model) {
  std::printf("model %s\n", model.id.c_str());
  for (std::size_t index = 0; index < model.clusters.size(); ++index) {
    const core::Cluster& cluster = model.clusters[index];
    std::printf("cluster %zu: %s, %s\n", index, Count(static_cast<std::size_t>(cluster.size), "episode").c_str(),
                cluster.label.empty() ? "not named" : cluster.label.c_str());
  }
}

void Name(const Arguments& arguments) {
  const std::map<int, std::string> names = ParseNames(arguments.names);
  core::Model model = LoadModel(arguments.model);
  if (!names.empty()) model = NameClustersInFile(arguments.model, model.id, names);
  PrintClusters(model);
}

}  // namespace

Command NameCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "name";
  command.description = "Names the clusters of a model, and lists them; several may have one name";
  command.usage = "MODEL.bag [CLUSTER=NAME ...]";
  const auto arguments = std::make_shared<Arguments>();
  command.places.add_options()("model", po::value(&arguments->model)->required());
  command.places.add_options()("names", po::value(&arguments->names));
  command.positional.add("model", 1).add("names", -1);
  command.run = [arguments] {
    Name(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli

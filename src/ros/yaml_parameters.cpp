#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "contact_shapelets/ros/parameters.h"

namespace contact_shapelets {
namespace {

/// A scalar of the type that rosparam would give it.
XmlRpc::XmlRpcValue ScalarOf(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  if (node.Tag() == "!") return {text};  // quoted
  char* end = nullptr;
  const std::int64_t whole = std::strtoll(text.c_str(), &end, 10);
  const bool fits = whole >= std::numeric_limits<int>::min() && whole <= std::numeric_limits<int>::max();
  if (!text.empty() && *end == '\0' && fits) return {static_cast<int>(whole)};
  const double number = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') return {number};
  if (text == "true" || text == "false") return {text == "true"};
  return {text};
}

XmlRpc::XmlRpcValue ValueOf(const YAML::Node& node) {
  if (!node.IsSequence()) return ScalarOf(node);
  XmlRpc::XmlRpcValue list;
  list.setSize(static_cast<int>(node.size()));
  for (std::size_t index = 0; index < node.size(); ++index) list[static_cast<int>(index)] = ScalarOf(node[index]);
  return list;
}

}  // namespace

ParameterReader ParameterReader::FromYaml(const std::vector<std::string>& paths) {
  XmlRpc::XmlRpcValue tree;
  for (const std::string& path : paths) {
    YAML::Node root;
    try {
      root = YAML::LoadFile(path);
    } catch (const YAML::BadFile&) {
      throw std::runtime_error(path + ": expected a YAML file with parameters, but it cannot be opened");
    } catch (const YAML::Exception& error) {
      throw std::runtime_error(path + ": expected a YAML file with parameters, but " + error.what());
    }
    if (root.IsNull()) continue;  // nothing but comments
    if (!root.IsMap()) throw std::runtime_error(path + ": expected `name: value` lines");
    for (const auto& entry : root) tree[entry.first.Scalar()] = ValueOf(entry.second);
  }
  return ParameterReader(tree);
}

}  // namespace contact_shapelets

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "ros/messages/text.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets {
namespace {

/// The rules of YAML 1.1, which rosparam follows. yaml-cpp follows YAML 1.2.
bool IsBool(const std::string& text) {
  static const std::regex rule("yes|Yes|YES|no|No|NO|true|True|TRUE|false|False|FALSE|on|On|ON|off|Off|OFF");
  return std::regex_match(text, rule);
}

bool IsTrue(const std::string& text) {
  static const std::regex rule("[yYtT].*|on|On|ON");
  return std::regex_match(text, rule);
}

bool IsWhole(const std::string& text) {
  static const std::regex rule(
      "[-+]?(0b_*[01][01_]*|0[0-7_]+|0|[1-9][0-9_]*|0x_*[0-9a-fA-F][0-9a-fA-F_]*|[1-9][0-9_]*(:[0-5]?[0-9])+)");
  return std::regex_match(text, rule);
}

bool IsFloat(const std::string& text) {
  static const std::regex rule(
      "[-+]?[0-9][0-9_]*\\.[0-9_]*([eE][-+][0-9]+)?|\\.[0-9][0-9_]*([eE][-+][0-9]+)?|"
      "[-+]?[0-9][0-9_]*(:[0-5]?[0-9])+\\.[0-9_]*|[-+]?\\.(inf|Inf|INF)|\\.(nan|NaN|NAN)");
  return std::regex_match(text, rule);
}

/// Returns the magnitude of a number without sign and underscores. Digits after a colon count 60 times less.
double Magnitude(const std::string& digits) {
  if (digits == ".inf") return std::numeric_limits<double>::infinity();
  if (digits == ".nan") return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  std::istringstream parts(digits);
  for (std::string part; std::getline(parts, part, ':');) value = 60.0 * value + std::strtod(part.c_str(), nullptr);
  return value;
}

/// Returns the magnitude of a whole number without sign and underscores.
double WholeMagnitude(const std::string& digits) {
  const auto of_base = [&digits](std::size_t prefix, int base) {
    return static_cast<double>(std::strtoull(digits.c_str() + prefix, nullptr, base));
  };
  if (digits.rfind("0b", 0) == 0) return of_base(2, 2);
  if (digits.rfind("0x", 0) == 0) return of_base(2, 16);
  return digits.front() == '0' ? of_base(0, 8) : Magnitude(digits);
}

/// Returns false for a value that is quoted, tagged as a text, or of a type that only rosparam knows, such as !degrees.
bool IsPlain(const std::string& tag) {
  const std::string standard = "tag:yaml.org,2002:";
  return tag.empty() || tag == "?" || (tag.rfind(standard, 0) == 0 && tag != standard + "str");
}

/// Returns a scalar of the type that rosparam gives it. It is invalid if rosparam gives none, a text if rosparam fails.
XmlRpc::XmlRpcValue ScalarOf(const YAML::Node& node) {
  if (!node.IsScalar()) return {};
  const std::string& text = node.Scalar();
  if (!IsPlain(node.Tag()) || text.size() > kLongestNumber) return {text};
  if (IsBool(text)) return {IsTrue(text)};
  const bool whole = IsWhole(text);
  if (!whole && !IsFloat(text)) return {text};
  const double sign = text.front() == '-' ? -1.0 : 1.0;
  std::string digits = text.substr(text.find_first_not_of("+-"));
  digits.erase(std::remove(digits.begin(), digits.end(), '_'), digits.end());
  std::transform(digits.begin(), digits.end(), digits.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  if (!whole) return {sign * Magnitude(digits)};
  const double value = sign * WholeMagnitude(digits);
  const bool fits = value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
  return fits ? XmlRpc::XmlRpcValue(static_cast<int>(value)) : XmlRpc::XmlRpcValue(text);
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

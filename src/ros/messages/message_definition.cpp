#include "ros/messages/message_definition.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace contact_shapelets {
namespace {

constexpr char kString[] = "string";

template <typename Number>
double As(const std::uint8_t* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof(number));
  return static_cast<double>(number);
}

/// How a number is stored.
struct NumberType {
  std::size_t size;
  double (*read)(const std::uint8_t* bytes);
};

const std::map<std::string, NumberType>& NumberTypes() {
  static const std::map<std::string, NumberType> types{
      {"bool", {1, As<std::uint8_t>}},    {"byte", {1, As<std::int8_t>}},     {"char", {1, As<std::uint8_t>}},
      {"int8", {1, As<std::int8_t>}},     {"uint8", {1, As<std::uint8_t>}},   {"int16", {2, As<std::int16_t>}},
      {"uint16", {2, As<std::uint16_t>}}, {"int32", {4, As<std::int32_t>}},   {"uint32", {4, As<std::uint32_t>}},
      {"int64", {8, As<std::int64_t>}},   {"uint64", {8, As<std::uint64_t>}}, {"float32", {4, As<float>}},
      {"float64", {8, As<double>}}};
  return types;
}

std::vector<std::string> Split(const std::string& path) {
  std::vector<std::string> names;
  std::istringstream text(path);
  for (std::string name; std::getline(text, name, '.');) names.push_back(name);
  return names;
}

}  // namespace

/// One pass over a message up to the end of the field at `path`, or over all of it if `path` is empty.
class MessageDefinition::Walk {
 public:
  Walk(const MessageDefinition& definition, const std::string& path, const std::uint8_t* data, std::size_t size)
      : definition_(definition), path_(path), names_(Split(path)), next_(data), end_(data + size) {
    Message(definition.datatype_, 0, !names_.empty());
    if (!found_ && !names_.empty()) throw std::runtime_error(definition.datatype_ + " has no field " + path);
  }

  std::vector<double> numbers;
  std::vector<std::string> texts;

 private:
  /// `depth` is the number of names that lead here. `on_path` is true if all of them match the path.
  void Message(const std::string& type, std::size_t depth, bool on_path) {
    for (const Field& field : definition_.fields_of_.at(type)) {
      if (found_) return;
      const bool fits = on_path && depth < names_.size() && field.name == names_[depth];
      const bool target = fits && depth + 1 == names_.size();
      inside_ = inside_ || target;
      const auto count = field.count == kAnyCount ? static_cast<std::uint32_t>(As<std::uint32_t>(Take(4)))
                                                  : static_cast<std::uint32_t>(field.count);
      Items(field.type, count, depth + 1, fits && !field.array);
      if (target) found_ = true;
    }
  }

  void Items(const std::string& type, std::uint32_t count, std::size_t depth, bool on_path) {
    const auto number = NumberTypes().find(type);
    if (number == NumberTypes().end()) {
      for (std::uint32_t item = 0; item < count; ++item) Item(type, depth, on_path);
      return;
    }
    const std::size_t size = number->second.size;
    const std::uint8_t* bytes = Take(size * count);
    if (!inside_) return;
    for (std::uint32_t item = 0; item < count; ++item) numbers.push_back(number->second.read(bytes + size * item));
  }

  void Item(const std::string& type, std::size_t depth, bool on_path) {
    if (type == kString) {
      const auto length = static_cast<std::size_t>(As<std::uint32_t>(Take(4)));
      const std::uint8_t* bytes = Take(length);
      if (inside_) texts.emplace_back(bytes, bytes + length);
    } else {
      Message(type, depth, on_path);
    }
  }

  const std::uint8_t* Take(std::size_t size) {
    if (static_cast<std::size_t>(end_ - next_) < size) {
      throw std::runtime_error("a message of type " + definition_.datatype_ + " ends before " +
                               (path_.empty() ? "its last field" : path_));
    }
    const std::uint8_t* bytes = next_;
    next_ += size;
    return bytes;
  }

  const MessageDefinition& definition_;
  const std::string& path_;
  std::vector<std::string> names_;
  const std::uint8_t* next_;
  const std::uint8_t* end_;
  bool inside_ = false;
  bool found_ = false;
};

MessageDefinition::MessageDefinition(const std::string& datatype, const std::string& text) : datatype_(datatype) {
  // Times are two numbers of 32 bits.
  fields_of_["time"] = {{"uint32", "secs", 1, false}, {"uint32", "nsecs", 1, false}};
  fields_of_["duration"] = {{"int32", "secs", 1, false}, {"int32", "nsecs", 1, false}};
  std::string current = datatype;
  fields_of_[current] = {};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string type;
    std::string name;
    words >> type >> name;
    if (type == "MSG:") {
      current = name;
      fields_of_[current] = {};
      continue;
    }
    std::string rest;
    words >> rest;
    const bool constant = name.find('=') != std::string::npos || (!rest.empty() && rest.front() == '=');
    if (name.empty() || constant || type.front() == '=') continue;
    fields_of_[current].push_back(ParseField(type, name, current.substr(0, current.find('/'))));
  }
  for (const auto& [container, fields] : fields_of_) {
    for (const Field& field : fields) {
      const bool known = NumberTypes().count(field.type) + fields_of_.count(field.type) > 0 || field.type == kString;
      if (!known) throw std::runtime_error("the definition of " + datatype + " lacks the type " + field.type);
    }
  }
}

MessageDefinition::Field MessageDefinition::ParseField(const std::string& type, const std::string& name,
                                                       const std::string& package) {
  Field field;
  field.name = name;
  const std::size_t bracket = type.find('[');
  field.type = type.substr(0, bracket);
  if (bracket != std::string::npos) {
    field.array = true;
    field.count = type[bracket + 1] == ']' ? kAnyCount : std::stoi(type.substr(bracket + 1));
  }
  const bool built_in =
      NumberTypes().count(field.type) > 0 || field.type == kString || field.type == "time" || field.type == "duration";
  if (field.type == "Header") {
    field.type = "std_msgs/Header";
  } else if (!built_in && field.type.find('/') == std::string::npos) {
    field.type = package + "/" + field.type;
  }
  return field;
}

std::string MessageDefinition::PathOf(const std::string& type) const { return Find(datatype_, type); }

std::string MessageDefinition::Find(const std::string& container, const std::string& type) const {
  const auto fields = fields_of_.find(container);
  if (fields == fields_of_.end()) return "";
  for (const Field& field : fields->second) {
    if (field.array) continue;
    if (field.type == type) return field.name;
    const std::string inner = Find(field.type, type);
    if (!inner.empty()) return field.name + "." + inner;
  }
  return "";
}

std::vector<double> MessageDefinition::Numbers(const std::string& path, const std::uint8_t* data,
                                               std::size_t size) const {
  Walk walk(*this, path, data, size);
  if (!walk.texts.empty()) throw std::runtime_error(path + " of " + datatype_ + " holds a string, expected numbers");
  return std::move(walk.numbers);
}

std::string MessageDefinition::Text(const std::string& path, const std::uint8_t* data, std::size_t size) const {
  const Walk walk(*this, path, data, size);
  if (walk.texts.size() != 1) throw std::runtime_error(path + " of " + datatype_ + " is not one string");
  return walk.texts.front();
}

bool MessageDefinition::HasTexts(const std::string& field) const {
  const std::vector<Field>& fields = fields_of_.at(datatype_);
  return std::any_of(fields.begin(), fields.end(), [&field](const Field& candidate) {
    return candidate.name == field && candidate.array && candidate.type == kString;
  });
}

std::vector<std::string> MessageDefinition::Texts(const std::string& path, const std::uint8_t* data,
                                                  std::size_t size) const {
  Walk walk(*this, path, data, size);
  if (!walk.numbers.empty()) throw std::runtime_error(path + " of " + datatype_ + " holds numbers, expected strings");
  return std::move(walk.texts);
}

void MessageDefinition::CheckLengths(const std::uint8_t* data, std::size_t size) const { Walk(*this, "", data, size); }

}  // namespace contact_shapelets

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// \file
/// Numbers out of messages whose type is known at run time only, by the definition that travels with the connection:
/// drivers' own messages are read without a dependency on their packages.

namespace contact_shapelets {

/// The fields of a message type and of all types in it.
class MessageDefinition {
 public:
  /// Parses `text` as in a connection's header: the fields of `datatype` ("package/Type"), then those of each type in
  /// it. \throws std::runtime_error naming a type whose fields are missing.
  MessageDefinition(const std::string& datatype, const std::string& text);

  /// The path ("wrench.wrench") of the first field of `type`, depth first; empty where there is none. Fields within
  /// arrays do not count.
  std::string PathOf(const std::string& type) const;

  /// The numbers at `path` in a serialised message, in order: one for a number, as many as there are for an array of
  /// numbers or a message that holds only numbers. Integers and times (two: seconds and nanoseconds) count as numbers.
  /// \throws std::runtime_error where there is no such field, it holds a string, or the message ends early.
  std::vector<double> Numbers(const std::string& path, const std::uint8_t* data, std::size_t size) const;

  /// The text at `path`, a string that is not within an array. \throws std::runtime_error as Numbers() does.
  std::string Text(const std::string& path, const std::uint8_t* data, std::size_t size) const;

  /// Whether the message itself has a field of this name that is a list of strings.
  bool HasTexts(const std::string& field) const;

  /// The texts at `path`, a list of strings, in order. \throws std::runtime_error as Numbers() does.
  std::vector<std::string> Texts(const std::string& path, const std::uint8_t* data, std::size_t size) const;

  /// Checks that a serialised message is as long as its array lengths say. Generated code allocates an array of any
  /// stated length before it looks. \throws std::runtime_error if the message ends early.
  void CheckLengths(const std::uint8_t* data, std::size_t size) const;

 private:
  static constexpr int kAnyCount = -1;

  struct Field {
    std::string type;
    std::string name;
    int count = 1;  ///< of an array of fixed length; kAnyCount where it is in the message
    bool array = false;
  };
  class Walk;

  static Field ParseField(const std::string& type, const std::string& name, const std::string& package);
  std::string Find(const std::string& container, const std::string& type) const;

  std::string datatype_;
  std::map<std::string, std::vector<Field>> fields_of_;
};

}  // namespace contact_shapelets

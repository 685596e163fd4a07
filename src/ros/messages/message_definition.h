#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// \file
/// Reads numbers from messages of a type that is known only at run time. The connection carries the definition of the
/// type, so a driver's messages can be read without its package.

namespace contact_shapelets {

/// The fields of a message type and of all types in it.
class MessageDefinition {
 public:
  /// Parses `text`, the definition in a connection's header: the fields of `datatype` ("package/Type"), then those of
  /// each type in it. \throws std::runtime_error naming a type that `text` does not define.
  MessageDefinition(const std::string& datatype, const std::string& text);

  /// Returns the path ("wrench.wrench") of the first field of `type`, depth first; an empty string if there is none.
  /// Ignores fields within arrays.
  std::string PathOf(const std::string& type) const;

  /// Returns the numbers at `path` in a serialised message, in order. The field is a number, an array of numbers, or a
  /// message that holds only numbers. A time counts as two numbers: seconds and nanoseconds.
  /// \throws std::runtime_error if there is no such field, it holds a string, or the message ends early.
  std::vector<double> Numbers(const std::string& path, const std::uint8_t* data, std::size_t size) const;

  /// Returns the text at `path`, a string that is not within an array. \throws std::runtime_error as Numbers() does.
  std::string Text(const std::string& path, const std::uint8_t* data, std::size_t size) const;

  /// Returns true if the message itself has a field of this name that is a list of strings.
  bool HasTexts(const std::string& field) const;

  /// Returns the texts at `path`, a list of strings, in order. \throws std::runtime_error as Numbers() does.
  std::vector<std::string> Texts(const std::string& path, const std::uint8_t* data, std::size_t size) const;

  /// Checks that a serialised message is as long as its array lengths say. Generated code would allocate an array of
  /// any stated length first. \throws std::runtime_error if the message ends early.
  void CheckLengths(const std::uint8_t* data, std::size_t size) const;

 private:
  static constexpr int kAnyCount = -1;

  struct Field {
    std::string type;
    std::string name;
    int count = 1;  ///< length of a fixed array; kAnyCount if the message holds the length
    bool array = false;
  };
  class Walk;

  static Field ParseField(const std::string& type, const std::string& name, const std::string& package);
  std::string Find(const std::string& container, const std::string& type) const;

  std::string datatype_;
  std::map<std::string, std::vector<Field>> fields_of_;
};

}  // namespace contact_shapelets

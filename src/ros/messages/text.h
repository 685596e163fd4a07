#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace contact_shapelets {

/// Longer texts do not count as numbers, because std::regex needs stack for each character.
constexpr std::size_t kLongestNumber = 100;

/// Returns the text without line breaks, for logs and diagnostics.
inline std::string OneLine(const std::string& text) {
  std::string line;
  for (const char letter : text) line += letter == '\n' ? std::string("; ") : std::string(1, letter);
  while (!line.empty() && (line.back() == ' ' || line.back() == ';')) line.pop_back();
  return line;
}

/// Returns the absolute path. Messages need it, because the working directory of a node is seldom that of the user's
/// shell.
inline std::string AbsolutePath(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace contact_shapelets

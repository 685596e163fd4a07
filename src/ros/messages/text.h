#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace contact_shapelets {

/// Longer texts are no numbers: std::regex takes stack by the letter.
constexpr std::size_t kLongestNumber = 100;

/// The text without line breaks, for logs and diagnostics.
inline std::string OneLine(const std::string& text) {
  std::string line;
  for (const char letter : text) line += letter == '\n' ? std::string("; ") : std::string(1, letter);
  while (!line.empty() && (line.back() == ' ' || line.back() == ';')) line.pop_back();
  return line;
}

/// The whole path: a node's working directory is seldom that of the shell it was started from, so that a message has to
/// say where a relative path led.
inline std::string AbsolutePath(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace contact_shapelets

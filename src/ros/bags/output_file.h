#pragma once

#include <string>
#include <vector>

/// \file
/// Files that a long work will end in: checks before it begins, and names while they are written.

namespace contact_shapelets {

/// Checks that a file can be written at `path`. \throws std::runtime_error that begins with `what` and the path: its
/// folder is missing or not writable, it is a folder itself, write-protected, or one of `bags`.
void CheckOutput(const std::string& what, const std::string& path, const std::vector<std::string>& bags);

/// Checks that a model can be written at `path`, and that no recording would be lost to it. \throws std::runtime_error
/// as CheckOutput() does, and where another bag than a model, or what is no bag, is there already.
void CheckModelOutput(const std::string& what, const std::string& path, const std::vector<std::string>& bags);

/// A name beside `path`, of this process alone, to write under before the file is renamed to `path`.
std::string TemporaryName(const std::string& path);

}  // namespace contact_shapelets

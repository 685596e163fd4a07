#pragma once

#include <string>
#include <vector>

/// \file
/// Checks of files that a long work will end in, before it begins.

namespace contact_shapelets {

/// Checks that a file can be written at `path`. \throws std::runtime_error that begins with `what` and the path: its
/// folder is missing or not writable, it is a folder itself, write-protected, or one of `bags`.
void CheckOutput(const std::string& what, const std::string& path, const std::vector<std::string>& bags);

/// Checks that a model can be written at `path`, and that no recording would be lost to it. \throws std::runtime_error
/// as CheckOutput() does, and where another bag than a model, or what is no bag, is there already.
void CheckModelOutput(const std::string& what, const std::string& path, const std::vector<std::string>& bags);

}  // namespace contact_shapelets

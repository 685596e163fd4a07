#pragma once

#include <fstream>
#include <string>

#include "ros/bags/output_file.h"

namespace contact_shapelets::cli {

/// A table or a page. Either the whole file is written or the old one stays.
class TextOutput {
 public:
  /// \throws std::runtime_error naming the file if it cannot be made.
  explicit TextOutput(const std::string& path);

  /// The stream to write to.
  std::ostream* stream() { return &stream_; }
  /// Checks the writing so far. \throws std::runtime_error naming the file if it failed.
  void Check();
  /// Puts the file in its place. \throws std::runtime_error naming the file if that fails. The old file then stays as
  /// it is.
  void Finish();

 private:
  std::string path_;
  OutputFile file_;
  std::ofstream stream_;
};

}  // namespace contact_shapelets::cli

#pragma once

#include <fstream>
#include <string>

#include "ros/bags/output_file.h"

namespace contact_shapelets::cli {

/// A table or a page that is written as a whole or not at all.
class TextOutput {
 public:
  /// \throws std::runtime_error naming the file where it cannot be made.
  explicit TextOutput(const std::string& path);

  /// Where to write to.
  std::ostream* stream() { return &stream_; }
  /// Looks whether all could be written so far. \throws std::runtime_error naming the file where not.
  void Check();
  /// Puts the file in its place. \throws std::runtime_error naming the file where it cannot be; the old one then is as
  /// it was.
  void Finish();

 private:
  std::string path_;
  OutputFile file_;
  std::ofstream stream_;
};

}  // namespace contact_shapelets::cli

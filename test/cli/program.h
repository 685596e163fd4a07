#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

/// \file
/// Runs the offline program as a process.

namespace contact_shapelets::test {

/// What a run of the program left.
struct ProgramRun {
  int status = -1;  ///< exit status; -1 where a signal ended it
  std::string out;
  std::string err;
};

/// Runs `shapelets` with these arguments and waits for its end. Permissions of files hold for it, also where root runs
/// the test.
ProgramRun RunShapelets(const std::vector<std::string>& arguments);

/// Runs it with its stdout led to a device without space.
ProgramRun RunShapeletsWithoutSpace(const std::vector<std::string>& arguments);

/// Runs it with no file allowed to grow beyond `bytes`: what is left of a disk that is full.
ProgramRun RunShapeletsWithLittleSpace(const std::vector<std::string>& arguments, unsigned long bytes);

/// Starts `shapelets`, waits until there is a file in `folder` whose name begins with `start`, and sends it the signal
/// `number`. Returns whether that ended it.
bool EndShapeletsOnceItWrites(const std::vector<std::string>& arguments, const std::string& folder,
                              const std::string& start, int number);

/// Starts `shapelets`, waits until it has written `text` to stderr, and sends it the signal `number`.
/// Returns whether that ended it.
bool EndShapeletsAfter(const std::vector<std::string>& arguments, const std::string& text, int number);

/// A folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The path of a file in it.
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  /// Names of all files in it, in alphabetical order.
  std::vector<std::string> Files() const;

 private:
  std::string path_;
};

/// The whole file. \throws std::runtime_error where there is none.
std::string ReadFile(const std::string& path);
/// Writes `text` to `path`, and returns `path`.
std::string WriteFile(const std::string& path, const std::string& text);
/// The lines of `text`.
std::vector<std::string> Lines(const std::string& text);

}  // namespace contact_shapelets::test

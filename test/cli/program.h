#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

/// \file
/// Runs the offline program as a process.

namespace contact_shapelets::test {

/// The results of a run of the program.
struct ProgramRun {
  int status = -1;  ///< exit status; -1 if a signal ended it
  std::string out;
  std::string err;
};

/// Runs `shapelets` with these arguments and waits for its end. Permissions of files apply to it even if root runs the
/// test.
ProgramRun RunShapelets(const std::vector<std::string>& arguments);

/// Runs it with a full device as its stdout.
ProgramRun RunShapeletsWithoutSpace(const std::vector<std::string>& arguments);

/// Runs it with no file allowed to grow beyond `bytes`: what is left of a disk that is full.
ProgramRun RunShapeletsWithLittleSpace(const std::vector<std::string>& arguments, unsigned long bytes);

/// Starts `shapelets`, waits until there is a file in `folder` whose name begins with `start`, and sends it the signal
/// `number`. Returns true if the signal ended it.
bool EndShapeletsOnceItWrites(const std::vector<std::string>& arguments, const std::string& folder,
                              const std::string& start, int number);

/// Starts `shapelets`, waits until it has written `text` to stderr, and sends it the signal `number`. Returns true if
/// the signal ended it.
bool EndShapeletsAfter(const std::vector<std::string>& arguments, const std::string& text, int number);

/// A folder that the destructor removes with all its files.
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

/// Returns the whole file. \throws std::runtime_error if there is none.
std::string ReadFile(const std::string& path);
/// Writes `text` to `path` and returns `path`.
std::string WriteFile(const std::string& path, const std::string& text);
/// Returns the lines of `text`.
std::vector<std::string> Lines(const std::string& text);

}  // namespace contact_shapelets::test

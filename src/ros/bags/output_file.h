#pragma once

#include <string>
#include <thread>
#include <vector>

/// \file
/// Output files: checks before a long computation, and writing that never leaves a part of a file.

namespace contact_shapelets {

/// Checks that a file can be written at `path`. \throws std::runtime_error that begins with `what` and the path if its
/// folder is missing or not writable, or if it is a folder, write-protected, or among the files in `read` or `written`.
/// Ignores empty paths in these.
void CheckOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                 const std::vector<std::string>& written = {});

/// Checks the output for a table or a page. \throws std::runtime_error as CheckOutput() does, and if `path` is a bag.
void CheckTextOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                     const std::vector<std::string>& written = {});

/// Checks the output for a bag. \throws std::runtime_error as CheckOutput() does, and if `path` is a device or a pipe.
void CheckBagOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                    const std::vector<std::string>& written = {});

/// Checks the output for a model, which must not replace a recording. \throws std::runtime_error as CheckBagOutput()
/// does, and if `path` is a file that is not a bag with one model and nothing else.
void CheckModelOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read);

/// A file that takes its place when it is whole. Until then it lies beside its place, under a name that begins with the
/// file's name and ".unfinished". The destructor removes an unfinished file, and with RemovalOnSignals a signal does
/// too. The next OutputFile at the same path removes what a killed process left. A lock marks files that another
/// process still writes.
class OutputFile {
 public:
  /// Makes the unfinished file, with the permissions of a file that is at `path` already. Writes a device or a pipe
  /// directly. Replaces the target of a symbolic link. \throws std::runtime_error with the reason if it cannot be made.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Path of the unfinished file: write to it.
  const std::string& unfinished() const { return unfinished_; }

  /// Waits until the disk has all data, then puts the file in its place. Close the unfinished file before.
  /// \throws std::runtime_error with the reason if that fails. The old file then stays as it is.
  void Finish();

 private:
  std::string path_;
  std::string unfinished_;
  int descriptor_ = -1;  ///< holds the lock; -1 if the output is a device or a pipe
};

/// Makes SIGINT, SIGTERM and SIGHUP remove the unfinished files before they end the process, as long as this object
/// lives. Ignored signals stay ignored. Make it before any thread.
class RemovalOnSignals {
 public:
  RemovalOnSignals();
  ~RemovalOnSignals();
  RemovalOnSignals(const RemovalOnSignals&) = delete;
  RemovalOnSignals& operator=(const RemovalOnSignals&) = delete;

 private:
  std::thread waiting_;
};

}  // namespace contact_shapelets

#pragma once

#include <string>
#include <thread>
#include <vector>

/// \file
/// Files that a long work ends in: checks before it begins, and the writing under another name until they are whole.

namespace contact_shapelets {

/// Checks that a file can be written at `path`. \throws std::runtime_error that begins with `what` and the path: its
/// folder is missing or not writable, it is a folder itself, write-protected, one of the files that are `read`, or one
/// of those that are `written`, too. Empty paths among these do not count.
void CheckOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                 const std::vector<std::string>& written = {});

/// Likewise for a table or a page. \throws std::runtime_error as CheckOutput() does, and where a bag is there already.
void CheckTextOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                     const std::vector<std::string>& written = {});

/// Likewise for a bag, which cannot be written to a device or a pipe. \throws std::runtime_error as CheckOutput() does.
void CheckBagOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read,
                    const std::vector<std::string>& written = {});

/// Checks that a model can be written at `path`, and that no recording would be lost to it. \throws std::runtime_error
/// as CheckOutput() does, and where what is there already is no bag, or holds anything else than one model.
void CheckModelOutput(const std::string& what, const std::string& path, const std::vector<std::string>& read);

/// A file that takes its place when it is whole. Until then it has a name of its own beside it, which begins with the
/// file's and ".unfinished". A destructor, and with RemovalOnSignals a signal, leave nothing of it. What a killed
/// process left is removed when the same file is written again: a lock tells it from what others are writing.
class OutputFile {
 public:
  /// Makes the unfinished file, with the permissions of what is at `path`. A device or a pipe is written directly; of a
  /// symbolic link, what it leads to is replaced. \throws std::runtime_error saying why it cannot be made.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write to.
  const std::string& unfinished() const { return unfinished_; }

  /// Waits until all is on the disk, then puts it in its place. Whatever was written there has to be closed.
  /// \throws std::runtime_error saying why it cannot be; the old file is then as it was.
  void Finish();

 private:
  std::string path_;
  std::string unfinished_;
  int descriptor_ = -1;  ///< holds the lock; none where it is written directly
};

/// While this exists, SIGINT, SIGTERM and SIGHUP end the process as ever, but remove the unfinished files first. Those
/// that are ignored stay ignored. To be made before any thread is.
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

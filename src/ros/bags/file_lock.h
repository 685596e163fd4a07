#pragma once

#include <string>

namespace contact_shapelets {

/// Keeps other processes, and other threads, from changing a file while this exists: those that ask for the same lock.
/// It is a lock on a file beside it, with the ending ".lock", which is gone again behind the last of them.
class FileLock {
 public:
  /// Waits for the lock of `path`, at most `limit` [s]. \throws std::runtime_error naming the file of the lock where it
  /// cannot be made, or another process held it for longer.
  explicit FileLock(const std::string& path, double limit = 10.0);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace contact_shapelets

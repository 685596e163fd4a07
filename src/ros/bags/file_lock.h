#pragma once

#include <string>

namespace contact_shapelets {

/// Holds a lock on a file as long as this object lives. Processes and threads that ask for the same lock wait. The lock
/// is a file beside it with the ending ".lock". The last holder removes it.
class FileLock {
 public:
  /// Waits for the lock of `path`, at most `limit` [s]. \throws std::runtime_error naming the lock file if it cannot be
  /// made or if another process holds it for longer.
  explicit FileLock(const std::string& path, double limit = 10.0);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace contact_shapelets

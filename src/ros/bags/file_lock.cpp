#include "ros/bags/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace contact_shapelets {
namespace {

constexpr std::chrono::milliseconds kBetweenTrials(5);

/// Returns the descriptor of the locked file, or -1 if another process holds the lock or just removed the file.
int TryToLock(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw std::runtime_error(path + " cannot be made: " + std::strerror(errno));
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  const bool impossible = !locked && errno != EWOULDBLOCK;
  struct stat by_path {};
  struct stat by_descriptor {};
  const bool there = stat(path.c_str(), &by_path) == 0 && fstat(descriptor, &by_descriptor) == 0 &&
                     by_path.st_ino == by_descriptor.st_ino && by_path.st_dev == by_descriptor.st_dev;
  if (locked && there) return descriptor;
  close(descriptor);
  if (impossible) throw std::runtime_error(path + " cannot be locked on this file system");
  return -1;
}

}  // namespace

FileLock::FileLock(const std::string& path, double limit) : path_(path + ".lock") {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit);
  while ((descriptor_ = TryToLock(path_)) < 0) {
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error(path_ + " is held by another process");
    std::this_thread::sleep_for(kBetweenTrials);
  }
}

FileLock::~FileLock() {
  // Waiting processes check that the file is still there, so removing it is safe.
  unlink(path_.c_str());
  close(descriptor_);
}

}  // namespace contact_shapelets

#include "ros/bags/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <stdexcept>

namespace contact_shapelets {

namespace filesystem = std::filesystem;

namespace {

constexpr char kEnding[] = ".unfinished";

/// The files that a signal removes. The process has one set, because signals are for the whole process.
struct Unfinished {
  std::mutex mutex;
  std::set<std::string> paths;
  std::atomic<bool> ending{false};
};

Unfinished& TheUnfinished() {
  static Unfinished unfinished;
  return unfinished;
}

std::runtime_error SystemError() { return std::runtime_error(std::strerror(errno)); }

/// Returns true if `path` still names the file of `descriptor`.
bool IsAt(const std::string& path, int descriptor) {
  struct stat by_path {};
  struct stat by_descriptor {};
  return stat(path.c_str(), &by_path) == 0 && fstat(descriptor, &by_descriptor) == 0 &&
         by_path.st_ino == by_descriptor.st_ino && by_path.st_dev == by_descriptor.st_dev;
}

/// Returns the names of the unfinished files of `path`, of all processes.
std::vector<std::string> UnfinishedOf(const std::string& path) {
  const filesystem::path folder = filesystem::path(path).parent_path();
  const std::string start = filesystem::path(path).filename().string() + kEnding;
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : filesystem::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool numbered = name.size() > start.size() && name.compare(0, start.size(), start) == 0 &&
                          name.find_first_not_of("0123456789_", start.size()) == std::string::npos;
    if (numbered) found.push_back((folder / name).string());
  }
  return found;
}

/// Removes the unfinished files of processes that have ended: nobody holds their locks.
void RemoveLeftOvers(const std::string& path) {
  for (const std::string& name : UnfinishedOf(path)) {
    const int descriptor = open(name.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && IsAt(name, descriptor)) unlink(name.c_str());
    close(descriptor);
  }
}

/// Makes a new file and locks it. Returns its descriptor and sets `name`.
int MakeUnfinished(const std::string& path, std::string* name) {
  const std::string start = path + kEnding + std::to_string(getpid());
  for (int count = 0;; ++count) {
    *name = count == 0 ? start : start + '_' + std::to_string(count);
    const int descriptor = open(name->c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) throw SystemError();
    if (descriptor < 0) continue;
    flock(descriptor, LOCK_EX);
    // Before the lock, another process may have removed the file as a leftover.
    if (IsAt(*name, descriptor)) return descriptor;
    close(descriptor);
  }
}

std::vector<int> SignalsToWaitFor() {
  std::vector<int> signals;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN) signals.push_back(number);
  }
  return signals;
}

sigset_t SetOf(const std::vector<int>& signals) {
  sigset_t set{};
  sigemptyset(&set);
  for (const int number : signals) sigaddset(&set, number);
  return set;
}

/// Removes the unfinished files and ends the process as the signal would have.
void EndBy(int number) {
  Unfinished& unfinished = TheUnfinished();
  // Keeps the lock for good, so that no thread makes or finishes another file.
  unfinished.mutex.lock();
  for (const std::string& path : unfinished.paths) unlink(path.c_str());
  std::signal(number, SIG_DFL);
  const sigset_t set = SetOf({number});
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  raise(number);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
  std::error_code ignored;
  if (filesystem::is_symlink(path, ignored) && filesystem::exists(path, ignored)) {
    path_ = filesystem::canonical(path).string();
  }
  unfinished_ = path_;
  struct stat old {};
  const bool there = stat(path_.c_str(), &old) == 0;
  if (there && !S_ISREG(old.st_mode) && !S_ISDIR(old.st_mode)) return;
  RemoveLeftOvers(path_);
  Unfinished& unfinished = TheUnfinished();
  const std::lock_guard<std::mutex> lock(unfinished.mutex);
  descriptor_ = MakeUnfinished(path_, &unfinished_);
  unfinished.paths.insert(unfinished_);
  // Some file systems have no permissions. Failing to set them is no fault.
  if (there && S_ISREG(old.st_mode)) static_cast<void>(fchmod(descriptor_, old.st_mode & 07777U));
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  Unfinished& unfinished = TheUnfinished();
  const std::lock_guard<std::mutex> lock(unfinished.mutex);
  if (unfinished.paths.erase(unfinished_) > 0) unlink(unfinished_.c_str());
  close(descriptor_);
}

void OutputFile::Finish() {
  if (descriptor_ < 0) return;
  if (fsync(descriptor_) != 0) throw SystemError();
  Unfinished& unfinished = TheUnfinished();
  const std::lock_guard<std::mutex> lock(unfinished.mutex);
  if (std::rename(unfinished_.c_str(), path_.c_str()) != 0) throw SystemError();
  unfinished.paths.erase(unfinished_);
}

RemovalOnSignals::RemovalOnSignals() {
  TheUnfinished().ending = false;
  const std::vector<int> signals = SignalsToWaitFor();
  const sigset_t set = SetOf(signals);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  if (signals.empty()) return;
  waiting_ = std::thread([set] {
    int number = 0;
    while (sigwait(&set, &number) != 0) continue;
    if (!TheUnfinished().ending) EndBy(number);
  });
}

RemovalOnSignals::~RemovalOnSignals() {
  if (!waiting_.joinable()) return;
  TheUnfinished().ending = true;
  const std::vector<int> signals = SignalsToWaitFor();
  pthread_kill(waiting_.native_handle(), signals.front());
  waiting_.join();
  const sigset_t set = SetOf(signals);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace contact_shapelets

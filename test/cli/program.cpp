#include "cli/program.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace contact_shapelets::test {
namespace {

/// Drops root's right to read and write any file in the programs that this process starts, so that permissions of files
/// apply to root, too. Returns false if that fails.
bool HeedPermissions() {
  if (geteuid() != 0) return true;
  for (const int capability : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH}) {
    if (prctl(PR_CAPBSET_READ, capability, 0, 0, 0) != 1) continue;
    if (prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) != 0) return false;
  }
  return true;
}

constexpr rlim_t kNoLimit = RLIM_INFINITY;

/// Starts the program with these descriptors as its stdout and stderr, and with a limit on the size of its files.
pid_t Start(const std::vector<std::string>& arguments, int out, int err, rlim_t limit = kNoLimit) {
  std::vector<std::string> words{SHAPELETS_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    if (!HeedPermissions()) _exit(126);
    const rlimit size{limit, RLIM_INFINITY};
    if (limit != kNoLimit && (setrlimit(RLIMIT_FSIZE, &size) != 0 || signal(SIGXFSZ, SIG_IGN) == SIG_ERR)) _exit(125);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    execv(pointers.front(), pointers.data());
    _exit(127);
  }
  return child;
}

int OpenForWriting(const std::string& path) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) throw std::runtime_error("cannot write " + path);
  return descriptor;
}

/// Runs the program with its stdout in a file; ProgramRun::out stays empty.
ProgramRun RunInto(const std::string& path, const std::vector<std::string>& arguments, rlim_t limit = kNoLimit) {
  const TemporaryFolder folder;
  const int out = OpenForWriting(path);
  const int err = OpenForWriting(folder / "err");
  const pid_t child = Start(arguments, out, err, limit);
  close(out);
  close(err);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", ReadFile(folder / "err")};
}

}  // namespace

ProgramRun RunShapelets(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  ProgramRun run = RunInto(folder / "out", arguments);
  run.out = ReadFile(folder / "out");
  return run;
}

ProgramRun RunShapeletsWithoutSpace(const std::vector<std::string>& arguments) {
  return RunInto("/dev/full", arguments);
}

ProgramRun RunShapeletsWithLittleSpace(const std::vector<std::string>& arguments, unsigned long bytes) {
  return RunInto("/dev/null", arguments, bytes);
}

bool EndShapeletsOnceItWrites(const std::vector<std::string>& arguments, const std::string& folder,
                              const std::string& start, int number) {
  const int nowhere = OpenForWriting("/dev/null");
  const pid_t child = Start(arguments, nowhere, nowhere);
  close(nowhere);
  int status = 0;
  const auto writes = [&] {
    return std::any_of(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator(),
                       [&](const auto& entry) { return entry.path().filename().string().rfind(start, 0) == 0; });
  };
  while (!writes()) {
    if (waitpid(child, &status, WNOHANG) == child) return false;
  }
  kill(child, number);
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

bool EndShapeletsAfter(const std::vector<std::string>& arguments, const std::string& text, int number) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
  const int nowhere = OpenForWriting("/dev/null");
  const pid_t child = Start(arguments, nowhere, pipe_ends[1]);
  close(pipe_ends[1]);
  close(nowhere);
  std::string err;
  std::array<char, 256> part{};
  while (err.find(text) == std::string::npos) {
    const ssize_t size = read(pipe_ends[0], part.data(), part.size());
    if (size <= 0) break;
    err.append(part.data(), static_cast<std::size_t>(size));
  }
  kill(child, number);
  int status = 0;
  waitpid(child, &status, 0);
  close(pipe_ends[0]);
  return err.find(text) != std::string::npos && WIFSIGNALED(status);
}

TemporaryFolder::TemporaryFolder() {
  path_ = (std::filesystem::temp_directory_path() / "shapelets_test_XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::Files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("there is no file " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string WriteFile(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace contact_shapelets::test

#include "cli/text_output.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace contact_shapelets::cli {
namespace {

[[noreturn]] void Fail(const std::string& path, const std::string& why) {
  throw std::runtime_error(path + ": the file cannot be written: " + why);
}

}  // namespace

TextOutput::TextOutput(const std::string& path) try : path_(path), file_(path), stream_(file_.unfinished()) {
} catch (const std::runtime_error& error) {
  Fail(path, error.what());
}

void TextOutput::Check() {
  errno = 0;
  stream_.flush();
  if (!stream_) Fail(path_, errno != 0 ? std::strerror(errno) : "the disk gave an error");
}

void TextOutput::Finish() {
  Check();
  stream_.close();
  if (!stream_) Fail(path_, "it cannot be closed");
  try {
    file_.Finish();
  } catch (const std::runtime_error& error) {
    Fail(path_, error.what());
  }
}

}  // namespace contact_shapelets::cli

#include "recording/append_file.h"

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

// Files that only grow: log and trace. Each append reaches the operating system before it returns,
// so a killed program loses at most the end of its last record. Power failures are not covered:
// that would need an fsync per tick.

namespace smile::recording {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path) {
  throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

AppendFile::AppendFile(const std::filesystem::path& path, Existence existence)
    : path_(path),
      file_(std::fopen(path.c_str(), existence == kNew ? "wbxe" : "r+be"), &std::fclose) {
  // `x` fails if the file exists, `e` closes it in child processes such as brains.
  // The advisory lock excludes other writers and lasts until the file is closed; readers are not
  // affected. A lock that is taken fails at once and does not wait.
  if (!file_) Fail(path_);
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0) {
    throw std::runtime_error(path_.string() + ": is being written by another program");
  }
  if (std::fseek(file_.get(), 0, SEEK_END) != 0) Fail(path_);
  size_ = static_cast<std::uint64_t>(std::ftell(file_.get()));
}

void AppendFile::Cut(std::uint64_t size) {
  // Only an unfinished end is ever cut off.
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(size)) != 0 ||
      std::fseek(file_.get(), 0, SEEK_END) != 0) {
    Fail(path_);
  }
  size_ = size;
}

void AppendFile::Append(std::string_view text) {
  Append(std::as_bytes(std::span(text.data(), text.size())));
}

void AppendFile::Append(std::span<const std::byte> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
      std::fflush(file_.get()) != 0) {
    Fail(path_);
  }
  // Reached only if the buffer was flushed to the operating system.
  size_ += bytes.size();
}

}  // namespace smile::recording

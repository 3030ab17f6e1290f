#include "record/append_file.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

namespace smile::record {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path) {
  throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

AppendFile::AppendFile(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "wbxe"), &std::fclose) {
  if (!file_) Fail(path_);
}

AppendFile::AppendFile(const std::filesystem::path& path, std::uint64_t size)
    : path_(path), file_(nullptr, &std::fclose), size_(size) {
  std::error_code error;
  std::filesystem::resize_file(path_, size, error);
  if (error) {
    throw std::runtime_error(path.string() + ": cannot be cut: " + error.message());
  }
  file_.reset(std::fopen(path.c_str(), "abe"));
  if (!file_) Fail(path_);
}

void AppendFile::Append(std::string_view text) {
  Append(std::as_bytes(std::span(text.data(), text.size())));
}

void AppendFile::Append(std::span<const std::byte> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
      std::fflush(file_.get()) != 0) {
    Fail(path_);
  }
  size_ += bytes.size();
}

}  // namespace smile::record

#include "library/gzip.h"

#include <archive.h>
#include <archive_entry.h>

#include <memory>
#include <stdexcept>

namespace smile::library {
namespace {

/// Callback of libarchive: appends the bytes to the string.
la_ssize_t AppendBytes(archive*, void* file, const void* bytes, std::size_t count) {
  static_cast<std::string*>(file)->append(static_cast<const char*>(bytes), count);
  return static_cast<la_ssize_t>(count);
}

}  // namespace

std::string Gzipped(std::string_view bytes) {
  std::string file;
  const std::unique_ptr<archive, int (*)(archive*)> out(archive_write_new(), &archive_write_free);
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                       &archive_entry_free);
  const auto check = [&out](la_ssize_t result) {
    if (result >= ARCHIVE_WARN) return;
    const char* reason = archive_error_string(out.get());
    throw std::runtime_error("cannot be compressed: " + std::string(reason ? reason : "unknown"));
  };
  check(archive_write_add_filter_gzip(out.get()));
  check(archive_write_set_options(out.get(), "gzip:!timestamp"));
  // One entry without a header: what is compressed are the bytes alone.
  check(archive_write_set_format_raw(out.get()));
  check(archive_write_set_bytes_in_last_block(out.get(), 1));  // no padding
  check(archive_write_open(out.get(), &file, nullptr, &AppendBytes, nullptr));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  check(archive_write_header(out.get(), entry.get()));
  check(archive_write_data(out.get(), bytes.data(), bytes.size()));
  check(archive_write_close(out.get()));
  return file;
}

}  // namespace smile::library

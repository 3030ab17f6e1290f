#include "library/internal_zip.h"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/file_state.h"
#include "base/files.h"
#include "base/wording.h"

namespace smile::library {
namespace {

// Far above ordinary recordings; bounds the time that a folder full of foreign files takes.
constexpr std::size_t kMaxZippedFiles = 100'000;

/// Returns all regular files below a directory, sorted; throws std::runtime_error if they exceed
/// the limits.
std::vector<std::filesystem::path> PlainFilesBelow(const std::filesystem::path& directory,
                                                   std::uint64_t max_bytes) {
  std::vector<std::filesystem::path> files;
  std::uint64_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    // The status of the link itself: a link could pack files from anywhere on the machine. The
    // iterator follows no links to directories either.
    if (!std::filesystem::is_regular_file(entry.symlink_status())) continue;
    files.push_back(entry.path());
    bytes += entry.file_size();
    if (bytes > max_bytes || files.size() > kMaxZippedFiles) {
      throw std::runtime_error(Quoted(directory.filename().string()) + " is larger than " +
                               std::to_string(max_bytes >> 20) + " MiB; copy it from " +
                               directory.string());
    }
  }
  // The order of a directory is arbitrary; that of an archive should not be.
  std::ranges::sort(files);
  return files;
}

/// Callback of libarchive: appends the bytes to the string.
la_ssize_t TakeBytes(archive*, void* zip, const void* bytes, std::size_t count) {
  static_cast<std::string*>(zip)->append(static_cast<const char*>(bytes), count);
  return static_cast<la_ssize_t>(count);
}

/// Sets the locale of this thread to UTF-8 during its lifetime, whatever the user's language:
/// libarchive then marks names as UTF-8. uselocale() acts on this thread only, so other threads and
/// the rest of the program are not affected. Without a C.UTF-8 locale nothing changes.
class Utf8Names {
 public:
  Utf8Names()
      : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)),
        before_(utf8_ != nullptr ? uselocale(utf8_) : nullptr) {}
  ~Utf8Names() {
    if (utf8_ == nullptr) return;
    uselocale(before_);
    freelocale(utf8_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;

 private:
  locale_t utf8_, before_;
};

/// Writer of a ZIP file in memory.
class Zipper {
 public:
  explicit Zipper(std::string* zip) : archive_(archive_write_new(), &archive_write_free) {
    Check(archive_write_set_format_zip(archive_.get()));
    Check(archive_write_set_bytes_in_last_block(archive_.get(), 1));  // no padding
    Check(archive_write_open(archive_.get(), zip, nullptr, &TakeBytes, nullptr));
  }

  // Names keep their relative path below the directory's own name, so that unpacking makes one
  // folder.
  void Add(const std::string& name, const std::string& text, std::time_t changed) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(
        archive_entry_new2(archive_.get()), &archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(text.size()));
    archive_entry_set_mtime(entry.get(), changed, 0);
    Check(archive_write_header(archive_.get(), entry.get()));
    if (archive_write_data(archive_.get(), text.data(), text.size()) < 0) Check(ARCHIVE_FATAL);
  }
  void Finish() { Check(archive_write_close(archive_.get())); }

 private:
  /// Throws on errors. Warnings are ignored: they concern letters in names that other systems may
  /// not know.
  void Check(int result) const {
    if (result >= ARCHIVE_WARN) return;
    const char* reason = archive_error_string(archive_.get());
    throw std::runtime_error("cannot be packed: " + std::string(reason ? reason : "unknown"));
  }

  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

}  // namespace

std::string Zipped(const std::filesystem::path& directory, std::uint64_t max_bytes) {
  const Utf8Names names;
  std::string zip;
  Zipper zipper(&zip);
  // The whole archive is made in memory: the server sends complete responses, and max_bytes bounds
  // it.
  std::uint64_t left = max_bytes;
  for (const auto& path : PlainFilesBelow(directory, max_bytes)) {
    // The file may have grown since it was listed; `left` limits all files together.
    const std::string text = ReadFile(path, left);
    left -= text.size();
    zipper.Add((directory.filename() / path.lexically_relative(directory)).string(), text,
               StateOf(path).changed / 1'000'000'000LL);
  }
  zipper.Finish();
  return zip;
}

}  // namespace smile::library

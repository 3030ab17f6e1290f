// Files as wholes, with the two kinds of failure apart: InputError for what the user can mend in
// the input, std::runtime_error for what the system refuses.

#include "base/files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "base/diagnostic.h"
#include "base/library_folder.h"

namespace smile {
namespace {

/// Throws std::runtime_error for a failure of the system, unlike InputError for wrong input.
[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

std::string SystemReason() { return std::strerror(errno); }

/// Writes a file in place.
/// @returns the reason of a failure; empty after success.
std::string WriteInto(const std::filesystem::path& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  // Flushed here, since a destructor would hide that the disk is full.
  if (file) file.write(text.data(), static_cast<std::streamsize>(text.size())).flush();
  return file ? "" : "cannot be written: " + SystemReason();
}

}  // namespace

std::string ReadFile(const std::filesystem::path& path, std::size_t max_bytes) {
  const auto wrong = [&path](const std::string& what) {
    return InputError({path.string(), 0, "", what});
  };
  std::error_code error;
  // A pipe or device could block or never end; only regular files are read.
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw wrong("no such file");
  if (error) Fail(path, "cannot be read: " + error.message());
  if (!std::filesystem::is_regular_file(status)) throw wrong("is not a regular file");

  std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) Fail(path, "cannot be opened: " + SystemReason());
  // Not by the file's size: files in /proc report 0.
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file.get())) {
    // Counted while reading, since the size of a growing file is known only at its end.
    if (text.size() + count > max_bytes) {
      throw wrong("is larger than " + std::to_string(max_bytes) + " bytes");
    }
    text.append(buffer, count);
  }
  if (std::ferror(file.get())) Fail(path, "cannot be read: " + SystemReason());
  return text;
}

void WriteFile(const std::filesystem::path& path, std::string_view text) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  // A device or pipe cannot be replaced, only written.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    if (const std::string reason = WriteInto(path, text); !reason.empty()) Fail(path, reason);
    return;
  }
  // The target of a link is replaced, not the link.
  std::filesystem::path target = path;
  if (std::filesystem::is_symlink(path, error)) {
    target = std::filesystem::weakly_canonical(path, error);
    if (error) Fail(path, "cannot be written: " + error.message());
  }
  // In the same folder, and thus on the same file system, as renaming requires.
  const std::filesystem::path neighbour = target.string() + ".part";
  if (const std::string reason = WriteInto(neighbour, text); !reason.empty()) {
    std::remove(neighbour.c_str());
    Fail(path, reason);
  }
  // Renaming is atomic: readers see the old file or the new one.
  std::filesystem::rename(neighbour, target, error);
  if (!error) return;
  std::remove(neighbour.c_str());
  Fail(path, "cannot be written: " + error.message());
}

void MakeDirectories(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) Fail(path, "cannot be created: " + error.message());
}

bool IsWithin(const std::filesystem::path& path, const std::filesystem::path& folder) {
  std::error_code error;
  // canonical() follows all links of both paths: a link inside the folder that leads out of it is
  // not within.
  const std::filesystem::path there = std::filesystem::canonical(path, error);
  if (error) return false;
  const std::filesystem::path around = std::filesystem::canonical(folder, error);
  // Compared by path elements: /a/bc is not within /a/b.
  return !error && std::mismatch(around.begin(), around.end(), there.begin(), there.end()).first ==
                       around.end();
}

std::filesystem::path DataFile(std::string_view relative_path) {
  // The environment variable first, then the installation, then the source tree. Relative to the
  // program or the Python package, so that an installation can be moved as a whole.
  std::vector<std::filesystem::path> roots;
  if (const char* named = std::getenv("SMILE_DATA_DIR")) roots.emplace_back(named);
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) roots.push_back(program.parent_path().parent_path() / "share" / "smile");
  if (const auto package = LibraryFolder(); !package.empty()) {
    roots.push_back(package / "share" / "smile");
  }
  constexpr std::string_view kSourceFolder = SMILE_SOURCE_DIR;
  if (!kSourceFolder.empty()) roots.emplace_back(kSourceFolder);

  std::string looked_at;
  for (const auto& root : roots) {
    if (std::filesystem::exists(root / relative_path, error)) return root / relative_path;
    looked_at += "\n  " + (root / relative_path).string();
  }
  throw std::runtime_error(std::string(relative_path) + ": not found; looked at" + looked_at);
}

}  // namespace smile

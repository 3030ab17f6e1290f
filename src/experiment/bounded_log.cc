// What people look for in a long log is its beginning (the cause) and its end (the failure), so the
// middle is what gets lost. The beginning is flushed at once and can be followed while the program
// runs.

#include "experiment/bounded_log.h"

#include <algorithm>
#include <stdexcept>

#include "base/wording.h"

namespace smile::experiment {
namespace {

constexpr std::size_t kMaxLineBytes = 500;

}  // namespace

BoundedLog::BoundedLog(const std::filesystem::path& path) : file_(path, std::ios::binary) {
  if (!file_) throw std::runtime_error(path.string() + ": cannot be written");
}

void BoundedLog::Add(std::string_view text) {
  // The beginning goes to the file at once; the end is kept in memory, as its start is known only
  // at Finish().
  end_ += text;
  const std::size_t beginning = std::min(text.size(), kBeginBytes - begin_bytes_);
  file_ << text.substr(0, beginning) << std::flush;
  begin_bytes_ += beginning;
  unwritten_bytes_ += text.size() - beginning;
  // Trimmed only at twice the size: erasing at the front moves the rest, which would be slow for
  // each line.
  if (end_.size() > 2 * kEndBytes) end_.erase(0, end_.size() - kEndBytes);
}

void BoundedLog::Finish() {
  // A short log lies in the file already; its bytes in `end_` must not be written twice.
  const std::size_t kept = std::min({unwritten_bytes_, kEndBytes, end_.size()});
  if (unwritten_bytes_ > kept) {
    file_ << "\n... " << unwritten_bytes_ - kept << " bytes are omitted ...\n";
  }
  file_ << end_.substr(end_.size() - kept);
  file_.close();
}

std::string BoundedLog::last_line() const {
  const std::size_t last = end_.find_last_not_of(" \t\r\n");
  if (last == std::string::npos) return {};
  const std::size_t before = end_.find_last_of('\n', last);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return Printable(end_.substr(begin, std::min(last + 1 - begin, kMaxLineBytes)));
}

}  // namespace smile::experiment

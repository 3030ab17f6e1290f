#include "brain/brain_log.h"

#include <string>
#include <system_error>

namespace smile::brain {

BrainLog::BrainLog(const std::filesystem::path& directory, const char* file) {
  if (!directory.empty()) path_ = directory / file;
}

// A continued recording appends to its log; the limit counts what is there already.
void BrainLog::Open() {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_, error);
  if (!error) bytes_ = size;  // of a recording that is continued
  file_.reset(std::fopen(path_.c_str(), "a"));
  if (!file_) path_.clear();
}

void BrainLog::Write(std::string_view line) {
  if (!file_ && !path_.empty()) Open();
  if (!file_) return;
  std::string text(line);
  bytes_ += text.size() + 1;
  // The last line says that the log ends; nothing follows it.
  const bool is_full = bytes_ > kMaxBytes;
  if (is_full) text = "... further output is not kept";
  text += '\n';
  std::fwrite(text.data(), 1, text.size(), file_.get());
  // Flushed line by line, so that the log is complete even if the simulator is killed.
  std::fflush(file_.get());
  if (!is_full) return;
  file_.reset();
  path_.clear();
}

}  // namespace smile::brain

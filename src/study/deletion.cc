#include "study/deletion.h"

#include <array>
#include <cctype>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "recording/append_file.h"

namespace smile::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSearchedBytes = std::size_t{4} << 30;

std::size_t NumFiles(const fs::path& folder) {
  std::size_t count = 0;
  if (!fs::exists(folder)) return 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    count += entry.is_directory() ? 0 : 1;
  }
  return count;
}

void RemoveAll(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": cannot be deleted: " + error.message());
}

/// Returns true if the word occurs in a text and is no part of a longer word.
bool ContainsWord(const std::string& text, const std::string& word) {
  const auto is_part = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if (!(at > 0 && is_part(at - 1)) && !is_part(at + word.size())) return true;
  }
  return false;
}

/// In other files, three bytes may be those of an id by chance.
bool IsText(const fs::path& file) {
  static constexpr std::array<std::string_view, 8> kEndings{".json", ".jsonl", ".csv", ".html",
                                                            ".md",   ".txt",   ".xml", ""};
  const std::string ending = file.extension().string();
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

}  // namespace

DeletionProof DeleteParticipant(const StudyData& data, const std::string& id) {
  const Participant* found = data.FindById(id);
  if (found == nullptr) {
    throw InputError(
        Diagnostic{.file = data.folder().string(),
                   .message = "found no participant " + Quoted(id) +
                              ", expected one of those that `smile study links` lists"});
  }
  const Participant participant = *found;
  {
    // Fails while a server writes to it.
    const recording::AppendFile lock(participant.events_file(), recording::AppendFile::kExisting);
  }
  DeletionProof proof;
  for (const fs::path& folder : {participant.folder, data.folder() / kReportFolder}) {
    proof.num_deleted += NumFiles(folder);
    RemoveAll(folder);
  }
  for (const auto& entry : fs::recursive_directory_iterator(data.folder())) {
    bool remains = ContainsWord(entry.path().filename().string(), id);
    if (entry.is_regular_file()) {
      ++proof.num_searched;
      const std::string text = ReadFile(entry.path(), kMaxSearchedBytes);
      remains = remains || text.find(participant.token) != std::string::npos ||
                (IsText(entry.path()) && ContainsWord(text, id));
    }
    if (remains) proof.remains.push_back(entry.path().string());
  }
  return proof;
}

}  // namespace smile::study

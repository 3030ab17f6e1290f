// Scenes by name, read from the folder each time, so that people may edit and add files while the
// studio runs. Titles come from the first comment of a file: no index has to be kept in agreement
// with the scenes.

#include "library/scene_catalog.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/wording.h"
#include "xml/parse.h"

namespace smile::library {
namespace {

/// Returns the beginning of a file; empty if it cannot be read.
std::string BeginningOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  // Titles are within the first lines; scenes may be long.
  std::string text(2048, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// Returns the comment before the root element, on one line; empty without one.
std::string CommentOf(const std::filesystem::path& path) {
  // The beginning of a file is not well-formed XML, but the comment has been read before that
  // fault.
  std::string text = xml::Parse(BeginningOf(path), path.string()).comment;
  std::ranges::replace(text, '\n', ' ');
  return Printable(text);
}

/// Returns the first sentence, or its first part that can stand alone.
std::string_view FirstPhraseOf(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    // A stop counts only before a blank or at the end: `0.5` and `robot:arm` do not end a phrase.
    const bool is_stop = std::string_view(".:;").find(text[i]) != std::string_view::npos;
    if (is_stop && (i + 1 == text.size() || text[i + 1] == ' ')) return text.substr(0, i);
    if (text[i] == '(') return text.substr(0, i);
  }
  return text;
}

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::string SceneTitleOf(const std::filesystem::path& path) {
  constexpr std::string_view kAuthor = "Authored for SMILE. ";  // in the shipped scenes
  constexpr std::size_t kMaxTitle = 200;
  const std::string comment = CommentOf(path);
  std::string_view text = Trimmed(comment);
  if (text.starts_with(kAuthor)) text.remove_prefix(kAuthor.size());
  const std::string_view title = Trimmed(FirstPhraseOf(text));
  // A longer "phrase" is a comment of another kind; the name of the file then says more.
  const bool is_fit = !title.empty() && title.size() <= kMaxTitle;
  return is_fit ? std::string(title) : path.stem().string();
}

}  // namespace

Json SceneCatalog::List() const {
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder_, error), end; !error && it != end;
       it.increment(error)) {
    // Names are collected first, sorted, and only then read: the order of the iterator is
    // arbitrary.
    if (it->path().extension() != ".xml" || names.size() >= kMaxScenes) continue;
    if (FileOf(it->path().stem().string())) names.push_back(it->path().stem().string());
  }
  std::ranges::sort(names);
  Json list = Json::array();
  for (const std::string& name : names) {
    list.push_back({{"name", name},
                    {"title", SceneTitleOf(folder_ / (name + ".xml"))},
                    {"picture", "/scenes/" + name + ".png"}});
  }
  return list;
}

std::optional<std::filesystem::path> SceneCatalog::FileOf(const std::string& name) const {
  const bool is_plain = !name.empty() && name.size() <= 200 && name.front() != '.' &&
                        name.find('/') == std::string::npos && name.find('\0') == std::string::npos;
  if (!is_plain) return std::nullopt;
  std::filesystem::path file = folder_ / (name + ".xml");
  std::error_code error;
  // Links are refused, as they may lead out of the folder.
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error))) {
    return std::nullopt;
  }
  return file;
}

}  // namespace smile::library

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"

namespace smile::studio {

/// The recordings in one folder, which users name, look for, throw away and take back. An id is the
/// name of a recording's directory; ids from outside that name anything else are refused.
class Library {
 public:
  explicit Library(std::filesystem::path root) : root_(std::move(root)) {}

  /// Newest first: `[{"id","title","notes","scene","seconds","made","segments","binned"}]`. One
  /// that cannot be read is there with its `error`.
  Json List() const;
  /// @throws RequestError if there is no such recording. So do all below.
  std::filesystem::path DirectoryOf(const std::string& id) const;
  void Rename(const std::string& id, const std::optional<std::string>& title,
              const std::optional<std::string>& notes);
  /// Into the folder `.bin` under the root; nothing is ever deleted.
  void Bin(const std::string& id);
  void Unbin(const std::string& id);
  /// Its segments and history: `{"segments":[{"number","words","begin","end"}],
  /// "steps":[{"step","parent","words","begin","end","on_way"}],"seconds"}` [s].
  Json TimelineOf(const std::string& id) const;
  /// All its files in one.
  std::string ZipOf(const std::string& id) const;

  const std::filesystem::path& root() const { return root_; }

 private:
  std::filesystem::path root_;
};

}  // namespace smile::studio

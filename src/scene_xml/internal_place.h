#pragma once

#include <string>
#include <utility>
#include <vector>

namespace smile::scene_xml {

/// Where something was written and, when a template brought it, which instance asked for it.
struct Place {
  int file = 0;        ///< of Sources; 0 is the main file
  int line = 0;        ///< 1 is the first
  int expansion = -1;  ///< of Sources; -1 when it stands where it was written
};

/// The files a scene is made of, and the instances that were expanded on the way.
class Sources {
 public:
  explicit Sources(std::string main_file) : files_{std::move(main_file)} {}

  /// @param name  as the user would name it.
  /// @returns the `file` of places in it.
  int AddFile(std::string name);
  /// @returns the `expansion` of places in what the instance at `instance` becomes.
  int AddExpansion(const Place& instance);

  const std::string& FileOf(const Place& place) const { return files_[place.file]; }
  /// `tower.xml:12`.
  std::string Address(const Place& place) const;
  /// ` (in the instance at room.xml:7, within that at house.xml:3)`: the instance that brought it
  /// and the one it all began with. Empty when there is none.
  std::string ExpansionNote(const Place& place) const;

 private:
  std::vector<std::string> files_;
  std::vector<Place> expansions_;  // where the instances stand
};

}  // namespace smile::scene_xml

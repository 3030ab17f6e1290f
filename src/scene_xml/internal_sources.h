#pragma once

#include <string>
#include <utility>
#include <vector>

namespace smile::scene_xml {

/// Place in the files and, for content of a template, the instance that was expanded.
struct SourceLocation {
  int file = 0;        ///< of Sources; 0 is the main file
  int line = 0;        ///< 1 is the first
  int expansion = -1;  ///< of Sources; -1 if it is not from a template
};

/// Files of a scene, and the instances that were expanded.
class Sources {
 public:
  explicit Sources(std::string main_file) : files_{std::move(main_file)} {}

  /// @param name  for people.
  /// @returns the `file` of places in it.
  int AddFile(std::string name);
  /// @returns the `expansion` of places in the content of the instance at `instance`.
  int AddExpansion(const SourceLocation& instance);

  const std::string& FileOf(const SourceLocation& place) const { return files_[place.file]; }
  /// Returns an address such as `tower.xml:12`.
  std::string Address(const SourceLocation& place) const;
  /// Returns a note such as ` (in the instance at room.xml:7, within that at house.xml:3)`: the
  /// innermost instance and the outermost one. Empty outside instances.
  std::string ExpansionNote(const SourceLocation& place) const;

 private:
  std::vector<std::string> files_;
  std::vector<SourceLocation> expansions_;  // places of the instances
};

}  // namespace smile::scene_xml

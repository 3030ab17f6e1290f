#pragma once

#include <set>
#include <string>

namespace smile::scene_xml {

/// Registry that gives every whole object and every pointable part a unique id.
///
/// A missing id becomes `obj`; an id in use gets `#` and the next number of one counter for the
/// whole scene. Recordings and their readers identify objects by these names, so the rule is fixed:
/// objects with the ids -, -, a, a, -, obj become obj, obj#0, a, a#1, obj#2, obj#3.
class IdRegistry {
 public:
  /// Returns the id for an element that requests `wanted`, which may be empty.
  std::string Claim(const std::string& wanted);

  /// Claims an id that already has its `#` (from a scene that the program wrote), unchanged.
  /// Returns false if it is in use.
  [[nodiscard]] bool ClaimExactly(const std::string& id) { return taken_.insert(id).second; }

 private:
  std::set<std::string> taken_;
  int next_number_ = 0;
};

}  // namespace smile::scene_xml

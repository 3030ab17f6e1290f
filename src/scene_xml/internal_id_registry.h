#pragma once

#include <set>
#include <string>

namespace smile::scene_xml {

/// Gives every whole object and every pointable part an id of its own.
///
/// An id that is missing becomes `obj`; one that is taken gets `#` and the next number of one
/// counter for the whole scene. Recordings and their readers know objects by these names, so the
/// rule is fixed: objects with the ids -, -, a, a, -, obj become obj, obj#0, a, a#1, obj#2, obj#3.
class IdRegistry {
 public:
  /// The id to use for an element that asks for `wanted`, which may be empty.
  std::string Claim(const std::string& wanted);

  /// For an id that already has its `#` (a scene the program wrote): that one or none. False when
  /// it is taken.
  [[nodiscard]] bool ClaimExactly(const std::string& id) { return taken_.insert(id).second; }

 private:
  std::set<std::string> taken_;
  int next_number_ = 0;
};

}  // namespace smile::scene_xml

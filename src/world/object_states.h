#pragma once

#include <utility>
#include <vector>

#include "world/object.h"

namespace smile::world {

/// States of the objects of a scene. Keeps only those that differ from the initial one, so that
/// objects to which nothing has happened cost nothing, however many there are.
class ObjectStates {
 public:
  using Numbered = std::pair<model::ObjectIndex, ObjectState>;

  /// Returns the state of any object of the scene.
  ObjectState operator[](model::ObjectIndex object) const;
  void Set(model::ObjectIndex object, const ObjectState& state);
  /// Returns the states that differ from the initial one, in scene order.
  const std::vector<Numbered>& changed() const { return changed_; }

  bool operator==(const ObjectStates&) const = default;

 private:
  std::vector<Numbered> changed_;
};

}  // namespace smile::world

#pragma once

#include <string>
#include <vector>

#include "model/relations.h"
#include "task/effects.h"
#include "task/episode.h"
#include "task/looks.h"

namespace smile::task {

using model::Relation;

/// What a demonstration achieved: the task is to achieve the same elsewhere on the table.
struct Structure {
  /// What hands moved, with what these stand on or lie in down to the table, and what slides in
  /// them or is fastened to them, in scene order, as they lay in the end. None where nothing was
  /// done but pressing switches.
  std::vector<scene::ObjectSpec> objects;
  std::vector<Relation> relations;  ///< of these objects, in the end
  std::vector<std::string> order;   ///< of their placements, see PlacementsOf()
  std::vector<Effect> effects;
  /// What else the effects are about: it has no place in the structure, in scene order.
  std::vector<scene::ObjectSpec> others;
  /// What fell from the table during the demonstration, in this order.
  std::vector<std::string> fallen;
  Attention attention;  ///< what the demonstrator told of the objects

  /// True when something of it cannot be moved: then it may stand nowhere else.
  bool is_fixed() const;
  /// What matters of an object; nothing in particular if nothing was told.
  std::vector<std::string> AttendedOf(const std::string& object) const;
};

/// @throws InputError if the recording's trace cannot be read, or nothing was achieved.
Structure StructureOf(const recording::Recording& demonstration);

}  // namespace smile::task

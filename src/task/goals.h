#pragma once

#include <string>
#include <vector>

#include "task/structure.h"
#include "texts/user_message.h"

namespace smile::task {

/// Part of what a demonstration achieved: the place of an object, or an effect.
struct Goal {
  std::string id;  ///< of the object; of an effect, the words: unique within a structure
  texts::UserMessage words;
  bool is_place = true;

  bool operator==(const Goal&) const = default;
};

/// Returns the goals of a structure: places in scene order, except of what cannot be moved; then
/// effects.
std::vector<Goal> GoalsOf(const Structure& structure, double meters_per_unit);

/// Returns a structure without some of its goals. Objects whose places do not count may be
/// anywhere, also in contact with the structure. If nothing remains relative to which the place of
/// the whole was determined, it may stand anywhere.
/// @param ids  of goals.
/// @throws std::invalid_argument for an id that is no goal, and if no goal remains.
Structure WithoutGoals(Structure structure, const std::vector<std::string>& ids,
                       double meters_per_unit);

}  // namespace smile::task

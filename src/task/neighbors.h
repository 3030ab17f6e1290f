#pragma once

#include <string>
#include <vector>

#include "task/match.h"
#include "task/object_error.h"

namespace smile::task {

/// Returns the pairs of objects of a structure whose surfaces are almost in contact: those that
/// stand on, in or closely beside one another. Needs `objects` and `order`.
std::vector<Neighbors> NeighborsOf(const Structure& structure);

/// Returns the objects at the end of a demonstration that touch the structure without being part of
/// it.
std::vector<scene::ObjectSpec> BystandersOf(const Structure& structure,
                                            const Episode& demonstration);

/// Returns the deviations of all neighbors from their places relative to each other.
/// @param goal  poses of the structure's objects in the scene of the outcome, by demo id.
std::vector<NeighborError> NeighborErrorsOf(const Structure& structure, const Episode& outcome,
                                            const Match& match, const ObjectPoses& goal);

/// Returns the ids of objects of the outcome's scene that do not belong to the structure and touch
/// it at the end: those that a hand or gripper held, and that look like none that touched the
/// demonstrated structure. What only fell there, as from a hatch that was opened, does not count.
std::vector<std::string> IntrudersOf(const Structure& structure, const Episode& outcome,
                                     const Match& match);

}  // namespace smile::task

#pragma once

namespace smile::world {

/// What is moved to a place has room there if it overlaps other objects by no more than this [m].
inline constexpr double kMaxOverlap = 0.002;

}  // namespace smile::world

#pragma once

#include <cstdint>
#include <random>
#include <string_view>

#include "experiment/range.h"

namespace smile::experiment::internal {

/// Returns a generator for one of the circumstances of a seed. The layout of the same seed has
/// another.
std::mt19937_64 GeneratorOf(std::string_view circumstance, std::uint64_t seed);

/// Draws a number.
double DrawUnrounded(const Range& range, std::string_view circumstance, std::uint64_t seed);

/// Draws a number with six decimals, for people who read it.
double Draw(const Range& range, std::string_view circumstance, std::uint64_t seed);

/// Draws an index below `count`, which is above 0.
std::size_t DrawIndex(std::size_t count, std::string_view circumstance, std::uint64_t seed);

}  // namespace smile::experiment::internal

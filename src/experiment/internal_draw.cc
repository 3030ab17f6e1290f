#include "experiment/internal_draw.h"

#include <cmath>

#include "base/state_hash.h"
#include "base/uniform.h"

namespace smile::experiment::internal {

std::mt19937_64 GeneratorOf(std::string_view circumstance, std::uint64_t seed) {
  StateHash hash;
  hash.Add(circumstance);
  hash.Add(seed);
  return std::mt19937_64(hash.value());
}

double DrawUnrounded(const Range& range, std::string_view circumstance, std::uint64_t seed) {
  std::mt19937_64 random = GeneratorOf(circumstance, seed);
  return Uniform(&random, range.low, range.high);
}

double Draw(const Range& range, std::string_view circumstance, std::uint64_t seed) {
  constexpr double kDecimals = 1e6;
  return std::round(DrawUnrounded(range, circumstance, seed) * kDecimals) / kDecimals;
}

std::size_t DrawIndex(std::size_t count, std::string_view circumstance, std::uint64_t seed) {
  std::mt19937_64 random = GeneratorOf(circumstance, seed);
  return static_cast<std::size_t>(Uniform(&random, 0, static_cast<double>(count)));
}

}  // namespace smile::experiment::internal

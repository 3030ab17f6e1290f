#include "experiment/variation.h"

#include <random>
#include <string_view>

#include "base/state_hash.h"
#include "base/uniform.h"

namespace smile::experiment {
namespace {

constexpr std::size_t kMaxNameBytes = 4096;
constexpr double kMostNoise = 1000;
constexpr std::uint64_t kMostSeed = std::uint64_t{1} << 53;

/// Returns a generator for one of the circumstances. The layout of the same seed has another.
std::mt19937_64 GeneratorOf(std::string_view circumstance, std::uint64_t seed) {
  StateHash hash;
  hash.Add(circumstance);
  hash.Add(seed);
  return std::mt19937_64(hash.value());
}

const std::string& Draw(const std::vector<std::string>& choices, std::string_view circumstance,
                        std::uint64_t seed) {
  std::mt19937_64 random = GeneratorOf(circumstance, seed);
  const double place = Uniform(&random, 0, static_cast<double>(choices.size()));
  return choices[static_cast<std::size_t>(place)];
}

double Draw(const Range& range, std::string_view circumstance, std::uint64_t seed) {
  std::mt19937_64 random = GeneratorOf(circumstance, seed);
  return Uniform(&random, range.low, range.high);
}

}  // namespace

Variation DrawVariation(const VariationChoices& choices, std::uint64_t seed) {
  return {.scene = Draw(choices.scenes, "scene", seed),
          .level = Draw(choices.levels, "level", seed),
          .eye = Draw(choices.eyes, "eye", seed),
          .noise = {.joints = Draw(choices.joints, "joints", seed),
                    .image = Draw(choices.image, "image", seed),
                    .depth = Draw(choices.depth, "depth", seed),
                    .seed = seed}};
}

Json ToJson(const Variation& variation) {
  return {{"scene", variation.scene},
          {"level", variation.level},
          {"eye", variation.eye},
          {"noise",
           {{"joints", variation.noise.joints},
            {"image", variation.noise.image},
            {"depth", variation.noise.depth},
            {"seed", variation.noise.seed}}}};
}

Variation VariationIn(const JsonNode& node) {
  const JsonNode noise = node.Member("noise");
  Variation variation;
  variation.scene = node.Member("scene").ShortString(kMaxNameBytes);
  variation.level = node.Member("level").ShortString(kMaxNameBytes);
  variation.eye = node.Member("eye").ShortString(kMaxNameBytes);
  variation.noise.joints = noise.Member("joints").Number(0, kMostNoise);
  variation.noise.image = noise.Member("image").Number(0, kMostNoise);
  variation.noise.depth = noise.Member("depth").Number(0, kMostNoise);
  variation.noise.seed = noise.Member("seed").Whole(0, kMostSeed);
  return variation;
}

}  // namespace smile::experiment

#include "experiment/variation.h"

#include <array>
#include <string_view>

#include "experiment/internal_draw.h"

namespace smile::experiment {
namespace {

using internal::Draw;

constexpr std::size_t kMaxNameBytes = 4096;
constexpr double kMostNoise = 1000, kMostSpeed = 10;
constexpr std::uint64_t kMostSeed = std::uint64_t{1} << 53;

const std::string& Choose(const std::vector<std::string>& choices, std::string_view circumstance,
                          std::uint64_t seed) {
  return choices[internal::DrawIndex(choices.size(), circumstance, seed)];
}

brain::BehaviorVariation DrawBehavior(const VariationChoices& choices, std::uint64_t seed) {
  brain::BehaviorVariation behavior;
  if (choices.speed) behavior.speed = Draw(*choices.speed, "speed", seed);
  // A program of its own draws from this seed: with another one for each choice, choices that are
  // made in the same way do not go together.
  const auto seed_for = [&](bool varies, std::string_view circumstance) {
    return varies ? std::optional(internal::GeneratorOf(circumstance, seed)() >> 32) : std::nullopt;
  };
  behavior.order = seed_for(choices.varies_order, "order");
  behavior.grasp = seed_for(choices.varies_grasp, "grasp");
  behavior.path = seed_for(choices.varies_path, "path");
  return behavior;
}

template <class Value>
Json NumberOrNull(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json ToJson(const brain::BehaviorVariation& behavior) {
  return {{"speed", NumberOrNull(behavior.speed)},
          {"order", NumberOrNull(behavior.order)},
          {"grasp", NumberOrNull(behavior.grasp)},
          {"path", NumberOrNull(behavior.path)}};
}

brain::BehaviorVariation BehaviorIn(const JsonNode& node) {
  brain::BehaviorVariation behavior;
  if (!node.Member("speed").IsNull()) {
    behavior.speed = node.Member("speed").Number(0.01, kMostSpeed);
  }
  const auto seed_in = [&](const char* name) -> std::optional<std::uint64_t> {
    if (node.Member(name).IsNull()) return std::nullopt;
    return node.Member(name).Whole(0, kMostSeed);
  };
  behavior.order = seed_in("order");
  behavior.grasp = seed_in("grasp");
  behavior.path = seed_in("path");
  return behavior;
}

}  // namespace

Variation DrawVariation(const VariationChoices& choices, std::uint64_t seed) {
  Variation variation{.scene = Choose(choices.scenes, "scene", seed),
                      .level = Choose(choices.levels, "level", seed),
                      .eye = Choose(choices.eyes, "eye", seed),
                      .noise = {.joints = internal::DrawUnrounded(choices.joints, "joints", seed),
                                .image = internal::DrawUnrounded(choices.image, "image", seed),
                                .depth = internal::DrawUnrounded(choices.depth, "depth", seed),
                                .seed = seed}};
  const auto colors = choices.colors.find(variation.scene);
  variation.looks =
      DrawLooks(choices.looks,
                colors == choices.colors.end() ? std::vector<std::string>() : colors->second, seed);
  variation.behavior = DrawBehavior(choices, seed);
  variation.disturbance = DrawDisturbance(choices.disturbance, seed);
  return variation;
}

Json ToJson(const VariationChoices& choices) {
  return {{"looks", ToJson(choices.looks)},
          {"speed", choices.speed ? Json{choices.speed->low, choices.speed->high} : Json()},
          {"order", choices.varies_order},
          {"grasp", choices.varies_grasp},
          {"path", choices.varies_path},
          {"disturbance", ToJson(choices.disturbance)}};
}

Json ToJson(const Variation& variation) {
  return {{"scene", variation.scene},
          {"level", variation.level},
          {"eye", variation.eye},
          {"noise",
           {{"joints", variation.noise.joints},
            {"image", variation.noise.image},
            {"depth", variation.noise.depth},
            {"seed", variation.noise.seed}}},
          {"looks", variation.looks == Looks() ? Json() : ToJson(variation.looks)},
          {"behavior", ToJson(variation.behavior)},
          {"disturbance", variation.disturbance ? ToJson(*variation.disturbance) : Json()}};
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
  ReadChanges(node, &variation);
  return variation;
}

void ReadChanges(const JsonNode& node, Variation* variation) {
  const auto has = [&](const char* name) { return node.Has(name) && !node.Member(name).IsNull(); };
  if (has("looks")) variation->looks = LooksIn(node.Member("looks"));
  if (has("behavior")) variation->behavior = BehaviorIn(node.Member("behavior"));
  if (has("disturbance")) variation->disturbance = DisturbanceIn(node.Member("disturbance"));
}

std::string ChangesText(const Variation& variation) {
  Json json = Json::object();
  if (variation.looks != Looks()) json["looks"] = ToJson(variation.looks);
  if (variation.behavior != brain::BehaviorVariation()) {
    json["behavior"] = ToJson(variation.behavior);
  }
  if (variation.disturbance) json["disturbance"] = ToJson(*variation.disturbance);
  return json.empty() ? "" : ToText(json);
}

Variation ParseChanges(const std::string& text) {
  Variation variation;
  if (text.empty()) return variation;
  const Json json = ParseJson(text);
  const std::string file = "--variation";
  const JsonNode node(json, file, "");
  node.ExpectMembers(std::array<std::string_view, 3>{"looks", "behavior", "disturbance"});
  ReadChanges(node, &variation);
  return variation;
}

}  // namespace smile::experiment

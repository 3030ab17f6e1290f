#include "app/variation_options.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "app/options.h"
#include "base/wording.h"
#include "scene_xml/value_ranges.h"

namespace smile::app {
namespace {

using experiment::Range;

/// Range that a key of an option sets.
struct KeyedRange {
  std::string_view key;
  Range* range;
  Range allowed;
};

/// Parses a number, or `A..B`.
Range ParseRange(const std::string& text, const Range& allowed, const std::string& what) {
  const std::size_t dots = text.find("..");
  const auto number = [&](const std::string& part) {
    double value = 0;
    const char* end = part.data() + part.size();
    const auto [rest, error] = std::from_chars(part.data(), end, value);
    if (error == std::errc() && rest == end && value >= allowed.low && value <= allowed.high) {
      return value;
    }
    throw std::invalid_argument(what + " is " + Quoted(text) + ", expected numbers from " +
                                NumberText(allowed.low) + " to " + NumberText(allowed.high) +
                                " as A..B, or one");
  };
  const bool is_one = dots == std::string::npos;
  const Range range{number(text.substr(0, dots)), number(is_one ? text : text.substr(dots + 2))};
  if (range.low > range.high) {
    throw std::invalid_argument(what + ": found the range " + text +
                                ", expected the lower number first");
  }
  return range;
}

/// Parses `key=A..B,key=C`; ranges of keys that are not mentioned stay.
void ParseRanges(const std::string& text, const std::string& option,
                 const std::vector<KeyedRange>& ranges) {
  std::vector<std::string_view> keys;
  for (const KeyedRange& range : ranges) keys.push_back(range.key);
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string key = part.substr(0, equals);
    const auto found = std::ranges::find(ranges, key, &KeyedRange::key);
    if (found == ranges.end()) {
      throw std::invalid_argument(option + ": found " + Quoted(key) + ", expected " + OneOf(keys) +
                                  DidYouMean(key, keys));
    }
    *found->range = ParseRange(part.substr(std::min(equals + 1, part.size())), found->allowed,
                               option + ": " + key);
  }
}

/// Adds the displacement of cameras.
void AddJitter(const VariationOptions& options, experiment::LookChoices* looks) {
  const Range view{scene_xml::kViewScale.least, scene_xml::kViewScale.most};
  ParseRanges(options.jitter, "jitter",
              {{"shift", &looks->shift, {-100, 100}},
               {"tilt", &looks->tilt_deg, {-180, 180}},
               {"view", &looks->view, view}});
  if (options.jitter.empty()) return;
  looks->cameras = options.jittered_cameras;
  if (looks->cameras.empty()) looks->cameras = {sim::kEyeCamera};
  std::ranges::sort(looks->cameras);
  if (std::ranges::adjacent_find(looks->cameras) != looks->cameras.end()) {
    throw std::invalid_argument("jitter-camera: found a camera twice, expected it once");
  }
}

void AddLooks(const VariationOptions& options, experiment::LookChoices* looks) {
  const Range brightness{0, scene_xml::kBrightness.most};
  ParseRanges(options.looks, "looks",
              {{"brightness", &looks->brightness, brightness},
               {"warmth", &looks->warmth, {-1, 1}},
               {"turn", &looks->turn_deg, {-360, 360}},
               {"hue", &looks->hue_deg, {-180, 180}},
               {"value", &looks->value, {0, 4}},
               {"table", &looks->table, {0, 1}},
               {"tint", &looks->tint, {0, 1}},
               {"background", &looks->background, {0, 1}}});
  if (!options.patterns.empty()) looks->patterns = options.patterns;
  AddJitter(options, looks);
}

}  // namespace

void AddVariationOptions(CLI::App* command, VariationOptions* options) {
  command->add_option(
      "--looks", options->looks,
      "ranges of the looks of the scene, comma-separated: brightness=A..B, warmth=A..B and "
      "turn=DEG..DEG of the light, hue=DEG..DEG and value=A..B of the objects' colors, table=A..B, "
      "tint=A..B and background=A..B (docs/generation.md)");
  Repeatable(command->add_option("--pattern", options->patterns,
                                 "pattern of the table: plain, stripes or checks; of a "
                                 "comma-separated list, each attempt draws one (default: that of "
                                 "the scene)"))
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>(scene_xml::kTablePatterns.begin(),
                                                     scene_xml::kTablePatterns.end())));
  CLI::Option* jitter = command->add_option(
      "--jitter", options->jitter,
      "ranges of the displacement of cameras, comma-separated: shift=UNITS..UNITS along and "
      "tilt=DEG..DEG about each axis, and view=A..B, a factor of the field of view");
  Repeatable(command->add_option("--jitter-camera", options->jittered_cameras,
                                 "displaced cameras, comma-separated (default: eye)"))
      ->delimiter(',')
      ->needs(jitter);
  command->add_option("--speed", options->speed,
                      "factor of the speed of the brain's motions, as A..B; for brains that read "
                      "`aux.variationSpeed`");
  Repeatable(command->add_option("--choices", options->choices,
                                 "choices of the brain among equally good ways that are drawn: "
                                 "order, grasp, path, comma-separated; for brains that read "
                                 "`aux.variationOrder`, …"))
      ->delimiter(',')
      ->check(CLI::IsMember({"order", "grasp", "path"}));
  command->add_option("--disturb", options->disturb,
                      "disturbances, comma-separated: fraction=F of the attempts in which a hand "
                      "displaces a loose object by distance=UNITS..UNITS (default: 0.2..0.5) after "
                      "seconds=S..S (default: 3..15)");
}

void AddChoices(const VariationOptions& options, experiment::VariationChoices* choices) {
  AddLooks(options, &choices->looks);
  if (!options.speed.empty()) choices->speed = ParseRange(options.speed, {0.01, 10}, "speed");
  const auto varies = [&](const char* what) {
    return std::ranges::find(options.choices, what) != options.choices.end();
  };
  choices->varies_order = varies("order");
  choices->varies_grasp = varies("grasp");
  choices->varies_path = varies("path");
  experiment::DisturbanceChoices& disturbance = choices->disturbance;
  Range fraction{disturbance.fraction, disturbance.fraction};
  ParseRanges(options.disturb, "disturb",
              {{"fraction", &fraction, {0, 1}},
               {"seconds", &disturbance.seconds, {0, 86400}},
               {"distance", &disturbance.distance, {0, 100}}});
  if (fraction.low != fraction.high) {
    throw std::invalid_argument("disturb: found a range of fractions, expected one number");
  }
  disturbance.fraction = fraction.low;
}

}  // namespace smile::app

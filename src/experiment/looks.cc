#include "experiment/looks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "experiment/internal_chain_objects.h"
#include "experiment/internal_draw.h"
#include "math/angles.h"
#include "math/color.h"
#include "scene/units.h"
#include "scene_xml/value_ranges.h"

namespace smile::experiment {
namespace {

using internal::Draw;

constexpr std::size_t kMaxLookBytes = 100;
constexpr double kMostLookDegrees = 360, kMostLookUnits = 1000;
/// Widths of stripes and squares of a table [units].
constexpr Range kPatternSpan{0.5, 2};
/// Brightness of every second one, as a fraction of that of the table.
constexpr Range kPatternValue{0.8, 0.95};

/// Hue in degrees, saturation and value from 0 to 1. Source: A. R. Smith, "Color gamut transform
/// pairs" (1978), the hexcone.
struct Hsv {
  double hue = 0, saturation = 0, value = 0;
};

Hsv HsvOf(const Color& color) {
  const double most = std::max({color.red, color.green, color.blue});
  const double range = most - std::min({color.red, color.green, color.blue});
  Hsv hsv{.saturation = most > 0 ? range / most : 0, .value = most};
  if (range == 0) return hsv;
  if (most == color.red) {
    hsv.hue = 60 * (color.green - color.blue) / range;
  } else if (most == color.green) {
    hsv.hue = 120 + 60 * (color.blue - color.red) / range;
  } else {
    hsv.hue = 240 + 60 * (color.red - color.green) / range;
  }
  return hsv;
}

Color ColorOf(const Hsv& hsv) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + (hsv.hue + 720) / 60, 6);
    return hsv.value * (1 - hsv.saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {.red = channel(5), .green = channel(3), .blue = channel(1)};
}

/// Returns a color as `#rrggbb`.
std::string HexOf(const Color& color) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const double channel : {color.red, color.green, color.blue}) {
    const auto byte = static_cast<unsigned>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
    text += {kDigits[byte / 16], kDigits[byte % 16]};
  }
  return text;
}

/// Calls a function for the color of each part, except lamps, of the objects that are not links of
/// chains: a chain has one color for all its links, in an element of its own.
template <class Scene>
void VisitColors(Scene* scene, const auto& visit) {
  const std::set<std::size_t> links = internal::ChainObjects(*scene);
  const auto visit_part = [&](const auto& self, auto& part) -> void {
    std::visit(
        [&](auto& shape) {
          using ShapeType = std::remove_cvref_t<decltype(shape)>;
          if constexpr (std::is_same_v<ShapeType, scene::Composite>) {
            for (auto& child : shape.parts) self(self, child);
          } else if constexpr (std::is_same_v<ShapeType, scene::CustomControl>) {
            for (auto& state : shape.states) {
              for (auto& child : state.parts) self(self, child);
            }
          } else if constexpr (!std::is_same_v<ShapeType, scene::IndicatorLights>) {
            visit(part.color);
          }
        },
        part.shape);
  };
  for (std::size_t i = 0; i < scene->objects.size(); ++i) {
    if (!links.contains(i)) visit_part(visit_part, scene->objects[i].whole);
  }
}

bool IsOnly(const Range& range, double value) { return range == Range{value, value}; }

std::string LightColor(double warmth) {
  if (warmth == 0) return "";
  return HexOf({.red = 1 + std::min(warmth, 0.0),
                .green = 1 - std::abs(warmth) / 2,
                .blue = 1 - std::max(warmth, 0.0)});
}

void DrawTable(const LookChoices& choices, std::uint64_t seed, Looks* looks) {
  const Hsv hsv{.hue = Draw({0, 360}, "table hue", seed),
                .saturation = Draw(choices.tint, "table tint", seed),
                .value = Draw(choices.table, "table", seed)};
  if (!IsOnly(choices.table, 1) || !IsOnly(choices.tint, 0)) looks->table = HexOf(ColorOf(hsv));
  if (choices.patterns == LookChoices().patterns) return;
  looks->pattern =
      choices.patterns[internal::DrawIndex(choices.patterns.size(), "table pattern", seed)];
  if (looks->pattern == "plain") return;
  Hsv second = hsv;
  second.value *= Draw(kPatternValue, "pattern value", seed);
  looks->pattern_color = HexOf(ColorOf(second));
  looks->pattern_span = Draw(kPatternSpan, "pattern span", seed);
}

/// Objects of one color keep one color: tasks may depend on it.
void DrawColors(const LookChoices& choices, const std::vector<std::string>& colors,
                std::uint64_t seed, Looks* looks) {
  if (IsOnly(choices.hue_deg, 0) && IsOnly(choices.value, 1)) return;
  for (const std::string& old : colors) {
    Hsv hsv = HsvOf(ParseColor(old).value());
    hsv.hue += Draw(choices.hue_deg, "hue of " + old, seed);
    hsv.value = std::min(1.0, hsv.value * Draw(choices.value, "value of " + old, seed));
    looks->colors[old] = HexOf(ColorOf(hsv));
  }
}

Vector3 DrawVector(const Range& range, const std::string& circumstance, std::uint64_t seed) {
  return {Draw(range, circumstance + " x", seed), Draw(range, circumstance + " y", seed),
          Draw(range, circumstance + " z", seed)};
}

Json VectorJson(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Vector3 VectorIn(const JsonNode& node, double most) {
  const std::vector<JsonNode> items = node.Items(3);
  return {items[0].Number(-most, most), items[1].Number(-most, most), items[2].Number(-most, most)};
}

Json ColorOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// Returns a color as in scene files; empty for null.
std::string ColorIn(const JsonNode& node) {
  if (node.IsNull()) return "";
  const std::string text = node.ShortString(kMaxLookBytes);
  if (!ParseColor(text)) node.Fail("is \"" + text + "\", expected a color");
  return text;
}

}  // namespace

std::vector<std::string> ColorsOf(const scene::SceneSpec& scene) {
  std::set<std::string> colors;
  VisitColors(&scene, [&](const Color& color) { colors.insert(ToString(color)); });
  return {colors.begin(), colors.end()};
}

Looks DrawLooks(const LookChoices& choices, const std::vector<std::string>& colors,
                std::uint64_t seed) {
  Looks looks{.brightness = Draw(choices.brightness, "brightness", seed),
              .turn_deg = Draw(choices.turn_deg, "light turn", seed),
              .light = LightColor(Draw(choices.warmth, "warmth", seed))};
  if (!IsOnly(choices.background, 0)) {
    const double gray = Draw(choices.background, "background", seed);
    looks.background = HexOf({gray, gray, gray});
  }
  DrawTable(choices, seed, &looks);
  DrawColors(choices, colors, seed, &looks);
  for (const std::string& camera : choices.cameras) {
    looks.cameras.push_back({.camera = camera,
                             .shift = DrawVector(choices.shift, "shift of " + camera, seed),
                             .tilt_deg = DrawVector(choices.tilt_deg, "tilt of " + camera, seed),
                             .view = Draw(choices.view, "view of " + camera, seed)});
  }
  return looks;
}

void Apply(const Looks& looks, scene::SceneSpec* scene) {
  scene->lighting.brightness *= looks.brightness;
  scene->lighting.turn += DegreesToRadians(looks.turn_deg);
  if (!looks.light.empty()) scene->lighting.color = ParseColor(looks.light).value();
  if (!looks.background.empty()) scene->lighting.background = ParseColor(looks.background);
  if (!looks.table.empty()) scene->table.color = ParseColor(looks.table).value();
  if (!looks.pattern.empty()) {
    const auto found = std::ranges::find(scene_xml::kTablePatterns, looks.pattern);
    scene->table.pattern =
        static_cast<scene::TablePattern>(found - scene_xml::kTablePatterns.begin());
    scene->table.pattern_span = scene::FromFileUnits(looks.pattern_span, scene->meters_per_unit);
    if (!looks.pattern_color.empty()) {
      scene->table.pattern_color = ParseColor(looks.pattern_color).value();
    }
  }
  VisitColors(scene, [&](Color& color) {
    const auto found = looks.colors.find(ToString(color));
    if (found != looks.colors.end()) color = ParseColor(found->second).value();
  });
  for (const Looks::Jitter& jitter : looks.cameras) {
    const Matrix3 R_CD = RotationFromFixedAxes(jitter.tilt_deg);
    std::erase_if(scene->camera_offsets,
                  [&](const scene::CameraOffset& old) { return old.camera == jitter.camera; });
    scene->camera_offsets.push_back(
        {.camera = jitter.camera,
         .X_CD = RigidTransform(R_CD, scene::FromFileUnits(jitter.shift, scene->meters_per_unit)),
         .view_angle_scale = jitter.view});
  }
}

Json ToJson(const LookChoices& choices) {
  Json json = Json::object();
  for (const auto& [name, range] : std::initializer_list<std::pair<const char*, const Range&>>{
           {"brightness", choices.brightness},
           {"warmth", choices.warmth},
           {"turn", choices.turn_deg},
           {"hue", choices.hue_deg},
           {"value", choices.value},
           {"table", choices.table},
           {"tint", choices.tint},
           {"background", choices.background},
           {"shift", choices.shift},
           {"tilt", choices.tilt_deg},
           {"view", choices.view}}) {
    json[name] = {range.low, range.high};
  }
  json["patterns"] = choices.patterns;
  json["cameras"] = choices.cameras;
  return json;
}

Json ToJson(const Looks& looks) {
  Json colors = Json::object(), cameras = Json::array();
  for (const auto& [old, color] : looks.colors) colors[old] = color;
  for (const Looks::Jitter& jitter : looks.cameras) {
    cameras.push_back({{"camera", jitter.camera},
                       {"shift", VectorJson(jitter.shift)},
                       {"tilt_deg", VectorJson(jitter.tilt_deg)},
                       {"view", jitter.view}});
  }
  return {{"brightness", looks.brightness},
          {"turn_deg", looks.turn_deg},
          {"light", ColorOrNull(looks.light)},
          {"background", ColorOrNull(looks.background)},
          {"table", ColorOrNull(looks.table)},
          {"pattern", ColorOrNull(looks.pattern)},
          {"pattern_color", ColorOrNull(looks.pattern_color)},
          {"pattern_span", looks.pattern_span},
          {"colors", colors},
          {"cameras", cameras}};
}

Looks LooksIn(const JsonNode& node) {
  Looks looks;
  looks.brightness = node.Member("brightness").Number(0, scene_xml::kBrightness.most);
  looks.turn_deg = node.Member("turn_deg").Number(-kMostLookDegrees, kMostLookDegrees);
  looks.light = ColorIn(node.Member("light"));
  looks.background = ColorIn(node.Member("background"));
  looks.table = ColorIn(node.Member("table"));
  if (const JsonNode pattern = node.Member("pattern"); !pattern.IsNull()) {
    looks.pattern = pattern.ShortString(kMaxLookBytes);
    if (std::ranges::find(scene_xml::kTablePatterns, looks.pattern) ==
        scene_xml::kTablePatterns.end()) {
      pattern.Fail("is \"" + looks.pattern + "\", expected plain, stripes or checks");
    }
  }
  looks.pattern_color = ColorIn(node.Member("pattern_color"));
  looks.pattern_span = node.Member("pattern_span").Number(0.001, kMostLookUnits);
  for (const auto& [old, color] : node.Member("colors").MembersUpTo(kMaxColors)) {
    looks.colors[old] = ColorIn(color);
  }
  for (const JsonNode& camera : node.Member("cameras").ItemsUpTo(scene::kMaxCameras)) {
    Looks::Jitter& jitter = looks.cameras.emplace_back();
    jitter.camera = camera.Member("camera").ShortString(kMaxLookBytes);
    jitter.shift = VectorIn(camera.Member("shift"), kMostLookUnits);
    jitter.tilt_deg = VectorIn(camera.Member("tilt_deg"), kMostLookDegrees);
    jitter.view =
        camera.Member("view").Number(scene_xml::kViewScale.least, scene_xml::kViewScale.most);
  }
  return looks;
}

}  // namespace smile::experiment

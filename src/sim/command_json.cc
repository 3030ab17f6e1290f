#include "sim/command_json.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/wording.h"
#include "demonstrator/demonstrator.h"
#include "motion/trajectory_shape.h"
#include "sim/internal_command_forms.h"

namespace smile::sim {
namespace {

[[noreturn]] void Expected(const std::string& key, const Json& found, const std::string& expected) {
  // A container may be deep and long: its kind says enough.
  std::string text = found.is_structured() && found.size() > 4 ? found.type_name() : ToText(found);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  throw std::invalid_argument("\"" + key + "\" is " + text + ", expected " + expected);
}

/// A number of a size that can mean something on a table.
bool IsNumber(const Json& json) {
  return json.is_number() && std::abs(json.get<double>()) <= kMaxNumber;
}

bool IsNumbers(const Json& json, std::size_t min_count, std::size_t max_count) {
  if (!json.is_array() || json.size() < min_count || json.size() > max_count) return false;
  for (const Json& number : json) {
    if (!IsNumber(number)) return false;
  }
  return true;
}

bool IsPoints(const Json& json) {
  return json.is_array() && json.size() <= kMaxMarkers &&
         std::ranges::all_of(json, [](const Json& point) { return IsNumbers(point, 3, 3); });
}

bool IsText(const Json& json, std::size_t max_length) {
  return json.is_string() && json.get_ref<const std::string&>().size() <= max_length;
}

bool IsProperties(const Json& json) {
  if (!json.is_array() || json.size() > demonstrator::kMaxProperties) return false;
  return std::ranges::all_of(
      json, [](const Json& name) { return IsText(name, demonstrator::kMaxPropertyLength); });
}

bool IsShare(const Json& json) {
  return IsNumber(json) && json.get<double>() >= kMinSpeed && json.get<double>() <= 1;
}

bool IsJointNames(const Json& json) {
  if (!json.is_array() || json.empty() || json.size() > kMaxJoints) return false;
  return std::ranges::all_of(json, [](const Json& name) { return IsText(name, kMaxText); });
}

/// The form of a point; how many numbers it takes is a matter of the whole.
bool IsTrajectoryPoint(const Json& json) {
  if (!json.is_object() || !json.contains("seconds") || !json.contains("positions")) return false;
  for (const auto& [key, value] : json.items()) {
    const bool is_right = key == "seconds" ? IsNumber(value)
                          : key == "positions" || key == "velocities"
                              ? IsNumbers(value, 1, kMaxJoints)
                              : false;
    if (!is_right) return false;
  }
  return true;
}

void CheckTrajectoryPoints(const Json& json) {
  if (!json.is_array() || json.empty() || json.size() > motion::kMaxTrajectoryPoints) {
    Expected("points", json, "1 to 10000 points");
  }
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (IsTrajectoryPoint(json[i])) continue;
    Expected("points[" + std::to_string(i) + "]", json[i],
             R"(a point like {"seconds": 0, "positions": [0], "velocities": [0]})");
  }
}

void CheckField(const Field& field, const Json& value) {
  const std::string key = field.name;
  switch (field.kind) {
    case Kind::kHand:
      if (!value.is_string() || !demonstrator::ParseHandName(value.get<std::string>())) {
        Expected(key, value, "left, right, both or any");
      }
      return;
    case Kind::kText:
      if (!IsText(value, kMaxText)) Expected(key, value, "a text of at most 256 letters");
      return;
    case Kind::kPoint:
    case Kind::kAngles:
      if (!IsNumbers(value, 3, 3)) Expected(key, value, "three numbers [x, y, z] of at most 1e6");
      return;
    case Kind::kPoints:
      if (!IsPoints(value)) {
        Expected(key, value, "at most 500 points [x, y, z] of numbers of at most 1e6");
      }
      return;
    case Kind::kDirection:
      if (!IsNumbers(value, 3, 3) || value == Json{0, 0, 0}) {
        Expected(key, value, "three numbers [x, y, z] of at most 1e6, not all 0");
      }
      return;
    case Kind::kSpeed:
      if (!IsNumber(value) || !(value.get<double>() >= kMinSpeed)) {
        Expected(key, value, "a number above 0, from 1e-6 to 1e6");
      }
      return;
    case Kind::kJoints:
      if (!IsNumbers(value, 1, kMaxJoints)) Expected(key, value, "one number per joint of the arm");
      return;
    case Kind::kGrippers:
      if (!IsNumbers(value, 2, 2)) Expected(key, value, "two numbers [left, right]");
      return;
    case Kind::kNumber:
      if (!IsNumber(value)) Expected(key, value, "a number of at most 1e6");
      return;
    case Kind::kFlag:
      if (!value.is_boolean()) Expected(key, value, "true or false");
      return;
    case Kind::kMood:
      if (!value.is_string() || !robot::ParseMood(value.get_ref<const std::string&>())) {
        Expected(key, value, OneOf(robot::kMoodNames));
      }
      return;
    case Kind::kProperties:
      if (!IsProperties(value)) {
        Expected(key, value, "at most 32 names of properties of at most 256 letters");
      }
      return;
    case Kind::kArm:
      if (std::ranges::none_of(kArmNames, [&](const char* name) { return value == name; })) {
        Expected(key, value, "left, right or both");
      }
      return;
    case Kind::kShare:
      if (!IsShare(value)) Expected(key, value, "a number above 0, at most 1");
      return;
    case Kind::kJointNames:
      if (!IsJointNames(value)) Expected(key, value, "1 to 64 names of joints");
      return;
    case Kind::kTrajectoryPoints:
      CheckTrajectoryPoints(value);
      return;
  }
}

std::string FormNames() {
  std::string names;
  for (const Form& form : Forms()) names += (names.empty() ? "" : ", ") + std::string(form.name);
  return names;
}

const Form& FormOf(const Json& json) {
  if (!json.is_object()) {
    throw std::invalid_argument("found " + std::string(json.type_name()) +
                                ", expected an object like {\"hand\": \"left\", \"do\": …}");
  }
  if (!json.contains("do")) {
    throw std::invalid_argument("\"do\" is missing, expected one of " + FormNames());
  }
  for (const Form& form : Forms()) {
    if (json.at("do") == form.name) return form;
  }
  Expected("do", json.at("do"), "one of " + FormNames());
}

}  // namespace

Json ParseLineJson(std::string_view line) {
  if (line.size() > kMaxLineBytes) throw std::invalid_argument("this line is longer than 32 MiB");
  return ParseJson(line, kMaxLineKeys);
}

Command ParseCommand(const Json& json, double meters_per_unit) {
  const Form& form = FormOf(json);
  for (const Field& field : form.fields) {
    if (json.contains(field.name)) {
      CheckField(field, json.at(field.name));
    } else if (field.is_required) {
      throw std::invalid_argument("\"" + std::string(form.name) + "\" lacks \"" + field.name +
                                  "\": " + field.meaning);
    }
  }
  for (const auto& [key, value] : json.items()) {
    bool is_known = key == "do" || key == "tick";
    for (const Field& field : form.fields) is_known = is_known || key == field.name;
    if (!is_known) {
      throw std::invalid_argument("\"" + std::string(form.name) + "\" has an unknown key \"" + key +
                                  "\"");
    }
  }
  return form.build(json, meters_per_unit);
}

std::optional<std::uint64_t> ParseTick(const Json& json) {
  if (!json.is_object() || !json.contains("tick")) return std::nullopt;
  const Json& tick = json.at("tick");
  if (!tick.is_number_unsigned()) Expected("tick", tick, "a whole number from 0");
  return tick.get<std::uint64_t>();
}

}  // namespace smile::sim

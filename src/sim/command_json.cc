#include "sim/command_json.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/wording.h"
#include "demonstrator/demonstrator.h"
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

bool IsText(const Json& json, std::size_t max_length) {
  return json.is_string() && json.get_ref<const std::string&>().size() <= max_length;
}

bool IsProperties(const Json& json) {
  if (!json.is_array() || json.size() > demonstrator::kMaxProperties) return false;
  return std::ranges::all_of(
      json, [](const Json& name) { return IsText(name, demonstrator::kMaxPropertyLength); });
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

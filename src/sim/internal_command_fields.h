#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/json.h"
#include "sim/command.h"
#include "sim/internal_value_kinds.h"
#include "sim/internal_written_values.h"

// Functions that follow from the fields a command lists.

namespace smile::sim {

/// Calls `visit` with a type_identity of each kind of command, in the order of Command, until it
/// returns true.
/// @returns true if it did.
bool AnyKindOfCommand(auto&& visit) {
  return [&]<class... What>(std::type_identity<std::variant<What...>>) {
    return (visit(std::type_identity<What>()) || ...);
  }(std::type_identity<Command>());
}

template <class What>
const std::vector<CommandField>& FieldsOf() {
  static const std::vector<CommandField> kFields = [] {
    std::vector<CommandField> fields;
    const What what{};
    What::VisitFields(what, [&](const auto&, const CommandField& one) { fields.push_back(one); });
    return fields;
  }();
  return kFields;
}

/// Returns the meaning of a value, with its unit.
std::string MeaningOf(const CommandField& field);

/// Checks for unknown keys.
/// @throws std::invalid_argument if a key is not one of the fields.
void RefuseUnknownKeys(const char* name, const std::vector<CommandField>& fields, const Json& json);

/// Reads a command from its written form.
/// @throws std::invalid_argument with what was found and expected.
template <class What>
What ReadFields(const Json& json, double meters_per_unit) {
  What what;
  What::VisitFields(what, [&](auto& value, const CommandField& field) {
    const auto found = json.find(field.name);
    if (found != json.end()) {
      CheckValue(field, *found);
      Read(*found, WrittenUnit(field, meters_per_unit), &value);
    } else if (field.presence == Presence::kRequired) {
      throw std::invalid_argument("\"" + std::string(What::kName.name) + "\" lacks \"" +
                                  field.name + "\": " + MeaningOf(field));
    }
  });
  RefuseUnknownKeys(What::kName.name, FieldsOf<What>(), json);
  return what;
}

/// Returns true for a value that need not be written if it is optional.
inline bool IsOmissible(const std::string& text) { return text.empty(); }
inline bool IsOmissible(bool flag) { return !flag; }
template <class T>
bool IsOmissible(const std::optional<T>& value) {
  return !value.has_value();
}
inline bool IsOmissible(const ByArm<double>& values) { return values.empty(); }
template <class Values>
bool IsOmissible(const OneArm<Values>& arm) {
  return !arm.values->contains(arm.name);
}
template <class Values>
bool IsOmissible(const OtherArms<Values>& others) {
  return std::ranges::all_of(
      *others.values, [](const auto& arm) { return arm.first == "left" || arm.first == "right"; });
}
bool IsOmissible(const auto&) { return false; }

template <class What>
Json WriteFields(const What& what, double meters_per_unit) {
  Json json = Json::object();
  if constexpr (requires { what.hand; }) json[kHandField.name] = "";  // before what it does
  json["do"] = What::kName.name;
  What::VisitFields(what, [&](const auto& value, const CommandField& field) {
    if (field.presence == Presence::kOptional && IsOmissible(value)) return;
    json[field.name] = Written(value, WrittenUnit(field, meters_per_unit));
  });
  return json;
}

}  // namespace smile::sim

#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "base/json.h"
#include "scene/units.h"
#include "scene_xml/scene_writer.h"
#include "sim/command.h"
#include "sim/internal_value_kinds.h"

// Values of commands in JSON: writing, reading after a check, and rounding to values that can be
// written. Lengths are in the scene's unit there.

namespace smile::sim {

/// Unit of the numbers of a field in a scene.
struct WrittenUnit {
  double meters_per_unit;
  bool is_length;  ///< false: numbers are written unchanged

  WrittenUnit(const CommandField& field, double meters)
      : meters_per_unit(meters),
        is_length(field.unit == ValueUnit::kUnits || field.unit == ValueUnit::kUnitsPerSecond) {}

  /// @tparam T  double or Vector3.
  template <class T>
  T Write(const T& value) const {
    return is_length ? scene::ToFileUnits(value, meters_per_unit) : value;
  }
  template <class T>
  T Read(const T& value) const {
    return is_length ? scene::FromFileUnits(value, meters_per_unit) : value;
  }
};

inline Json Written(const Vector3& p, const WrittenUnit& unit) {
  const Vector3 in_file = unit.Write(p);
  return {in_file.x(), in_file.y(), in_file.z()};
}
inline Json Written(double number, const WrittenUnit& unit) { return unit.Write(number); }
inline Json Written(bool flag, const WrittenUnit&) { return flag; }
inline Json Written(std::uint64_t number, const WrittenUnit&) { return number; }
inline Json Written(const std::string& text, const WrittenUnit&) { return text; }
inline Json Written(HandName hand, const WrittenUnit&) { return ToString(hand); }
inline Json Written(robot::FaceExpression face_expression, const WrittenUnit&) {
  return ToString(face_expression);
}
/// Without the scene's name, which a text does not contain.
inline Json Written(const std::shared_ptr<const scene::SceneSpec>& scene, const WrittenUnit&) {
  return scene_xml::WriteScene(*scene);
}
inline Json Written(const motion::TrajectoryPoint& point, const WrittenUnit&) {
  return {
      {"seconds", point.seconds}, {"positions", point.positions}, {"velocities", point.velocities}};
}
template <class T>
Json Written(const std::optional<T>& value, const WrittenUnit& unit) {
  return value ? Written(*value, unit) : Json();
}
/// @tparam List  a vector or an array.
template <class List, class = typename List::const_iterator>
Json Written(const List& values, const WrittenUnit& unit) {
  Json written = Json::array();
  for (const auto& value : values) written.push_back(Written(value, unit));
  return written;
}
/// A pair is written as a list, which is what earlier versions read.
inline Json Written(const ByArm<double>& values, const WrittenUnit& unit) {
  if (IsPair(values)) return {unit.Write(values.at("left")), unit.Write(values.at("right"))};
  Json written = Json::object();
  for (const auto& [name, value] : values) written[name] = unit.Write(value);
  return written;
}
template <class Values>
Json Written(const OneArm<Values>& arm, const WrittenUnit& unit) {
  return Written(arm.values->at(arm.name), unit);
}
template <class Values>
Json Written(const OtherArms<Values>& others, const WrittenUnit& unit) {
  Json written = Json::object();
  for (const auto& [name, value] : *others.values) {
    if (name != "left" && name != "right") written[name] = Written(value, unit);
  }
  return written;
}

inline void Read(const Json& json, const WrittenUnit& unit, Vector3* p) {
  *p = unit.Read(Vector3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>()));
}
inline void Read(const Json& json, const WrittenUnit& unit, double* number) {
  *number = unit.Read(json.get<double>());
}
inline void Read(const Json& json, const WrittenUnit&, bool* flag) { *flag = json.get<bool>(); }
inline void Read(const Json& json, const WrittenUnit&, std::uint64_t* number) {
  *number = json.get<std::uint64_t>();
}
inline void Read(const Json& json, const WrittenUnit&, std::string* text) {
  *text = json.get<std::string>();
}
inline void Read(const Json& json, const WrittenUnit&, HandName* hand) {
  *hand = *demonstrator::ParseHandName(json.get<std::string>());
}
inline void Read(const Json& json, const WrittenUnit&, robot::FaceExpression* face_expression) {
  *face_expression = *robot::ParseFaceExpression(json.get<std::string>());
}
/// Parses a scene.
/// @throws std::invalid_argument if the text is not a scene.
void Read(const Json& json, const WrittenUnit&, std::shared_ptr<const scene::SceneSpec>* scene);
inline void Read(const Json& json, const WrittenUnit&, motion::TrajectoryPoint* point) {
  *point = {.seconds = json.at("seconds").get<double>(),
            .positions = json.at("positions"),
            .velocities = json.value("velocities", std::vector<double>())};
}
template <class T>
void Read(const Json& json, const WrittenUnit& unit, std::optional<T>* value) {
  Read(json, unit, &value->emplace());
}
template <class T>
void Read(const Json& json, const WrittenUnit& unit, std::vector<T>* values) {
  for (const Json& value : json) Read(value, unit, &values->emplace_back());
}
inline void Read(const Json& json, const WrittenUnit& unit, ByArm<double>* values) {
  if (json.is_array()) {
    Read(json[0], unit, &(*values)["left"]);
    Read(json[1], unit, &(*values)["right"]);
    return;
  }
  for (const auto& [name, value] : json.items()) Read(value, unit, &(*values)[name]);
}
template <class Values>
void Read(const Json& json, const WrittenUnit& unit, OneArm<Values>* arm) {
  Read(json, unit, &(*arm->values)[arm->name]);
}
/// @throws std::invalid_argument if an arm already has values.
template <class Values>
void Read(const Json& json, const WrittenUnit& unit, OtherArms<Values>* others) {
  for (const auto& [name, value] : json.items()) {
    if (others->values->contains(name)) {
      throw std::invalid_argument("\"arms\" repeats \"" + name + "\", expected each arm once");
    }
    Read(value, unit, &(*others->values)[name]);
  }
}

/// Rounds to the nearest value that is unchanged by writing and reading.
template <class T>
void RoundToFileGrid(double meters_per_unit, T* value) {
  if constexpr (std::is_same_v<T, ByArm<double>>) {
    for (auto& [name, number] : *value) RoundToFileGrid(meters_per_unit, &number);
  } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vector3>) {
    *value = scene::OnFileGrid(*value, meters_per_unit);
  } else if constexpr (requires { value->has_value(); }) {
    if (*value) RoundToFileGrid(meters_per_unit, &**value);
  } else if constexpr (requires { value->begin(); } && !std::is_same_v<T, std::string>) {
    for (auto& one : *value) RoundToFileGrid(meters_per_unit, &one);
  }
}

}  // namespace smile::sim

#include "sim/command_json.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/diagnostic.h"
#include "motion/trajectory_shape.h"
#include "sim/internal_command_fields.h"
#include "sim/spawning.h"

namespace smile::sim {
namespace {

/// Returns the names of all kinds, for messages.
std::string NamesOfCommands() {
  std::string names;
  AnyKindOfCommand([&]<class What>(std::type_identity<What>) {
    names += (names.empty() ? "" : ", ") + std::string(What::kName.name);
    return false;
  });
  return names;
}

/// Completes and checks a command after its fields are read.
void Complete(auto*) {}
/// Velocities are given for all points or for none; without them they are computed from the
/// positions.
void Complete(FollowTrajectory* follow) {
  motion::JointTrajectory* trajectory = &follow->trajectory;
  // One point with velocities is enough: CheckShape() then requires them of all.
  const bool has_velocities = std::ranges::any_of(
      trajectory->points, [](const auto& point) { return !point.velocities.empty(); });
  motion::CheckShape(*trajectory, has_velocities);
  if (!has_velocities) motion::SetVelocitiesFromPositions(trajectory);
  motion::CheckShape(*trajectory);
}

}  // namespace

void Read(const Json& json, const WrittenUnit&, std::shared_ptr<const scene::SceneSpec>* scene) {
  scene_xml::SceneReading reading = ReadCommandScene(json.get<std::string>(), "scene");
  if (!reading.scene) {
    throw std::invalid_argument("\"xml\" is not a scene: " + ToString(reading.diagnostics.front()));
  }
  *scene = std::make_shared<const scene::SceneSpec>(*std::move(reading.scene));
}

std::string MeaningOf(const CommandField& field) {
  // In the order of the enumeration of units.
  constexpr std::array kUnits = {"", " [units]", " [units/s]", " [degrees]", " [rad]", " [rad/s]"};
  return std::string(field.meaning) + kUnits[static_cast<std::size_t>(field.unit)];
}

void RefuseUnknownKeys(const char* name, const std::vector<CommandField>& fields,
                       const Json& json) {
  for (const auto& item : json.items()) {
    const std::string& key = item.key();
    // These belong to the line, not to the command.
    if (key == "do" || key == "tick") continue;
    if (std::ranges::any_of(fields, [&](const auto& field) { return key == field.name; })) continue;
    throw std::invalid_argument("\"" + std::string(name) + "\" has an unknown key \"" + key + "\"");
  }
}

Json ParseLineJson(std::string_view line) {
  if (line.size() > kMaxLineBytes) throw std::invalid_argument("this line is longer than 32 MiB");
  return ParseJson(line, kMaxLineKeys);
}

Command ParseCommand(const Json& json, double meters_per_unit) {
  if (!json.is_object()) {
    throw std::invalid_argument("found " + std::string(json.type_name()) +
                                ", expected an object like {\"hand\": \"left\", \"do\": …}");
  }
  const auto name = json.find("do");
  if (name == json.end()) {
    throw std::invalid_argument("\"do\" is missing, expected one of " + NamesOfCommands());
  }
  // Tries each kind of the variant at compile time and stops at the one with this name.
  Command command;
  const bool is_known = AnyKindOfCommand([&]<class What>(std::type_identity<What>) {
    if (*name != What::kName.name) return false;
    What what = ReadFields<What>(json, meters_per_unit);
    Complete(&what);
    command = std::move(what);
    return true;
  });
  if (!is_known) ThrowExpected("do", *name, "one of " + NamesOfCommands());
  return command;
}

Json ToJson(const Command& command, double meters_per_unit) {
  return std::visit([&](const auto& what) { return WriteFields(what, meters_per_unit); }, command);
}

Command OnFileGrid(Command command, double meters_per_unit) {
  // Lengths are written in units; converting to units and back can change the last bit.
  const auto round = [&](auto& value, const CommandField& field) {
    // Other numbers are written as they are, so they already read back to the same bits.
    if (WrittenUnit(field, meters_per_unit).is_length) RoundToFileGrid(meters_per_unit, &value);
  };
  std::visit([&]<class What>(What& what) { What::VisitFields(what, round); }, command);
  return command;
}

std::optional<std::uint64_t> ParseTick(const Json& json) {
  if (!json.is_object() || !json.contains("tick")) return std::nullopt;
  const Json& tick = json.at("tick");
  if (!tick.is_number_unsigned()) ThrowExpected("tick", tick, "a whole number from 0");
  return tick.get<std::uint64_t>();
}

}  // namespace smile::sim

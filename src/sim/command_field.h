#pragma once

#include <cstddef>
#include <cstdint>

namespace smile::sim {

/// Upper bound of names [bytes].
inline constexpr std::size_t kMaxText = 256;
/// Upper bound of the objects that a command names.
inline constexpr std::size_t kMaxNamedObjects = 1000;
/// Upper bound of a scene in a command [bytes].
inline constexpr std::size_t kMaxSceneText = std::size_t{1} << 20;
/// Greatest integer that JSON implementations represent exactly.
inline constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53;
/// Upper bound of lengths, angles and speeds, and lower bound of speed limits [units, degrees, rad,
/// per s].
inline constexpr double kMaxNumber = 1e6, kMinSpeed = 1e-6;

/// Kind of a value, which determines the allowed values; see internal_value_kinds.cc.
enum class ValueKind {
  kHand,
  kText,
  kPoint,  ///< three numbers
  kPoints,
  kDirection,  ///< three numbers, not all 0
  kSpeed,      ///< a number above 0
  kJoints,
  kArms,      ///< numbers of joints, by the name of the arm
  kGrippers,  ///< two numbers, or numbers by the name of the arm
  kNumber,
  kFlag,
  kFaceExpression,
  kProperties,
  kObjects,
  kArm,
  kShare,
  kJointNames,
  kTrajectoryPoints,
  kSceneText,
  kSeed
};

/// Unit of the numbers in the written form. Lengths are in scene units there, in meters in a
/// command.
enum class ValueUnit { kNone, kUnits, kUnitsPerSecond, kDegrees, kRadians, kRadiansPerSecond };

/// Rules for leaving out a field.
enum class Presence {
  kRequired,
  kOptional,   ///< left out if it has no meaning: no value, an empty text, false
  kDefaulted,  ///< may be left out, then has a default; always written
};

/// One field of a command's written form, for programs and documentation.
struct CommandField {
  const char* name;
  ValueKind kind;
  const char* meaning;
  ValueUnit unit = ValueUnit::kNone;
  Presence presence = Presence::kRequired;
};

/// Name of a kind of command, the value of `do`, and its meaning.
struct CommandName {
  const char* name;
  const char* meaning;
};

}  // namespace smile::sim

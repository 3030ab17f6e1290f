#pragma once

#include <cstddef>
#include <cstdint>

namespace smile::sim {

/// Longer names and arrays than these are nobody's.
inline constexpr std::size_t kMaxText = 256;
inline constexpr std::size_t kMaxJoints = 64;
/// Of a scene in a command [bytes].
inline constexpr std::size_t kMaxSceneText = std::size_t{1} << 20;
/// JSON of any language keeps whole numbers up to here.
inline constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53;
/// No length, angle or speed is larger, and no speed limit smaller [units, degrees, rad, per s].
inline constexpr double kMaxNumber = 1e6, kMinSpeed = 1e-6;

/// What a value of a command is, and with that what is allowed; see internal_value_kinds.cc.
enum class ValueKind {
  kHand,
  kText,
  kPoint,  ///< three numbers
  kPoints,
  kDirection,  ///< three numbers, not all 0
  kSpeed,      ///< a number above 0
  kJoints,
  kGrippers,
  kNumber,
  kFlag,
  kFaceExpression,
  kProperties,
  kArm,
  kShare,
  kJointNames,
  kTrajectoryPoints,
  kSceneText,
  kSeed
};

/// In what its numbers are written. Those in units are meters in a command.
enum class ValueUnit { kNone, kUnits, kUnitsPerSecond, kDegrees, kRadians, kRadiansPerSecond };

enum class Presence {
  kRequired,
  kOptional,   ///< left out where it says nothing: no value, an empty text, false
  kDefaulted,  ///< may be left out, and has a value then; is always written
};

/// One field of a command's written form: all that is said of it, to programs and to people.
struct CommandField {
  const char* name;
  ValueKind kind;
  const char* meaning;
  ValueUnit unit = ValueUnit::kNone;
  Presence presence = Presence::kRequired;
};

/// What a kind of command is called, as the value of `do`, and what it does.
struct CommandName {
  const char* name;
  const char* meaning;
};

}  // namespace smile::sim

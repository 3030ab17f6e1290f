#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "base/json.h"
#include "sim/command.h"

namespace smile::sim {

/// Longer names and arrays than these are nobody's.
inline constexpr std::size_t kMaxText = 256;
inline constexpr std::size_t kMaxJoints = 64;
/// What `arm` of a gripper may be.
inline constexpr std::array<const char*, 3> kArmNames{"left", "right", "both"};
/// No length, angle or speed is larger, and no speed limit smaller [units, degrees, rad, per s].
inline constexpr double kMaxNumber = 1e6, kMinSpeed = 1e-6;

/// What a value of a command is, and with that what is allowed.
enum class Kind {
  kHand,
  kText,
  kPoint,
  kPoints,
  kAngles,
  kDirection,
  kSpeed,
  kJoints,
  kGrippers,
  kNumber,
  kFlag,
  kMood,
  kProperties,
  kArm,
  kShare,
  kJointNames,
  kTrajectoryPoints
};

/// One value of a command.
struct Field {
  const char* name;
  Kind kind;
  bool is_required;
  const char* meaning;
};

/// One kind of command: what it is called, what it takes, and how it is made of its checked values
/// (the second argument is metres per unit). The reader and the schema both follow this.
struct Form {
  const char* name;
  const char* meaning;
  std::vector<Field> fields;
  std::function<Command(const Json&, double)> build;
};

/// In the order in which they are listed.
const std::vector<Form>& Forms();

}  // namespace smile::sim

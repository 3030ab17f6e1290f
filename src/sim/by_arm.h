#pragma once

#include <map>
#include <string>

namespace smile::sim {

/// Values for some arms of the robot, by the name of the arm.
///
/// For a robot without an arm of that name, `left` is the first arm and `right` the second one.
template <class T>
using ByArm = std::map<std::string, T, std::less<>>;

/// Returns true if there is a value for `left`, one for `right`, and no other.
template <class T>
bool IsPair(const ByArm<T>& values) {
  return values.size() == 2 && values.contains("left") && values.contains("right");
}

/// The value of one arm, which the written form has in a field of its own.
/// @tparam Values  a ByArm, perhaps const.
template <class Values>
struct OneArm {
  Values* values;
  const char* name;
};

/// The values of all arms except `left` and `right`.
template <class Values>
struct OtherArms {
  Values* values;
};

}  // namespace smile::sim

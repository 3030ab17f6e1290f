#include "brain/brain_values.h"

#include <algorithm>

namespace smile::brain {

bool IsClassic(std::span<const ArmDescription> arms) {
  return arms.size() == kLimbCount && std::ranges::all_of(arms, [](const ArmDescription& arm) {
           return arm.num_joints() == kJointCount;
         });
}

std::string ToString(const BrainError& error) {
  // The form `file:line: message` is that of compilers; editors and terminals make it a link.
  std::string place = error.file;
  if (!place.empty() && error.line > 0) place += ":" + std::to_string(error.line);
  return place.empty() ? error.message : place + ": " + error.message;
}

}  // namespace smile::brain

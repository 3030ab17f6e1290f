#include "robot/face_expression.h"

#include <algorithm>
#include <cstddef>

namespace smile::robot {

std::string_view ToString(FaceExpression expression) {
  return kFaceExpressionNames[static_cast<std::size_t>(expression)];
}

std::optional<FaceExpression> ParseFaceExpression(std::string_view name) {
  // Names and values are two lists in the same order.
  const auto found = std::find(kFaceExpressionNames.begin(), kFaceExpressionNames.end(), name);
  if (found == kFaceExpressionNames.end()) return std::nullopt;
  return kFaceExpressions[static_cast<std::size_t>(found - kFaceExpressionNames.begin())];
}

}  // namespace smile::robot

#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace smile::robot {

/// Expression of a robot's face; not visible on a robot without a face.
enum class FaceExpression { kIdle, kWatching, kWorking, kPuzzled, kDone };

inline constexpr std::array kFaceExpressions = {FaceExpression::kIdle, FaceExpression::kWatching,
                                                FaceExpression::kWorking, FaceExpression::kPuzzled,
                                                FaceExpression::kDone};
/// Names in the order of kFaceExpressions.
inline constexpr std::array<std::string_view, 5> kFaceExpressionNames = {
    "idle", "watching", "working", "puzzled", "done"};

std::string_view ToString(FaceExpression expression);
/// Returns the expression of a name, or nullopt if it is not one of kFaceExpressionNames.
[[nodiscard]] std::optional<FaceExpression> ParseFaceExpression(std::string_view name);

}  // namespace smile::robot

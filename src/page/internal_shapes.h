#pragma once

#include <string>
#include <vector>

#include "base/json_shape.h"

// Shapes of messages and requests.

namespace smile::page {

inline constexpr bool kOptional = false;

JsonShape NumberShape();
JsonShape TextShape();
JsonShape FlagShape();
JsonShape TextsShape();
/// Shape of a message of the program: text as it is, or an id in `program` of texts/ with
/// arguments.
JsonShape MessageShape();
JsonShape NumbersShape();
JsonShape ObjectShape(std::vector<JsonMember> members);
/// Returns the member `t` of a message.
JsonMember KindMember(const char* name);

// Named types.

JsonShape HandNameShape();
JsonShape FaceExpressionShape();
JsonShape SnapNameShape();
JsonShape PointShape();
JsonShape PoseShape();
JsonShape VisualShape();
JsonShape SceneObjectShape();
JsonShape RobotDescriptionShape();
JsonShape HandShape();
JsonShape ToolUseShape();
JsonShape ActionSummaryShape();
JsonShape SegmentShape();
JsonShape ConflictShape();
JsonShape TimelineShape();
/// Shape of true, or of the reason why not.
JsonShape AllowedShape();
JsonShape DiagnosticShape();
JsonShape ConsoleLineShape();
JsonShape LibraryEntryShape();
JsonShape ShareLinkShape();

}  // namespace smile::page

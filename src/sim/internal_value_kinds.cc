#include "sim/internal_value_kinds.h"

#include <map>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/wording.h"
#include "demonstrator/demonstrator.h"
#include "motion/trajectory_shape.h"
#include "robot/face_expression.h"
#include "robot/robot_model.h"
#include "sim/command.h"

// Kinds of values of command fields. Each has a shape that programs check and a phrase that people
// read; they are next to each other here, so that they do not drift apart.

namespace smile::sim {
namespace {

/// Allowed values, for programs and for people.
struct Allowed {
  JsonShape shape;
  std::string words;
};

JsonShape AnyNumber() { return JsonShape::Number(-kMaxNumber, kMaxNumber); }

/// Returns the form of a point, with its allowed times.
JsonShape TrajectoryPointShape(const JsonShape& seconds) {
  const JsonShape numbers = JsonShape::List(AnyNumber(), 1, motion::kMaxTrajectoryJoints);
  return JsonShape::Object({{"seconds", seconds},
                            {"positions", numbers},
                            {"velocities", numbers, /*is_required=*/false}});
}

/// Allows one of these words.
Allowed WordOf(std::span<const std::string_view> words) {
  return {JsonShape::Word({words.begin(), words.end()}), OneOf(words)};
}

Allowed HandsAllowed() {
  std::vector<std::string_view> names;
  for (const HandName hand : demonstrator::kHandNames) names.push_back(ToString(hand));
  return WordOf(names);
}

/// Returns the table of all kinds: their form for programs, and the same in words.
std::map<ValueKind, Allowed> MakeKinds() {
  using enum ValueKind;
  const JsonShape text = JsonShape::Text(kMaxText);
  const JsonShape point = JsonShape::List(AnyNumber(), 3, 3);
  const std::string point_words = "three numbers [x, y, z] of at most 1e6";
  const JsonShape joints = JsonShape::List(AnyNumber(), 1, motion::kMaxTrajectoryJoints);
  return {
      {kHand, HandsAllowed()},
      {kText, {text, "a string of at most 256 characters"}},
      {kPoint, {point, point_words}},
      {kPoints,
       {JsonShape::List(point, 0, kMaxMarkers),
        "at most 500 points [x, y, z] of numbers of at most 1e6"}},
      // The shape cannot express the exception; CheckValue() checks it.
      {kDirection, {point, point_words + ", not all 0"}},
      {kSpeed, {JsonShape::Number(kMinSpeed, kMaxNumber), "a number above 0, from 1e-6 to 1e6"}},
      {kJoints, {joints, "one number per joint of the arm"}},
      {kArms,
       {JsonShape::Map(joints, robot::kMaxArms, robot::kMaxArmName),
        "at most 16 arms like {\"arm\": [0.1, 0]}, one number per joint"}},
      {kGrippers,
       {JsonShape::List(AnyNumber(), 2, 2)
            .Or(JsonShape::Map(AnyNumber(), robot::kMaxArms, robot::kMaxArmName)),
        "two numbers [left, right], or at most 16 numbers like {\"arm\": 0.1}"}},
      {kNumber, {AnyNumber(), "a number of at most 1e6"}},
      {kFlag, {JsonShape::Flag(), "true or false"}},
      {kFaceExpression, WordOf(robot::kFaceExpressionNames)},
      {kProperties,
       {JsonShape::List(JsonShape::Text(demonstrator::kMaxPropertyLength), 0,
                        demonstrator::kMaxProperties),
        "at most 32 names of properties of at most 256 characters"}},
      {kObjects, {JsonShape::List(text, 1, kMaxNamedObjects), "1 to 1000 ids of objects"}},
      {kArm, {JsonShape::Text(robot::kMaxArmName), "the name of an arm, both or all"}},
      {kShare, {JsonShape::Number(kMinSpeed, 1), "a number above 0, at most 1"}},
      {kJointNames,
       {JsonShape::List(text, 1, motion::kMaxTrajectoryJoints), "1 to 64 names of joints"}},
      {kTrajectoryPoints,
       {JsonShape::List(TrajectoryPointShape(JsonShape::Number(0, motion::kMaxTrajectorySeconds)),
                        1, motion::kMaxTrajectoryPoints),
        "1 to 10000 points"}},
      {kSceneText, {JsonShape::Text(kMaxSceneText), "a string of at most 1048576 characters"}},
      {kSeed, {JsonShape::Whole(0, kMaxSeed), "a whole number from 0 to 2^53"}},
  };
}

const Allowed& AllowedOf(ValueKind kind) {
  static const std::map<ValueKind, Allowed> kKinds = MakeKinds();
  return kKinds.at(kind);
}

/// Checks the form of each point. The number of values and the order of times concern the whole
/// trajectory: motion::CheckShape() reports those.
void CheckTrajectoryPoints(const CommandField& field, const Json& points) {
  // Points are checked one by one, since the shape of the list would only say that the list is
  // wrong, and with any time, since a time out of range has a better message elsewhere.
  static const JsonShape kPointShape = TrajectoryPointShape(AnyNumber());
  if (!points.is_array() || points.empty() || points.size() > motion::kMaxTrajectoryPoints) {
    ThrowExpected(field.name, points, WordsOf(field.kind));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kPointShape.Fits(points[i])) continue;
    ThrowExpected(field.name + ("[" + std::to_string(i) + "]"), points[i],
                  R"(a point like {"seconds": 0, "positions": [0], "velocities": [0]})");
  }
}

}  // namespace

const JsonShape& ShapeOf(ValueKind kind) { return AllowedOf(kind).shape; }

std::string WordsOf(ValueKind kind) { return AllowedOf(kind).words; }

void CheckValue(const CommandField& field, const Json& value) {
  if (field.kind == ValueKind::kTrajectoryPoints) return CheckTrajectoryPoints(field, value);
  const bool is_nowhere = field.kind == ValueKind::kDirection && value == Json{0, 0, 0};
  if (is_nowhere || !ShapeOf(field.kind).Fits(value)) {
    ThrowExpected(field.name, value, WordsOf(field.kind));
  }
}

void ThrowExpected(const std::string& key, const Json& found, const std::string& expected) {
  // A container may be deep and long: name only its type.
  std::string text = found.is_structured() && found.size() > 4 ? found.type_name() : ToText(found);
  // Messages stay short, whatever the input.
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  throw std::invalid_argument("\"" + key + "\" is " + text + ", expected " + expected);
}

}  // namespace smile::sim

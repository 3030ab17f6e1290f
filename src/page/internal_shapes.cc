#include "page/internal_shapes.h"

#include <utility>

#include "demonstrator/hand.h"
#include "page/snap_names.h"
#include "robot/face_expression.h"

namespace smile::page {

JsonShape NumberShape() { return JsonShape::Number(); }
JsonShape TextShape() { return JsonShape::Text(); }
JsonShape FlagShape() { return JsonShape::Flag(); }
JsonShape TextsShape() { return JsonShape::List(TextShape()); }
JsonShape NumbersShape() { return JsonShape::List(NumberShape()); }
JsonShape ObjectShape(std::vector<JsonMember> members) {
  return JsonShape::Object(std::move(members));
}

JsonMember KindMember(const char* name) { return {"t", JsonShape::Word({name})}; }

JsonShape HandNameShape() {
  std::vector<std::string> names;
  for (const auto hand : demonstrator::kHandNames) names.emplace_back(ToString(hand));
  return JsonShape::Word(names).Called("HandName");
}

JsonShape FaceExpressionShape() {
  return JsonShape::Word({robot::kFaceExpressionNames.begin(), robot::kFaceExpressionNames.end()})
      .Called("FaceExpression");
}

JsonShape SnapNameShape() {
  return JsonShape::Word({kSnapNames.begin(), kSnapNames.end()}).Called("SnapName");
}

JsonShape PointShape() { return JsonShape::List(NumberShape(), 3, 3).Called("Point"); }
JsonShape PoseShape() { return JsonShape::List(NumberShape(), 7, 7).Called("Pose"); }

JsonShape VisualShape() {
  return ObjectShape(
             {{"frame", NumberShape(), true, "0 is the world"},
              {"object", NumberShape()},
              {"part", TextShape(), kOptional, "id of the innermost part it is of that has one"},
              {"button", TextShape(), kOptional, "of a switch: its name in commands"},
              {"pose", PoseShape()},
              {"color", TextShape(), true, "#rrggbb"},
              {"choice", NumberShape(), true, "-1: it is always seen"},
              {"look", NumberShape(), true, "it is seen when `looks[choice]` is this"},
              {"glows", FlagShape(), kOptional},
              {"block", PointShape(), kOptional, "full lengths"},
              {"cylinder", JsonShape::List(NumberShape(), 3, 3), kOptional,
               "radius, height, sides; its axis is y"},
              {"sphere", NumberShape(), kOptional, "its radius"},
              {"mesh", NumberShape(), kOptional, "its number, with `scale`"},
              {"scale", NumberShape(), kOptional}})
      .Called("Visual");
}

JsonShape SceneObjectShape() {
  const JsonShape part =
      ObjectShape({{"id", TextShape()}, {"pointable", FlagShape()}, {"within", TextShape()}});
  const JsonShape control =
      ObjectShape({{"id", TextShape()}, {"kind", TextShape()}, {"parts", TextsShape()}});
  return ObjectShape(
             {{"id", TextShape()},
              {"frame", NumberShape()},
              {"shape", TextShape()},
              {"fixed", FlagShape(), true, "it cannot be taken"},
              {"parts", JsonShape::List(part), true,
               "outer ones first; `within` is the id of the part, or the object, around it"},
              {"controls", JsonShape::List(control)},
              {"bonds", FlagShape(), true, "it can be fastened to others"},
              {"properties", TextsShape(), true, "that may matter"}})
      .Called("SceneObject");
}

JsonShape RobotDescriptionShape() {
  const JsonShape joint = ObjectShape({{"name", TextShape()},
                                       {"arm", TextShape(), true, "empty: of none"},
                                       {"is_head", FlagShape(), true, "it turns the head"},
                                       {"lower", NumberShape()},
                                       {"upper", NumberShape()},
                                       {"speed", NumberShape()},
                                       {"is_length", FlagShape()}});
  const JsonShape gripper = ObjectShape({{"arm", TextShape()}, {"stroke", NumberShape()}});
  return ObjectShape({{"name", TextShape()},
                      {"joints", JsonShape::List(joint)},
                      {"grippers", JsonShape::List(gripper)},
                      {"poses", TextsShape()},
                      {"cameras", TextsShape()}})
      .Called("RobotDescription");
}

JsonShape HandShape() {
  return ObjectShape({{"object", TextShape().OrNull(), true, "null: it holds nothing"},
                      {"goal", PointShape(), kOptional, "where it wants the grasped point"},
                      {"place", PointShape(), kOptional, "where the object's origin is then"},
                      {"plane", NumberShape()},
                      {"angles", PointShape(), kOptional, "how it wants the object turned"}})
      .Called("Hand");
}

JsonShape ActionSummaryShape() {
  return ObjectShape({{"do", JsonShape::Word({"take", "put", "drop", "release", "destroy", "point",
                                              "trigger", "fasten", "loosen", "add", "remove",
                                              "clear", "load"})},
                      {"hand", HandNameShape().OrNull(), true, "null of what no hand did"},
                      {"what", TextShape(), true, "an id, `5 objects`, or the name of a scene"},
                      {"on", TextShape(), kOptional, "id of what is beneath, empty for the table"},
                      {"into", TextShape(), kOptional},
                      {"words", TextShape(), true, "all of it, for people"}})
      .Called("ActionSummary");
}

JsonShape SegmentShape() {
  return ObjectShape(
             {{"number", NumberShape()},
              {"deed", ActionSummaryShape().OrNull(), true, "what began it; null of the first"},
              {"seconds", NumberShape()}})
      .Called("Segment");
}

JsonShape TimelineShape() {
  const JsonShape segment = ObjectShape({{"number", NumberShape()},
                                         {"deed", ActionSummaryShape().OrNull()},
                                         {"begin", NumberShape()},
                                         {"end", NumberShape()}});
  const JsonShape step = ObjectShape({{"step", NumberShape()},
                                      {"parent", NumberShape().OrNull()},
                                      {"deed", ActionSummaryShape().OrNull()},
                                      {"begin", NumberShape()},
                                      {"end", NumberShape()},
                                      {"on_way", FlagShape()}});
  return ObjectShape({{"segments", JsonShape::List(segment)},
                      {"steps", JsonShape::List(step)},
                      {"seconds", NumberShape()}})
      .Called("Timeline");
}

JsonShape AllowedShape() { return TextShape().OrTrue().Called("Allowed"); }

JsonShape DiagnosticShape() {
  return ObjectShape({{"file", TextShape()},
                      {"line", NumberShape()},
                      {"element", TextShape()},
                      {"message", TextShape()}})
      .Called("Diagnostic");
}

JsonShape ConsoleLineShape() {
  return ObjectShape({{"text", TextShape()},
                      {"file", TextShape(), kOptional},
                      {"line", NumberShape(), kOptional}})
      .Called("ConsoleLine");
}

JsonShape LibraryEntryShape() {
  return ObjectShape({{"id", TextShape()},
                      {"title", TextShape(), kOptional},
                      {"notes", TextShape(), kOptional},
                      {"scene", TextShape(), kOptional},
                      {"seconds", NumberShape(), kOptional, "to its last frame"},
                      {"segments", NumberShape(), kOptional},
                      {"error", TextShape(), kOptional, "in place of all these: it cannot be read"},
                      {"made", TextShape(), true, "when it was last recorded into"},
                      {"binned", FlagShape()}})
      .Called("LibraryEntry");
}

}  // namespace smile::page

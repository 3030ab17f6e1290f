#include "page/internal_shapes.h"

#include <utility>

#include "demonstrator/hand.h"
#include "page/snap_names.h"
#include "robot/face_expression.h"

// Shapes that several messages share. A shape with a name (Called) becomes a type of that name in
// the page's TypeScript; unnamed ones are written out where they are used.

namespace smile::page {

JsonShape NumberShape() { return JsonShape::Number(); }
JsonShape TextShape() { return JsonShape::Text(); }
JsonShape FlagShape() { return JsonShape::Flag(); }
// Arguments are numbers, texts and messages, which have arguments in turn.
JsonShape MessageShape() {
  const JsonShape message =
      ObjectShape({{"say", TextShape(), true, "id in `program` of texts/"},
                   {"with", JsonShape::Map(JsonShape::Anything()), kOptional, "its arguments"}});
  return TextShape().Or(message).ArrivesAs("string").Called("UserMessage");
}
JsonShape TextsShape() { return JsonShape::List(TextShape()); }
JsonShape NumbersShape() { return JsonShape::List(NumberShape()); }
JsonShape ObjectShape(std::vector<JsonMember> members) {
  return JsonShape::Object(std::move(members));
}

JsonMember KindMember(const char* name) { return {"t", JsonShape::Word({name})}; }

JsonShape HandNameShape() {
  std::vector<std::string> names;
  // Derived from the program's own names, so that the page's type cannot differ.
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

// Points and poses are lists of fixed length, which are compact and need no names: x, y, z in
// units, and for poses the quaternion x, y, z, w.
JsonShape PointShape() { return JsonShape::List(NumberShape(), 3, 3).Called("Point"); }
JsonShape PoseShape() { return JsonShape::List(NumberShape(), 7, 7).Called("Pose"); }

// A visual has exactly one of the members `block`, `cylinder`, `sphere` and `mesh`.
JsonShape VisualShape() {
  return ObjectShape({{"frame", NumberShape(), true, "0 is the world"},
                      {"object", NumberShape()},
                      {"part", TextShape(), kOptional,
                       "id of the innermost part with an id that contains it"},
                      {"button", TextShape(), kOptional, "name of a switch's button in commands"},
                      {"pose", PoseShape()},
                      {"color", TextShape(), true, "#rrggbb"},
                      {"choice", NumberShape(), true, "-1: always visible"},
                      {"look", NumberShape(), true, "visible when `looks[choice]` has this value"},
                      {"glows", FlagShape(), kOptional},
                      {"block", PointShape(), kOptional, "full lengths"},
                      {"cylinder", JsonShape::List(NumberShape(), 3, 3), kOptional,
                       "radius, height, sides; its axis is y"},
                      {"sphere", NumberShape(), kOptional, "radius"},
                      {"mesh", NumberShape(), kOptional, "number of the mesh, with `scale`"},
                      {"scale", NumberShape(), kOptional}})
      .Called("Visual");
}

// The members that never change while a scene is shown; poses and states are sent separately.
JsonShape SceneObjectShape() {
  const JsonShape part =
      ObjectShape({{"id", TextShape()}, {"pointable", FlagShape()}, {"within", TextShape()}});
  const JsonShape control =
      ObjectShape({{"id", TextShape()}, {"kind", TextShape()}, {"parts", TextsShape()}});
  const JsonShape tool = ObjectShape(
      {{"point", PointShape(), true, "its tip, or the middle of its blades"},
       {"axis", PointShape(), true, "direction in which it goes to its work, of length 1"},
       {"edge", NumberShape(), true, "length of its blades along the axis, or 0"},
       {"turns", FlagShape(), true, "it is also used by turning it"}});
  return ObjectShape(
             {{"id", TextShape()},
              {"frame", NumberShape()},
              {"shape", TextShape()},
              {"fixed", FlagShape(), true, "it cannot be grasped"},
              {"parts", JsonShape::List(part), true,
               "outer parts first; `within` is the id of the part or object that contains it"},
              {"controls", JsonShape::List(control)},
              {"bonds", FlagShape(), true, "it can be fastened to others"},
              {"tool", tool, kOptional, "in the frame of the object"},
              {"properties", TextsShape(), true, "properties that can be marked as relevant"}})
      .Called("SceneObject");
}

JsonShape RobotDescriptionShape() {
  // Limits are in rad, or in m for joints with `is_length`; speeds in the same per second.
  const JsonShape joint = ObjectShape({{"name", TextShape()},
                                       {"arm", TextShape(), true, "empty: of no arm"},
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

// All members but `object` and `plane` are missing while the hand is empty.
JsonShape HandShape() {
  return ObjectShape(
             {{"object", TextShape().OrNull(), true, "null: the hand is empty"},
              {"goal", PointShape(), kOptional, "target of the grasped point"},
              {"place", PointShape(), kOptional, "position of the object's origin at the target"},
              {"work",
               ObjectShape({{"target", TextShape(), true, "in words"},
                            {"by", PointShape(), true, "from the working point of the tool"}}),
               kOptional, "the place nearest to a held tool at which it can work"},
              {"stopped_by", JsonShape::List(TextShape()), kOptional,
               "ids of what keeps the object from its target; an empty one is the table"},
              {"stopped_at", PointShape(), kOptional, "position of the object's origin there"},
              {"slide_first", TextShape(), kOptional,
               "id of what slides on one of these, and can go further out of the way"},
              {"on_rail", FlagShape(), kOptional, "it slides on another object"},
              {"plane", NumberShape()},
              {"angles", PointShape(), kOptional, "target orientation of the object [degrees]"}})
      .Called("Hand");
}

JsonShape ToolUseShape() {
  const JsonShape verb = JsonShape::Word({"cut", "fasten", "loosen"});
  return ObjectShape({{"do", JsonShape::List(verb)}, {"target", TextShape(), true, "in words"}})
      .Called("ToolUse");
}

JsonShape ActionSummaryShape() {
  return ObjectShape(
             {{"do", JsonShape::Word({"take", "put", "drop", "release", "destroy", "point",
                                      "trigger", "fasten", "loosen", "cut", "add", "remove", "move",
                                      "clear", "load"})},
              {"hand", HandNameShape().OrNull(), true, "null for an action without a hand"},
              {"what", TextShape(), true, "an id, `5 objects`, or the name of a scene"},
              {"with", TextShape(), kOptional, "id of the tool"},
              {"on", TextShape(), kOptional, "id of the object beneath, empty for the table"},
              {"into", TextShape(), kOptional},
              {"words", TextShape(), true, "description of the action"}})
      .Called("ActionSummary");
}

JsonShape SegmentShape() {
  return ObjectShape({{"number", NumberShape()},
                      {"deed", ActionSummaryShape().OrNull(), true,
                       "the action that began it; null for the first"},
                      {"seconds", NumberShape()}})
      .Called("Segment");
}

JsonShape ConflictShape() {
  return ObjectShape({{"hand", HandNameShape().OrNull(), true, "null: of no hand"},
                      {"seconds", NumberShape()},
                      {"reason", TextShape(), true, "in English"},
                      {"message", MessageShape(), false, "the reason in the language of the page"}})
      .Called("Conflict");
}

// Segments are what the recording shows; steps are all branches of its history, including undone
// ones, where `on_way` marks those that the recording shows.
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
                      {"seconds", NumberShape()},
                      {"conflicts", JsonShape::List(ConflictShape())}})
      .Called("Timeline");
}

// A text is the reason of a refusal, ready to be displayed.
JsonShape AllowedShape() { return MessageShape().OrTrue().Called("Allowed"); }

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
  return ObjectShape(
             {{"id", TextShape()},
              {"title", TextShape(), kOptional},
              {"notes", TextShape(), kOptional},
              {"scene", TextShape(), kOptional},
              {"seconds", NumberShape(), kOptional, "time of the last frame"},
              {"segments", NumberShape(), kOptional},
              {"corrects",
               ObjectShape({{"recording", TextShape(), true, "an id"}, {"seconds", NumberShape()}})
                   .OrNull(),
               kOptional, "the recording that it is the same as, up to this moment"},
              {"error", TextShape(), kOptional,
               "replaces all these members if the recording cannot be read"},
              {"made", TextShape(), true, "time of the last change by recording (ISO 8601, UTC)"},
              {"binned", FlagShape()}})
      .Called("LibraryEntry");
}

JsonShape ShareLinkShape() {
  return ObjectShape({{"secret", TextShape()}, {"made", TextShape(), true, "ISO 8601, UTC"}})
      .Called("ShareLink");
}

}  // namespace smile::page

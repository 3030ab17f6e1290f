#include "page/internal_update_forms.h"

#include "demonstrator/hand.h"
#include "page/internal_shapes.h"

namespace smile::page {
namespace {

/// The scene, sent once per scene. Poses of frames come separately, as binary messages.
JsonShape SceneUpdateShape() {
  return ObjectShape({KindMember("scene"),
                      {"scene", NumberShape(), true, "counts up"},
                      {"name", TextShape()},
                      {"metersPerUnit", NumberShape()},
                      {"table", ObjectShape({{"size", PointShape()}}), true, "its top is z = 0"},
                      {"numFrames", NumberShape()},
                      {"robotFrame", NumberShape().OrNull(), true, "first of the robot's"},
                      {"visuals", JsonShape::List(VisualShape())},
                      {"looks", NumbersShape()},
                      {"objects", JsonShape::List(SceneObjectShape())},
                      {"robot", RobotDescriptionShape().OrNull()}})
      .Called("SceneMessage");
}

/// State of both hands, in StateUpdateShape().
JsonShape HandsNowShape() {
  std::vector<JsonMember> hands;
  for (const auto hand : demonstrator::kHandNames) {
    hands.push_back({std::string(ToString(hand)), HandShape()});
  }
  return ObjectShape(hands);
}

/// State of the robot, in StateUpdateShape().
JsonShape RobotNowShape() {
  return ObjectShape({{"shown", FlagShape()},
                      {"mood", FaceExpressionShape()},
                      {"following", FlagShape()},
                      {"joints", JsonShape::Map(NumberShape())},
                      {"grippers", NumbersShape()},
                      {"head", NumberShape()}});
}

/// State of the running brain, in StateUpdateShape().
JsonShape BrainNowShape() {
  return ObjectShape(
      {{"name", TextShape()},
       {"status", JsonShape::Word({"none", "starting", "running", "exited", "failed", "stopped"})},
       {"message", TextShape()},
       {"file", TextShape()},
       {"line", NumberShape()}});
}

JsonShape StateUpdateShape() {
  const JsonShape recording = ObjectShape({{"id", TextShape()},
                                           {"title", TextShape()},
                                           {"seconds", NumberShape()},
                                           {"segments", JsonShape::List(SegmentShape())}});
  const JsonShape playback = ObjectShape({{"recording", TextShape()},
                                          {"seconds", NumberShape()},
                                          {"length", NumberShape()},
                                          {"rate", NumberShape()}});
  const JsonShape failure = ObjectShape({{"recording", TextShape()},
                                         {"title", TextShape()},
                                         {"error", TextShape()},
                                         {"kept", FlagShape(), true, "it is in the library"}});
  const JsonShape allowed = ObjectShape(
      {{"requests", JsonShape::Map(AllowedShape())}, {"commands", JsonShape::Map(AllowedShape())}});
  return ObjectShape(
             {KindMember("state"),
              {"tick", NumberShape()},
              {"mode", JsonShape::Word({"live", "playback", "rage"})},
              {"allowed", allowed, true, "what may be asked for now, else why not"},
              {"paused", FlagShape()},
              {"speed", NumberShape(), true, "simulated per real second, over the last one"},
              {"hands", HandsNowShape()},
              {"still", FlagShape()},
              {"recording", recording.OrNull()},
              {"playback", playback.OrNull()},
              {"restoring", TextShape().OrNull(), true,
               "the recording to a moment of which the world goes back"},
              {"failure", failure.OrNull(), true, "the last recording ended by itself"},
              {"controls", JsonShape::Map(TextShape()), true,
               "states as recordings have them; of a switch its position"},
              {"gone", TextsShape()},
              {"fallen", TextsShape(), true, "on the floor, out of play"},
              {"attention", JsonShape::Map(TextsShape())},
              {"robot", RobotNowShape().OrNull()},
              {"brain", BrainNowShape()},
              {"snap", JsonShape::List(SnapNameShape())},
              {"markers", JsonShape::List(PointShape())}})
      .Called("StateMessage");
}

/// An event. Its kind decides which of the optional members it has.
JsonShape EventUpdateShape() {
  return ObjectShape({KindMember("event"),
                      {"kind", TextShape()},
                      {"tick", NumberShape()},
                      {"hand", HandNameShape(), kOptional},
                      {"arm", TextShape(), kOptional},
                      {"object", TextShape(), kOptional},
                      {"reason", TextShape(), kOptional},
                      {"part", TextShape(), kOptional},
                      {"control", TextShape(), kOptional},
                      {"state", TextShape(), kOptional},
                      {"guest", TextShape(), kOptional},
                      {"host", TextShape(), kOptional},
                      {"tightness", NumberShape(), kOptional},
                      {"properties", TextsShape(), kOptional},
                      {"objects", TextsShape(), kOptional, "that were added or removed"}})
      .Called("EventMessage");
}

}  // namespace

std::vector<UpdateForm> MakeUpdateForms() {
  const JsonShape clients = ObjectShape({KindMember("clients"),
                                         {"controller", NumberShape().OrNull()},
                                         {"clients", NumbersShape()},
                                         {"you", NumberShape()}})
                                .Called("ClientsMessage");
  const JsonShape console = ObjectShape({KindMember("console"),
                                         {"all", FlagShape(), kOptional},
                                         {"lines", JsonShape::List(ConsoleLineShape())}})
                                .Called("ConsoleMessage");
  const JsonShape progress = ObjectShape({KindMember("progress"),
                                          {"what", TextShape()},
                                          {"done", NumberShape()},
                                          {"total", NumberShape()}})
                                 .Called("ProgressMessage");
  return {
      {"scene", SceneUpdateShape(), "see below"},
      {"looks",
       ObjectShape({KindMember("looks"), {"looks", NumbersShape()}}).Called("LooksMessage"),
       "one number per choice"},
      {"state", StateUpdateShape(), "see below; at most 20 a second"},
      {"event", EventUpdateShape(), "as docs/recording-format.md has them"},
      {"console", console, "lines of the brain; with `all`: true instead of those told before"},
      {"clients", clients, "their numbers"},
      {"score",
       ObjectShape({KindMember("score"), {"result", JsonShape::Map(JsonShape::Anything())}})
           .Called("ScoreMessage"),
       "as docs/results.md has it"},
      {"progress", progress,
       "`what`: the request's `do`; `done` and `total` in seconds, the same at the end"},
      {"control_wanted",
       ObjectShape({KindMember("control_wanted"), {"by", NumberShape()}})
           .Called("ControlWantedMessage"),
       "to the controller alone"},
      {"control_kept",
       ObjectShape({KindMember("control_kept"), {"by", NumberShape()}})
           .Called("ControlKeptMessage"),
       "`by`: the controller; to a client who asked for control"},
      {"library", ObjectShape({KindMember("library")}).Called("LibraryMessage"),
       "recordings came, went or got other titles: ask for `library` again"},
      {"error", ObjectShape({KindMember("error"), {"error", TextShape()}}).Called("ErrorMessage"),
       "something went wrong that was nobody's request, for example the eye cannot draw"},
  };
}

}  // namespace smile::page

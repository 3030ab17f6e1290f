#include "page/internal_update_forms.h"

#include "demonstrator/hand.h"
#include "page/internal_dataset_shapes.h"
#include "page/internal_shapes.h"

// Table of all messages that are not replies, with the same uses as the table of requests. Poses
// and pictures of the eye are binary messages and are not listed here.

namespace smile::page {
namespace {

/// The scene, sent once per scene. Poses of frames come separately, as binary messages.
JsonShape SceneUpdateShape() {
  // Sent once per scene, since it can be large; everything that changes with time is in other
  // messages.
  return ObjectShape(
             {KindMember("scene"),
              {"scene", NumberShape(), true, "number of the scene, increasing"},
              {"name", TextShape()},
              {"metersPerUnit", NumberShape()},
              {"table", ObjectShape({{"size", PointShape()}}), true, "its top is at z = 0"},
              {"center", PointShape(), kOptional,
               "what views look at (default: the origin, the middle of the table top)"},
              {"view",
               ObjectShape({{"eye", PointShape()},
                            {"target", PointShape()},
                            {"angle", NumberShape(), true, "from top to bottom [degrees]"}})
                   .OrNull(),
               kOptional, "from where the page looks at first: the scene's camera `first_view`"},
              {"numFrames", NumberShape()},
              {"robotFrame", NumberShape().OrNull(), true, "first frame of the robot"},
              {"visuals", JsonShape::List(VisualShape())},
              {"looks", NumbersShape()},
              {"objects", JsonShape::List(SceneObjectShape())},
              {"robot", RobotDescriptionShape().OrNull()}})
      .Called("SceneMessage");
}

/// State of both hands, in StateUpdateShape().
JsonShape HandsNowShape() {
  // Four members: the two hands, both hands together, and any hand.
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
       {"claim", ObjectShape({{"done", FlagShape()}, {"reason", TextShape()}}).OrNull()},
       {"file", TextShape()},
       {"line", NumberShape()}});
}

JsonShape StateUpdateShape() {
  // Members that are null while they do not apply: there is always at most one of `recording` and
  // `playback`, as a recording in progress cannot be hidden.
  const JsonShape over =
      ObjectShape({{"hands", JsonShape::List(HandNameShape())},
                   {"actions_left", NumberShape(), true, "that will be done again"},
                   {"conflicts", JsonShape::List(ConflictShape()), true,
                    "commands that were refused now, or that found something else than before"}});
  const JsonShape corrects = ObjectShape(
      {{"title", TextShape(), true, "of the other recording"}, {"seconds", NumberShape()}});
  const JsonShape recording = ObjectShape({{"id", TextShape()},
                                           {"title", TextShape()},
                                           {"seconds", NumberShape()},
                                           {"segments", JsonShape::List(SegmentShape())},
                                           {"over", over.OrNull(), true, "see `record_over`"},
                                           {"corrects", corrects.OrNull(), true, "see `correct`"}});
  const JsonShape playback = ObjectShape({{"recording", TextShape()},
                                          {"seconds", NumberShape()},
                                          {"length", NumberShape()},
                                          {"rate", NumberShape()}});
  const JsonShape failure =
      ObjectShape({{"recording", TextShape()},
                   {"title", TextShape()},
                   {"error", MessageShape()},
                   {"kept", FlagShape(), true, "the recording is in the library"}});
  const JsonShape eye = ObjectShape({{"camera", TextShape()}, {"cameras", TextsShape()}});
  const JsonShape allowed = ObjectShape(
      {{"requests", JsonShape::Map(AllowedShape())}, {"commands", JsonShape::Map(AllowedShape())}});
  return ObjectShape(
             {KindMember("state"),
              {"tick", NumberShape()},
              {"mode", JsonShape::Word({"live", "playback", "rage", "watched"})},
              {"allowed", allowed, true,
               "true, or the reason why not, for each request and command"},
              {"paused", FlagShape()},
              {"speed", NumberShape(), true, "simulated time per real time, over the last second"},
              {"hands", HandsNowShape()},
              {"uses", JsonShape::Map(ToolUseShape()), true,
               "what each held tool would do if it were used now; missing if it would be refused"},
              {"still", FlagShape()},
              {"recording", recording.OrNull()},
              {"playback", playback.OrNull()},
              {"restoring", TextShape().OrNull(), true,
               "the recording of which a moment is being restored"},
              {"failure", failure.OrNull(), true, "reason why the last recording ended by itself"},
              {"controls", JsonShape::Map(TextShape()), true,
               "states as in recordings; for a switch, its position"},
              {"gone", TextsShape()},
              {"fallen", TextsShape(), true, "objects on the floor, out of play"},
              {"attention", JsonShape::Map(TextsShape())},
              {"robot", RobotNowShape().OrNull()},
              {"brain", BrainNowShape()},
              {"snap", JsonShape::List(SnapNameShape())},
              {"eye", eye.OrNull(), true,
               "the camera whose pictures are recorded, and those that can be; see `eye`"},
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
                      {"by", TextShape(), kOptional, "the object that did it"},
                      {"reason", TextShape(), kOptional},
                      {"part", TextShape(), kOptional},
                      {"control", TextShape(), kOptional},
                      {"state", TextShape(), kOptional},
                      {"words", MessageShape(), kOptional, "what contact or a tool did, in words"},
                      {"guest", TextShape(), kOptional},
                      {"host", TextShape(), kOptional},
                      {"tightness", NumberShape(), kOptional},
                      {"properties", TextsShape(), kOptional},
                      {"objects", TextsShape(), kOptional, "the added or removed objects"}})
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
      {"offers",
       ObjectShape({KindMember("offers"), {"requests", TextsShape()}, {"commands", TextsShape()}})
           .Called("OffersMessage"),
       "the only requests and commands that this program carries out: pages leave out what needs "
       "others. A studio carries out all, and does not send it"},
      {"looks",
       ObjectShape({KindMember("looks"), {"looks", NumbersShape()}}).Called("LooksMessage"),
       "one number per choice"},
      {"state", StateUpdateShape(), "see below; at most 20 per second"},
      {"event", EventUpdateShape(), "see docs/recording-format.md"},
      {"console", console, "output of the brain; if `all` is true, replaces all earlier lines"},
      {"clients", clients, "numbers of the clients"},
      {"score",
       ObjectShape({KindMember("score"), {"result", JsonShape::Map(JsonShape::Anything())}})
           .Called("ScoreMessage"),
       "see docs/results.md"},
      {"progress", progress,
       "`what`: `do` of the request; `done` and `total` in seconds, of `analyze` in simulations; "
       "equal at the end"},
      {"control_wanted",
       ObjectShape({KindMember("control_wanted"), {"by", NumberShape()}})
           .Called("ControlWantedMessage"),
       "sent to the controller only"},
      {"control_kept",
       ObjectShape({KindMember("control_kept"), {"by", NumberShape()}})
           .Called("ControlKeptMessage"),
       "`by`: the controller; sent to each client that asked for control"},
      {"library", ObjectShape({KindMember("library")}).Called("LibraryMessage"),
       "the list of recordings has changed: request `library` again"},
      {"jobs",
       ObjectShape({KindMember("jobs"), {"jobs", JsonShape::List(JobShape())}})
           .Called("JobsMessage"),
       "as the request `jobs` returns them; not sent after `hello`"},
      {"error",
       ObjectShape({KindMember("error"), {"error", MessageShape()}}).Called("ErrorMessage"),
       "an error outside any request, for example of the eye's renderer"},
  };
}

}  // namespace smile::page

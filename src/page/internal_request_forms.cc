#include "page/internal_request_forms.h"

#include "page/internal_shapes.h"

namespace smile::page {
namespace {

/// Requests about the connection and who controls the world. A form is: the name, the request's
/// members, the reply's members, remarks, and if it is also open to clients without control.
std::vector<RequestForm> ConnectionRequests() {
  return {
      {"hello",
       {{"version", NumberShape(), true, "1"}},
       {{"client", NumberShape()},
        {"controller", NumberShape().OrNull()},
        {"program", TextShape()}},
       "then everything below is told",
       true},
      {"ping", {}, {}, "", true},
      {"take_control",
       {{"by_force", FlagShape(), kOptional}},
       {{"granted", FlagShape()}},
       "granted when nobody controls, else the controller is asked by `control_wanted`; one client "
       "asks at most once in 10 s, all together once in 3 s. By force it is taken from a "
       "controller whom this client has asked, and who has asked for nothing (but pings) for 30 s "
       "since; else the request asks, or fails and reports how long it takes",
       true},
      {"keep_control",
       {{"from", NumberShape(), true, "a client who asked"}},
       {},
       "that client is sent `control_kept`"},
      {"give_control", {{"to", NumberShape().OrNull(), kOptional, "client or null"}}, {}, ""},
  };
}

/// Requests that change or ask about the live world.
std::vector<RequestForm> WorldRequests() {
  return {
      {"command",
       {{"command", JsonShape::Anything().Called("Command"), true,
         "as docs/commands.md has it, or `drag`"},
        {"exact", FlagShape(), kOptional, "it does not snap"}},
       {{"recording", TextShape(), kOptional, "that was begun"},
        {"deed", ActionSummaryShape(), kOptional, "the action that was done, as in a timeline"}},
       ""},
      {"allowed",
       {{"requests", JsonShape::List(JsonShape::Map(JsonShape::Anything()), 0, 16), true,
         "requests, at most 16, that are not carried out"}},
       {{"allowed", JsonShape::List(AllowedShape())}},
       "of each in order: true, or why it would be refused. Also a command to a hand, an object or "
       "the robot is tried, on a copy of the world"},
      {"pause",
       {},
       {},
       "time stands still; commands are still carried out. Refused in playback, as `resume` is"},
      {"resume", {}, {}, ""},
      {"speed", {{"factor", NumberShape(), true, "0.1 to 4"}}, {}, "of simulated to real time"},
      {"snap",
       {{"to", JsonShape::List(SnapNameShape()), true,
         "any of `faces`, `edges`, `grid`, `angles`"}},
       {},
       "what drags and turns snap to from now on: by at most 0.15 units within the plane of the "
       "drag, and 5 degrees. Faces and edges count of objects that are turned alike; `angles` are "
       "right angles to the table and to the nearest object"},
      {"support",
       {{"object", TextShape(), true, "its id"}},
       {{"on", TextShape(), kOptional}, {"into", TextShape(), kOptional}},
       "id of what the object stands on (`on`) or lies in (`into`) now, empty for the table; "
       "neither while it is in the air, on the floor or gone"},
      {"resting_place",
       {{"hand", HandNameShape()}},
       {{"hand", HandNameShape()},
        {"pose", PoseShape().OrNull()},
        {"stale", FlagShape(), kOptional}},
       "where the held object would come to rest if it were released now, or null; `stale`: found "
       "a "
       "moment ago, as that takes long, or something still moves: ask again"},
  };
}

/// Requests that replace the scene, or add and remove objects.
std::vector<RequestForm> SceneRequests() {
  return {
      {"load",
       {{"scene", TextShape(), kOptional, "name in the gallery"},
        {"xml", TextShape(), kOptional, "in place of it, with `name`"},
        {"name", TextShape(), kOptional}},
       {},
       "refused while recording; nothing changes when the scene is wrong"},
      {"reload", {}, {}, "the scene as it was loaded"},
      {"check",
       {{"xml", TextShape()}, {"name", TextShape()}},
       {{"diagnostics", JsonShape::List(DiagnosticShape())}},
       "empty when all is well",
       true},
      {"spawn",
       {{"preset", TextShape(), true, "one of the gallery's presets"}, {"seed", NumberShape()}},
       {{"objects", TextsShape()}},
       "puts new objects at free places and tells their ids: the command `spawn`"},
      {"clear",
       {{"rage", FlagShape(), kOptional}},
       {},
       "takes away all that nothing holds: the command `clear`. With rage the robot does it, and "
       "after 10 s all is as before; that is refused while recording"},
  };
}

/// Requests about recordings and their edits.
std::vector<RequestForm> LibraryRequests() {
  const JsonMember recording{"recording", TextShape()};
  const JsonMember edits{"edits", JsonShape::List(JsonShape::Anything()), true, "see below"};
  const JsonMember report{"report", JsonShape::Anything()};
  return {
      {"library",
       {},
       {{"recordings", JsonShape::List(LibraryEntryShape())}},
       "the newest 1000, newest first, see below",
       true},
      {"rename",
       {recording,
        {"title", TextShape().OrNull(), kOptional},
        {"notes", TextShape().OrNull(), kOptional}},
       {},
       "at most 256 and 8192 bytes; refused while it is being recorded"},
      {"bin",
       {recording},
       {recording},
       "into the bin; answered with what it is called from now on. Refused while it is being "
       "recorded"},
      {"unbin", {recording}, {recording}, "back out of it"},
      {"open",
       {recording},
       {{"timeline", TimelineShape()}},
       "see below; the world is not touched",
       true},
      {"try_edit",
       {recording, edits},
       {report},
       "what would become of it, as docs/editing.md has it"},
      {"edit",
       {recording, edits, {"name", TextShape()}},
       {recording, report},
       "writes the edited demonstration as a new recording with this title; what the newest "
       "`try_edit` simulated is not simulated again"},
      {"cancel",
       {{"request", NumberShape(), true, "`seq` of a `try_edit` or `edit` of this client"}},
       {},
       "it fails at once, and writes nothing, unless it is done already",
       true},
  };
}

/// Requests that show a recording in place of the live world.
std::vector<RequestForm> PlaybackRequests() {
  const JsonMember recording{"recording", TextShape()};
  return {
      {"show",
       {recording, {"seconds", NumberShape(), kOptional}},
       {{"length", NumberShape()}},
       "the world shows this moment of it, and nothing can be grasped (`mode` is `playback`); "
       "refused while recording"},
      {"play",
       {{"rate", NumberShape(), kOptional}},
       {},
       "playback goes on from where it is; `rate` 0 stops it"},
      {"live", {}, {}, "back to the world as it was left"},
      {"branch",
       {recording, {"step", NumberShape()}, {"after", NumberShape(), kOptional}},
       {recording},
       "goes on from this moment of its history (docs/editing.md), recording; refused while "
       "recording. Until it is answered all goes on as before, but nothing else can be recorded or "
       "loaded"},
  };
}

/// Requests about brains.
std::vector<RequestForm> BrainRequests() {
  const JsonShape brain = ObjectShape({{"name", TextShape()},
                                       {"kind", JsonShape::Word({"octave", "python", "program"})},
                                       {"imitates", FlagShape()}});
  return {
      {"brains",
       {},
       {{"brains", JsonShape::List(brain)}},
       "the programs that may be started; `kind` is `octave`, `python` or `program`; `imitates`: "
       "it "
       "reads demonstrations (docs/brains.md)",
       true},
      {"start_brain",
       {{"brain", TextShape()},
        {"demonstration", TextShape(), kOptional, "a recording"},
        {"scene", TextShape(), kOptional}},
       {},
       "loads the scene if one is given; answered when the program begins to start. What goes "
       "wrong "
       "with it then is in its `status`, and on the console"},
      {"stop_brain", {}, {}, "at once, also while it starts or thinks"},
      {"imitate",
       {{"recording", TextShape()}, {"brain", TextShape()}, {"scene", TextShape()}},
       {{"recording", TextShape()}},
       "the brain, one that `imitates`, watches the recording and acts in the scene, live and "
       "recorded; answered with the imitation's recording. When the brain ends, the recording ends "
       "and the score comes as `{\"t\":\"score\",...}`"},
  };
}

}  // namespace

std::vector<RequestForm> MakeRequestForms() {
  std::vector<RequestForm> all;
  for (const auto& forms : {ConnectionRequests(), WorldRequests(), SceneRequests(),
                            LibraryRequests(), PlaybackRequests(), BrainRequests()}) {
    all.insert(all.end(), forms.begin(), forms.end());
  }
  return all;
}

}  // namespace smile::page

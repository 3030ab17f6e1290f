#include "page/internal_request_forms.h"

#include "page/internal_dataset_shapes.h"
#include "page/internal_shapes.h"

// Table of all requests: the source of docs/studio-protocol.md, of the page's TypeScript types, and
// of the tests that check each request against its form. Handlers are registered elsewhere, by
// name.

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
       "afterwards all messages of the next table are sent",
       true},
      {"ping", {}, {}, "", true},
      {"take_control",
       {{"by_force", FlagShape(), kOptional}},
       {{"granted", FlagShape()}},
       "granted if no client has control; otherwise the controller is asked by `control_wanted`. "
       "Each client may ask at most once in 10 s, and all clients together once in 3 s. `by_force` "
       "takes control from a controller that this client has asked and that has sent no request "
       "(except `ping`) in the 30 s since; otherwise the request asks, or fails and reports the "
       "remaining time",
       true},
      {"keep_control",
       {{"from", NumberShape(), true, "a client that asked"}},
       {},
       "`control_kept` is sent to that client"},
      {"give_control", {{"to", NumberShape().OrNull(), kOptional, "client or null"}}, {}, ""},
  };
}

/// Requests that change or ask about the live world.
std::vector<RequestForm> WorldRequests() {
  return {
      {"command",
       {{"command", JsonShape::Anything().Called("Command"), true,
         "see docs/commands.md; also `drag`"},
        {"exact", FlagShape(), kOptional, "no snapping"}},
       {{"recording", TextShape(), kOptional, "the started recording"},
        {"deed", ActionSummaryShape(), kOptional, "the resulting action, as in a timeline"},
        {"objects", TextsShape(), kOptional, "ids of the added objects"}},
       ""},
      {"allowed",
       {{"requests", JsonShape::List(JsonShape::Map(JsonShape::Anything()), 0, 16), true,
         "at most 16 requests, which are not carried out"}},
       {{"allowed", JsonShape::List(AllowedShape())}},
       "for each request in order: true, or the reason why it would be refused. Commands to a "
       "hand, an object or the robot are tried on a copy of the world"},
      {"pause",
       {},
       {},
       "stops time; commands are still carried out. Refused in playback, like `resume`"},
      {"resume", {}, {}, ""},
      {"speed",
       {{"factor", NumberShape(), true, "0.1 to 4"}},
       {},
       "sets the ratio of simulated to real time"},
      {"snap",
       {{"to", JsonShape::List(SnapNameShape()), true,
         "any of `rails`, `faces`, `edges`, `grid`, `angles`"}},
       {},
       "sets what drags and turns snap to: by at most 0.15 units in the plane of the drag, and by "
       "at most 5 degrees. `faces` and `edges` are those of objects with the same orientation, "
       "also of objects below; `angles` are right angles to the table and to the nearest object. "
       "With `rails`, what slides on another object stays on its rail, and within its ends. From "
       "the start: `rails`, `faces` and `edges`"},
      {"eye",
       {{"camera", TextShape(), true, "one of `cameras` in the state"}},
       {},
       "sets the camera whose pictures the next recordings contain. Refused while recording or "
       "while a brain runs"},
      {"support",
       {{"object", TextShape(), true, "id of the object"}},
       {{"on", TextShape(), kOptional}, {"into", TextShape(), kOptional}},
       "id of the object on which (`on`) or in which (`into`) the object rests now, empty for the "
       "table; neither if it is in the air, on the floor or removed"},
      {"resting_place",
       {{"hand", HandNameShape()}},
       {{"hand", HandNameShape()},
        {"pose", PoseShape().OrNull()},
        {"stale", FlagShape(), kOptional}},
       "pose in which the held object would come to rest if it were released now, or null; "
       "`stale`: the pose was computed earlier, or something still moves: ask again"},
  };
}

/// Requests that replace the scene, or add and remove objects.
std::vector<RequestForm> SceneRequests() {
  return {
      {"load",
       {{"scene", TextShape(), kOptional, "name in the gallery"},
        {"xml", TextShape(), kOptional, "instead of `scene`, with `name`"},
        {"name", TextShape(), kOptional}},
       {},
       "loads a scene. Refused while recording; a scene with errors changes nothing"},
      {"reload", {}, {}, "loads the present scene again"},
      {"check",
       {{"xml", TextShape()}, {"name", TextShape()}},
       {{"diagnostics", JsonShape::List(DiagnosticShape())}},
       "empty if the scene has no errors",
       true},
      {"spawn",
       {{"preset", TextShape(), true, "one of the gallery's presets"}, {"seed", NumberShape()}},
       {{"objects", TextsShape()}},
       "puts new objects at free places, by the command `spawn`, and returns their ids"},
      {"clear",
       {{"rage", FlagShape(), kOptional}},
       {},
       "removes all objects that are not held, by the command `clear`. With `rage`, the robot "
       "clears the table, and after 10 s everything is restored; refused while recording"},
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
       "the newest 1000 recordings, newest first; see below",
       true},
      {"rename",
       {recording,
        {"title", TextShape().OrNull(), kOptional},
        {"notes", TextShape().OrNull(), kOptional}},
       {},
       "title and notes of at most 256 and 8192 bytes. Refused for a recording in progress"},
      {"bin",
       {recording},
       {recording},
       "moves a recording to the bin, which ends its links, and returns its new id. Refused for a "
       "recording in progress"},
      {"unbin",
       {recording},
       {recording},
       "moves a recording out of the bin and returns its new id"},
      {"open",
       {recording},
       {{"timeline", TimelineShape()}},
       "see below; does not change the world",
       true},
      {"analyze",
       {recording,
        {"ignored", TextsShape(), false, "ids of goals that do not count, see docs/analysis.md"}},
       {{"analysis", JsonShape::Anything(), true, "see docs/analysis.md"},
        {"graph", TextShape(), true, "SVG of the order of the subtasks"}},
       "simulates the demonstration without its subtasks and in other orders"},
      {"try_edit", {recording, edits}, {report}, "effect of the edits, see docs/editing.md"},
      {"edit",
       {recording, edits, {"name", TextShape()}},
       {recording, report},
       "writes the edited demonstration as a new recording with this title; reuses the simulation "
       "of the newest `try_edit`"},
      {"cancel",
       {{"request", NumberShape(), true,
         "`seq` of an `analyze`, `try_edit` or `edit` of this client"}},
       {},
       "the request fails immediately and writes nothing, unless it is already done",
       true},
  };
}

/// Returns what the page offers to choose from.
std::vector<JsonMember> ChoiceMembers() {
  return {{"folder", TextShape(), true, "of the recordings, as the program knows it"},
          {"levels", TextsShape()},
          {"variations", JsonShape::List(VariationShape())},
          {"formats", TextsShape()},
          {"cameras", TextsShape()},
          {"rates", NumbersShape()},
          {"max_count", NumberShape()},
          {"max_jobs", NumberShape()}};
}

RequestForm JobsForm() {
  std::vector<JsonMember> answer{{"jobs", JsonShape::List(JobShape())}};
  for (JsonMember& choice : ChoiceMembers()) answer.push_back(std::move(choice));
  return {
      "jobs", {}, std::move(answer), "the jobs, oldest first, and what they may be given", true};
}

RequestForm GenerateForm() {
  return {"generate",
          {{"recording", TextShape(), true, "the demonstration"},
           {"name", TextShape(), true, "of the new set"},
           {"scene", TextShape()},
           {"brain", TextShape()},
           {"count", NumberShape(), true, "wanted episodes"},
           {"level", TextShape()},
           {"seed", NumberShape()},
           {"jobs", NumberShape(), true, "runs at a time"},
           {"variations", JsonShape::Map(TextShape()), kOptional,
            "what differs between attempts: a degree of each kind, as `jobs` lists them"}},
          {{"job", NumberShape()}},
          "starts `smile generate` (docs/generation.md) as soon as no other job runs; makes "
          "`generated/NAME` in the folder of the recordings"};
}

RequestForm ExportForm() {
  return {
      "export",
      {{"recording", TextShape(), kOptional, "a recording"},
       {"set", TextShape(), kOptional, "or a generated set"},
       {"name", TextShape(), true, "of the new dataset"},
       {"format", TextShape()},
       {"cameras", TextsShape(), true, "none: without pictures"},
       {"width", NumberShape()},
       {"height", NumberShape(), true, "of the pictures, in pixels"},
       {"rate", NumberShape(), true, "frames per second"},
       {"include_failed", FlagShape(), kOptional},
       {"drop_constant", FlagShape(), kOptional, "without joints that never move"}},
      {{"job", NumberShape()}},
      "starts `smile export` and `smile doctor` (docs/datasets.md) as soon as no other job runs; "
      "makes `datasets/NAME` in the folder of the recordings"};
}

RequestForm FilmForm() {
  return {"film",
          {{"recording", TextShape()},
           {"name", TextShape(), true, "of the new film"},
           {"camera", TextShape(), true, "one of those that `jobs` lists"},
           {"width", NumberShape()},
           {"height", NumberShape(), true, "of the pictures, in pixels"},
           {"rate", NumberShape(), true, "frames per second"}},
          {{"job", NumberShape()}},
          "starts `smile render` as soon as no other job runs; makes `films/NAME.mp4` in the "
          "folder of the recordings, which is served at that path"};
}

/// Requests about generated sets, datasets, films and the jobs that make them.
std::vector<RequestForm> DatasetRequests() {
  const JsonMember set{"set", TextShape()};
  return {
      JobsForm(),
      GenerateForm(),
      {"continue_set",
       {set},
       {{"job", NumberShape()}},
       "continues a set that `generate` began; what is there is kept"},
      ExportForm(),
      FilmForm(),
      {"stop_job", {{"job", NumberShape()}}, {}, "what is done is kept"},
      {"rename_set", {set, {"name", TextShape()}}, {}, "while no job uses it"},
      {"bin_set", {set}, {set}, "moves it into a bin, while no job uses it; nothing is deleted"},
      {"unbin_set", {set}, {set}, "moves it out of the bin"},
      {"sets",
       {},
       {{"sets", JsonShape::List(GeneratedSetShape())}},
       "200 generated sets at most, newest first, then those in the bin",
       true},
      {"open_set",
       {set},
       {{"set", GeneratedSetShape()}, {"attempts", JsonShape::List(SetAttemptShape())}},
       "the first 5000 attempts, by seed; their recordings can be opened and shown, and "
       "changed by no request",
       true}};
}

/// Requests about links to single recordings.
std::vector<RequestForm> SharingRequests() {
  const JsonMember recording{"recording", TextShape()};
  return {
      {"share",
       {recording},
       {{"link", ShareLinkShape()}},
       "makes a new secret link to this recording, see below"},
      {"share_links",
       {recording},
       {{"links", JsonShape::List(ShareLinkShape())},
        {"origin", TextShape(), true, "a link is `ORIGIN/shared/SECRET`"},
        {"is_local", FlagShape(), true, "links work on this machine only"}},
       "the links of this recording, oldest first"},
      {"stop_sharing", {recording, {"secret", TextShape()}}, {}, "ends a link for good"},
  };
}

/// Requests that show a recording in place of the live world.
std::vector<RequestForm> PlaybackRequests() {
  const JsonMember recording{"recording", TextShape()};
  return {
      {"show",
       {recording, {"seconds", NumberShape(), kOptional}},
       {{"length", NumberShape()}},
       "shows this moment of the recording; nothing can be grasped (`mode` is `playback`). Refused "
       "while recording"},
      {"play",
       {{"rate", NumberShape(), kOptional}},
       {},
       "continues playback from the present moment; `rate` 0 stops it"},
      {"live", {}, {}, "returns from playback to the unchanged world"},
      {"branch",
       {recording, {"step", NumberShape()}, {"after", NumberShape(), kOptional}},
       {recording},
       "continues the recording from this moment of its history (docs/editing.md). Refused while "
       "recording. Until the answer, the present world continues, but nothing else can be recorded "
       "or loaded"},
      {"record_over",
       {recording,
        {"hands", JsonShape::List(HandNameShape()), true, "whose actions are done again"},
        {"seconds", NumberShape(), true, "from here on; before, all actions are done again"}},
       {recording},
       "records a new demonstration over this one, from this moment on: what these hands and no "
       "hand did happens again at its time (`over` in `recording` of a state message). Time is "
       "paused then. Refused like `branch`"},
      {"correct",
       {recording, {"seconds", NumberShape(), true, "from here on; before, all is done again"}},
       {recording},
       "records a correction of this recording: it is the same up to this moment, from which the "
       "user, or a brain, does something else (`corrects` in `recording` of a state message). Time "
       "is paused then. Refused like `branch`"},
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
       "brains that can be started; `kind` is `octave`, `python` or `program`; `imitates`: it "
       "reads demonstrations (docs/brains.md)",
       true},
      {"start_brain",
       {{"brain", TextShape()},
        {"demonstration", TextShape(), kOptional, "a recording"},
        {"scene", TextShape(), kOptional}},
       {},
       "loads the scene if one is given, and starts the brain. Answered when the start begins; "
       "later errors are in `status` and on the console"},
      {"stop_brain", {}, {}, "stops the brain immediately, also while it starts or computes"},
      {"imitate",
       {{"recording", TextShape()}, {"brain", TextShape()}, {"scene", TextShape()}},
       {{"recording", TextShape()}},
       "starts a brain with `imitates` that watches the recording and imitates it in the scene; "
       "returns the recording of the imitation. When the brain ends, the recording ends, and "
       "`{\"t\":\"score\",...}` is sent"},
  };
}

}  // namespace

std::vector<RequestForm> MakeRequestForms() {
  std::vector<RequestForm> all;
  for (const auto& forms :
       {ConnectionRequests(), WorldRequests(), SceneRequests(), LibraryRequests(),
        DatasetRequests(), SharingRequests(), PlaybackRequests(), BrainRequests()}) {
    all.insert(all.end(), forms.begin(), forms.end());
  }
  return all;
}

}  // namespace smile::page

#include "page/page_protocol.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "demonstrator/hand.h"
#include "page/snap_names.h"
#include "robot/mood.h"

namespace smile::page {
namespace {

/// A type of the page's, with what it is for.
struct NamedShape {
  JsonShape shape;
  std::string meaning = "";
};

constexpr bool kOptional = false;

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

JsonShape MoodShape() {
  return JsonShape::Word({robot::kMoodNames.begin(), robot::kMoodNames.end()}).Called("Mood");
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

JsonShape DeedShape() {
  return ObjectShape({{"do", JsonShape::Word({"take", "put", "drop", "release", "destroy", "point",
                                              "trigger", "fasten", "loosen"})},
                      {"hand", HandNameShape()},
                      {"what", TextShape()},
                      {"on", TextShape(), kOptional, "id of what is beneath, empty for the table"},
                      {"into", TextShape(), kOptional},
                      {"words", TextShape(), true, "all of it, for people"}})
      .Called("Deed");
}

JsonShape SegmentShape() {
  return ObjectShape({{"number", NumberShape()},
                      {"deed", DeedShape().OrNull(), true, "what began it; null of the first"},
                      {"seconds", NumberShape()}})
      .Called("Segment");
}

JsonShape TimelineShape() {
  const JsonShape segment = ObjectShape({{"number", NumberShape()},
                                         {"deed", DeedShape().OrNull()},
                                         {"begin", NumberShape()},
                                         {"end", NumberShape()}});
  const JsonShape step = ObjectShape({{"step", NumberShape()},
                                      {"parent", NumberShape().OrNull()},
                                      {"deed", DeedShape().OrNull()},
                                      {"begin", NumberShape()},
                                      {"end", NumberShape()},
                                      {"on_way", FlagShape()}});
  return ObjectShape({{"segments", JsonShape::List(segment)},
                      {"steps", JsonShape::List(step)},
                      {"seconds", NumberShape()}})
      .Called("Timeline");
}

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

JsonShape SceneNewsShape() {
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

JsonShape HandsNowShape() {
  std::vector<JsonMember> hands;
  for (const auto hand : demonstrator::kHandNames) {
    hands.push_back({std::string(ToString(hand)), HandShape()});
  }
  return ObjectShape(hands);
}

JsonShape RobotNowShape() {
  return ObjectShape({{"shown", FlagShape()},
                      {"mood", MoodShape()},
                      {"following", FlagShape()},
                      {"joints", JsonShape::Map(NumberShape())},
                      {"grippers", NumbersShape()},
                      {"head", NumberShape()}});
}

JsonShape BrainNowShape() {
  return ObjectShape(
      {{"name", TextShape()},
       {"status", JsonShape::Word({"none", "starting", "running", "exited", "failed", "stopped"})},
       {"message", TextShape()},
       {"file", TextShape()},
       {"line", NumberShape()}});
}

JsonShape StateNewsShape() {
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
  return ObjectShape(
             {KindMember("state"),
              {"tick", NumberShape()},
              {"mode", JsonShape::Word({"live", "playback", "rage"})},
              {"paused", FlagShape()},
              {"speed", NumberShape(), true, "simulated per real second, over the last one"},
              {"hands", HandsNowShape()},
              {"undo", FlagShape()},
              {"redo", FlagShape()},
              {"still", FlagShape()},
              {"recording", recording.OrNull()},
              {"playback", playback.OrNull()},
              {"failure", failure.OrNull(), true, "the last recording ended by itself"},
              {"controls", JsonShape::Map(TextShape()), true,
               "states as recordings have them; of a switch its position"},
              {"pressed", TextsShape(), true, "buttons of switches that are down"},
              {"gone", TextsShape()},
              {"fallen", TextsShape(), true, "on the floor, out of play"},
              {"attention", JsonShape::Map(TextsShape())},
              {"robot", RobotNowShape().OrNull()},
              {"brain", BrainNowShape()},
              {"snap", JsonShape::List(SnapNameShape())},
              {"markers", JsonShape::List(PointShape())}})
      .Called("StateMessage");
}

JsonShape EventNewsShape() {
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
                      {"properties", TextsShape(), kOptional}})
      .Called("EventMessage");
}

std::vector<NewsForm> MakeNewsForms() {
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
      {"scene", SceneNewsShape(), "see below"},
      {"looks",
       ObjectShape({KindMember("looks"), {"looks", NumbersShape()}}).Called("LooksMessage"),
       "one number per choice"},
      {"state", StateNewsShape(), "see below; at most 20 a second"},
      {"event", EventNewsShape(), "as docs/recording-format.md has them"},
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
       "recordings came or went: ask for `library` again"},
      {"error", ObjectShape({KindMember("error"), {"error", TextShape()}}).Called("ErrorMessage"),
       "something went wrong that was nobody's request, for example the eye cannot draw"},
  };
}

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
       "asks at most once in 10 s. By force it is taken from a controller whom this client has "
       "asked, and who has asked for nothing (but pings) for 30 s since; else the request asks, or "
       "fails and reports how long it takes",
       true},
      {"keep_control",
       {{"from", NumberShape(), true, "a client who asked"}},
       {},
       "that client is sent `control_kept`"},
      {"give_control", {{"to", NumberShape().OrNull(), kOptional, "client or null"}}, {}, ""},
  };
}

std::vector<RequestForm> WorldRequests() {
  return {
      {"command",
       {{"command", JsonShape::Anything().Called("Command"), true,
         "as docs/commands.md has it, or `drag`"},
        {"exact", FlagShape(), kOptional, "it does not snap"}},
       {{"recording", TextShape(), kOptional}},
       "`recording` of `start`"},
      {"pause", {}, {}, "time stands still; commands are still carried out"},
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
       "puts new objects at free places and tells their ids; refused while recording"},
      {"clear",
       {{"rage", FlagShape(), kOptional}},
       {},
       "takes away all that no hand holds; with rage the robot does it, and after 10 s all is as "
       "before; refused while recording"},
  };
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
       "writes the edited demonstration as a new recording with this title"},
  };
}

std::vector<RequestForm> PlaybackRequests() {
  const JsonMember recording{"recording", TextShape()};
  return {
      {"show",
       {recording, {"seconds", NumberShape(), kOptional}},
       {{"length", NumberShape()}},
       "the world shows this moment of it, and nothing can be grasped (`mode` is `playback`)"},
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

std::vector<RequestForm> MakeRequestForms() {
  std::vector<RequestForm> all;
  for (const auto& forms : {ConnectionRequests(), WorldRequests(), SceneRequests(),
                            LibraryRequests(), PlaybackRequests(), BrainRequests()}) {
    all.insert(all.end(), forms.begin(), forms.end());
  }
  return all;
}

const RequestForm* FindRequest(const std::string& name) {
  const auto found = std::ranges::find(RequestForms(), name, &RequestForm::name);
  return found != RequestForms().end() ? &*found : nullptr;
}

/// A reply to a request, the `answer` of which only comes where it is carried out.
std::string MisfitOfReply(const Json& reply, const std::string& request) {
  std::vector<JsonMember> members = {
      KindMember("reply"), {"seq", NumberShape()}, {"ok", FlagShape()}};
  const RequestForm* form = FindRequest(request);
  if (reply.value("ok", false)) {
    if (form == nullptr) return "there is no request " + request;
    members.insert(members.end(), form->answer.begin(), form->answer.end());
  } else {
    members.push_back({"error", TextShape()});
    members.push_back({"diagnostics", JsonShape::List(DiagnosticShape()), kOptional});
  }
  std::string misfit;
  ObjectShape(members).Fits(reply, &misfit);
  return misfit;
}

/// `` `factor`: 0.1 to 4, `exact`? ``
std::string NamesIn(const std::vector<JsonMember>& members) {
  std::string text;
  bool has_meaning = false;
  for (const JsonMember& member : members) {
    if (member.name == "t") continue;
    if (!text.empty()) text += has_meaning ? "; " : ", ";
    text += "`" + member.name + (member.is_required ? "`" : "`?");
    has_meaning = !member.meaning.empty();
    if (has_meaning) text += ": " + member.meaning;
  }
  return text;
}

std::string TableCell(const std::string& text) { return text.empty() ? " |" : " " + text + " |"; }

/// What the page's types are made of, and what has a name of its own.
std::vector<NamedShape> NamedShapes() {
  return {{HandNameShape()},
          {MoodShape()},
          {SnapNameShape()},
          {PointShape()},
          {PoseShape(), "x, y, z, then the quaternion x, y, z, w."},
          {VisualShape()},
          {SceneObjectShape()},
          {RobotDescriptionShape()},
          {HandShape()},
          {DeedShape(),
           "What a hand did; `on` and `into` tell what is beneath what was put or dropped."},
          {SegmentShape()},
          {TimelineShape(), "All times from the start [s]."},
          {LibraryEntryShape()},
          {DiagnosticShape()},
          {ConsoleLineShape()}};
}

}  // namespace

const std::vector<RequestForm>& RequestForms() {
  static const std::vector<RequestForm> kForms = MakeRequestForms();
  return kForms;
}

const std::vector<NewsForm>& NewsForms() {
  static const std::vector<NewsForm> kForms = MakeNewsForms();
  return kForms;
}

std::string MisfitOf(const Json& message, const std::string& request) {
  const std::string kind = message.value("t", "");
  if (kind == "reply") return MisfitOfReply(message, request);
  const auto form = std::ranges::find(NewsForms(), kind, &NewsForm::name);
  if (form == NewsForms().end()) return "there is no message \"" + kind + "\"";
  std::string misfit;
  form->shape.Fits(message, &misfit);
  return misfit;
}

std::string MisfitOfRequest(const Json& request) {
  const RequestForm* form = FindRequest(request.value("do", ""));
  if (form == nullptr) return "there is no such request";
  std::vector<JsonMember> members = {{"do", TextShape()}, {"seq", NumberShape(), kOptional}};
  members.insert(members.end(), form->fields.begin(), form->fields.end());
  std::string misfit;
  ObjectShape(members).Fits(request, &misfit);
  return misfit;
}

std::string RequestMarkdown() {
  std::string text = "| `do` | fields | answered with | |\n|---|---|---|---|\n";
  for (const RequestForm& form : RequestForms()) {
    const char* who = !form.is_for_anyone ? "" : form.remark.empty() ? "*anyone*" : "*anyone*; ";
    text += "|" + TableCell("`" + form.name + "`") + TableCell(NamesIn(form.fields)) +
            TableCell(NamesIn(form.answer)) + TableCell(who + form.remark) + "\n";
  }
  return text;
}

std::string NewsMarkdown() {
  std::string text = "| `t` | fields | |\n|---|---|---|\n";
  for (const NewsForm& form : NewsForms()) {
    text += "|" + TableCell("`" + form.name + "`") + TableCell(NamesIn(form.shape.members())) +
            TableCell(form.remark) + "\n";
  }
  return text;
}

std::string ProtocolTypeScript() {
  std::string text =
      "// Made by tools/generate.py from the program's tables: change src/page/page_protocol.cc\n"
      "// instead.\n\nimport type { Command } from \"./commands\";\n";
  for (const NamedShape& named : NamedShapes()) {
    text += "\n" + named.shape.TypeScriptDefinition(named.meaning);
  }
  std::string names;
  for (const NewsForm& form : NewsForms()) {
    text += "\n" + form.shape.TypeScriptDefinition();
    names += "\n  | " + form.shape.TypeScript();
  }
  text +=
      "\n/** What is told without being asked for. */\nexport type UnaskedNews =" + names + ";\n";
  text +=
      "\n/** What may be asked for, and what is answered beside `ok`. */\n"
      "export interface Requests {\n";
  const auto type_of = [](const std::vector<JsonMember>& members) {
    return members.empty() ? std::string("object") : ObjectShape(members).TypeScript();
  };
  for (const RequestForm& form : RequestForms()) {
    text += "  " + form.name + ": { fields: " + type_of(form.fields) +
            "; answer: " + type_of(form.answer) + " };\n";
  }
  return text + "}\n";
}

}  // namespace smile::page

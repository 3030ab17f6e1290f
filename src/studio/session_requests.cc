// What a session can be asked for.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "experiment/brain_setup.h"
#include "page/snap_names.h"
#include "picture/rendered_eye.h"
#include "recording/recording_history.h"
#include "recording/recording_names.h"
#include "sim/command_json.h"
#include "studio/internal_session.h"
#include "studio/present_scene.h"
#include "studio/presets.h"
#include "studio/scene_message.h"

namespace smile::studio {
namespace {

constexpr double kMaxSeconds = 1e6;

Json DescribeFindings(const std::vector<Diagnostic>& findings) {
  Json described = Json::array();
  for (const Diagnostic& finding : findings) {
    described.push_back({{"file", finding.file},
                         {"line", finding.line},
                         {"element", finding.element},
                         {"message", finding.message}});
  }
  return described;
}

sim::HandName HandOf(const page::RequestFields& fields) {
  constexpr std::array<std::string_view, 4> kHands = {"left", "right", "both", "any"};
  // One of them, or it has thrown.
  return demonstrator::ParseHandName(fields.Word("hand", kHands)).value_or(sim::HandName::kAny);
}

struct BranchPoint {
  std::size_t step = 0;         ///< of the recording's history
  std::optional<double> after;  ///< its beginning [s]; nullopt for its end
};

/// True while a held object, or another one, has not yet come to where it stays.
bool IsAnythingMoving(const sim::Simulation& simulation, sim::HandName hand) {
  constexpr double kSlow = 1e-7, kSlowTurn = 1e-6;  // [m/s, rad/s]
  const physics::BodyId held = simulation.demonstrator().hand(hand).held;
  if (!held) return false;
  const physics::Body& body = simulation.physics().body(held);
  return body.linear_velocity().norm() > kSlow || body.angular_velocity().norm() > kSlowTurn ||
         !simulation.is_still();
}

/// A world that goes on with a recording, made in any thread: the desk's eye, which belongs to
/// another, is put in only at last, and pictures on the way there are taken with one like it.
std::unique_ptr<LiveWorld> GoOnWith(const std::filesystem::path& directory, const BranchPoint& from,
                                    const recorder::RecordingDesk::Options& desk,
                                    const recording::Progress& progress) {
  const recording::Recording recording = recording::OpenRecording(directory);
  const recording::Moment moment =
      recording::MomentOf(recording, recording::HistoryOf(recording), from.step, from.after);
  recorder::RecordingDesk::Options options = desk;
  std::optional<picture::RenderedEye> eye;
  if (desk.eye != nullptr) options.eye = &eye.emplace(desk.eye->spec());
  auto world = std::make_unique<LiveWorld>(recording.scene, recording.robot, options);
  world->Continue(recording, moment, progress);
  if (EyeTap* tap = world->eye()) tap->SetEye(desk.eye);
  return world;
}

}  // namespace

void Session::Impl::RequireLive() const {
  if (playback_) throw page::RequestError("a recording is shown: go back to the live world first");
  if (rage_) throw page::RequestError("the robot clears the table: wait until it is over");
}

void Session::Impl::RequireNoBranching() const {
  if (is_branching_) {
    throw page::RequestError(
        "the world goes back to a moment of a recording: wait until it is there");
  }
}

void Session::Impl::RequireNoRecording() const {
  RequireNoBranching();
  if (world_->is_recording()) {
    throw page::RequestError("a recording is in the making: finish it first");
  }
}

void Session::Impl::RequireIdleRobot() const {
  if (!options_.robot) throw page::RequestError("there is no robot");
  if (brain_.is_running()) throw page::RequestError("a robot program is running: stop it first");
}

void Session::Impl::AddRequests() {
  AddWorldRequests();
  AddSceneRequests();
  AddRecordingRequests();
  AddBrainRequests();
}

void Session::Impl::AddWorldRequests() {
  auto& entries = requests_.entries;
  entries["command"] = {[this](const page::Request& request) { return Command(request); }};
  entries["pause"] = {[this](const page::Request&) {
    is_paused_ = true;
    return Json::object();
  }};
  entries["resume"] = {[this](const page::Request&) {
    is_paused_ = false;
    return Json::object();
  }};
  entries["speed"] = {[this](const page::Request& request) {
    speed_factor_ = page::RequestFields(request).Number("factor", 0.1, 4);
    return Json::object();
  }};
  entries["snap"] = {[this](const page::Request& request) {
    snapper_.to = SnapToOf(page::RequestFields(request).Words("to", page::kSnapNames));
    return Json::object();
  }};
  entries["support"] = {
      [this](const page::Request& request) { return FindSupport(page::RequestFields(request)); }};
  entries["resting_place"] = {[this](const page::Request& request) {
    return FindRestingPlace(page::RequestFields(request));
  }};
}

void Session::Impl::AddSceneRequests() {
  auto& entries = requests_.entries;
  entries["load"] = {
      [this](const page::Request& request) { return Load(page::RequestFields(request)); }};
  entries["reload"] = {[this](const page::Request&) {
    RequireNoRecording();
    Enter(MakeWorld(loaded_, options_.robot));
    return Json::object();
  }};
  entries["check"] = {
      [this](const page::Request& request) { return Check(page::RequestFields(request)); },
      /*is_for_anyone=*/true};
  entries["spawn"] = {
      [this](const page::Request& request) { return Spawn(page::RequestFields(request)); }};
  entries["clear"] = {
      [this](const page::Request& request) { return Clear(page::RequestFields(request)); }};
}

void Session::Impl::AddRecordingRequests() {
  auto& entries = requests_.entries;
  entries["show"] = {
      [this](const page::Request& request) { return Show(page::RequestFields(request)); }};
  entries["play"] = {[this](const page::Request& request) {
    const double rate = page::RequestFields(request)
                            .OptionalNumber("rate", 0, library::Playback::kMaxRate)
                            .value_or(1);
    if (!playback_) throw page::RequestError("no recording is shown");
    playback_->SetRate(rate);
    return Json::object();
  }};
  entries["live"] = {[this](const page::Request&) {
    if (!playback_) throw page::RequestError("no recording is shown");
    view_.reset();
    playback_.reset();
    TellAllOfScene();
    return Json::object();
  }};
  entries["branch"] = {[this](const page::Request& request) { return Branch(request); }};
}

void Session::Impl::AddBrainRequests() {
  auto& entries = requests_.entries;
  entries["brains"] = {[this](const page::Request&) { return DescribeBrains(); },
                       /*is_for_anyone=*/true};
  entries["start_brain"] = {
      [this](const page::Request& request) { return StartBrain(page::RequestFields(request)); }};
  entries["stop_brain"] = {[this](const page::Request&) {
    if (!brain_.is_running()) throw page::RequestError("no robot program is running");
    brain_.Stop(&world_->simulation());
    EndImitation();
    return Json::object();
  }};
  entries["imitate"] = {
      [this](const page::Request& request) { return Imitate(page::RequestFields(request)); }};
}

Json Session::Impl::Command(const page::Request& request) {
  RequireLive();
  const page::RequestFields fields(request);
  const sim::Command command = MeantBy(fields.Object("command"), fields.Flag("exact"));
  const bool turns_back =
      std::holds_alternative<sim::Undo>(command) || std::holds_alternative<sim::Redo>(command);
  if (turns_back && brain_.is_running()) {
    throw page::RequestError(
        "a robot program is running and cannot turn back in time: stop it first");
  }
  const bool is_start = std::holds_alternative<sim::StartRecording>(command);
  if (is_start) RequireNoBranching();
  view_.reset();
  if (const auto refusal = world_->Apply(command)) throw page::RequestError(*refusal);
  Json answer = Json::object();
  if (is_start) {
    answer["recording"] = world_->recording_directory().filename().string();
  }
  return answer;
}

sim::Command Session::Impl::MeantBy(const Json& wanted, bool is_exact) {
  const double meters_per_unit = world_->simulation().scene().meters_per_unit;
  if (!sim::IsDrag(wanted)) {
    const sim::Command command = sim::ParseCommand(wanted, meters_per_unit);
    return is_exact ? command : snapper_.Snapped(*world_, command);
  }
  const sim::Drag drag = sim::ParseDrag(wanted, meters_per_unit);
  sim::Refusal refusal;
  const auto move = sim::MoveOf(drag, world_->simulation(), &refusal);
  if (!move) throw page::RequestError(refusal);
  return is_exact ? *move : snapper_.Snapped(*world_, drag, *move);
}

Json Session::Impl::Load(const page::RequestFields& fields) {
  RequireNoRecording();
  scene::SceneSpec scene = ReadSceneOf(fields);
  auto world = MakeWorld(scene, options_.robot);
  loaded_ = std::move(scene);
  Enter(std::move(world));
  return Json::object();
}

Json Session::Impl::Check(const page::RequestFields& fields) const {
  return {{"diagnostics", DescribeFindings(ReadText(fields).diagnostics)}};
}

Json Session::Impl::Spawn(const page::RequestFields& fields) {
  RequireLive();
  RequireNoRecording();
  const std::string preset = fields.Text("preset");
  const auto seed = fields.Whole("seed", std::uint64_t{1} << 53);
  const std::set<std::string> before = IdsOf(world_->simulation().scene());
  Enter(WorldWith(preset, seed));
  Json added = Json::array();
  for (const scene::ObjectSpec& object : world_->simulation().scene().objects) {
    if (!before.contains(object.id())) added.push_back(object.id());
  }
  return {{"objects", std::move(added)}};
}

Json Session::Impl::Clear(const page::RequestFields& fields) {
  const bool with_rage = fields.Flag("rage");
  RequireLive();
  RequireNoRecording();
  view_.reset();
  if (with_rage) {
    rage_ = std::make_unique<Rage>(world_->simulation());
    return Json::object();
  }
  const sim::Simulation& simulation = world_->simulation();
  std::set<std::string> kept;
  for (const sim::HandName name : demonstrator::kHandNames) {
    const physics::BodyId held = simulation.demonstrator().hand(name).held;
    if (!held) continue;
    for (const physics::BodyId body : simulation.physics().Assembly(held)) {
      if (const world::Object* object = simulation.tabletop().Find(body)) {
        kept.insert(object->id());
      }
    }
  }
  Recompose(Without(PresentScene(simulation), [&kept](const scene::ObjectSpec& object) {
    return !kept.contains(object.id());
  }));
  return Json::object();
}

Json Session::Impl::FindSupport(const page::RequestFields& fields) {
  RequireLive();
  const sim::Simulation& simulation = world_->simulation();
  const std::string id = fields.Text("object");
  const auto object = simulation.model().FindObject(id);
  if (!object) throw page::RequestError("there is no object " + Quoted(id));
  const auto support = simulation.SupportOf(*object);
  if (!support || !support->is_near()) return Json::object();
  return {{support->is_inside ? "into" : "on", support->object}};
}

Json Session::Impl::FindRestingPlace(const page::RequestFields& fields) {
  // So long as this, and a sixth of what the last one took, none is found anew.
  constexpr std::uint64_t kMinCallsBetween = 20;
  const std::uint64_t calls_between = std::max(kMinCallsBetween, resting_place_.ticks_tried() / 6);
  const sim::HandName hand = HandOf(fields);
  RequireLive();
  const sim::Simulation& simulation = world_->simulation();
  const bool is_fresh = num_calls_ < resting_call_ + calls_between;
  if (is_fresh && resting_answer_["hand"] == ToString(hand)) {
    if (simulation.tick() != resting_tick_) resting_answer_["stale"] = true;
    return resting_answer_;
  }
  const auto X_WB = resting_place_.Find(simulation, hand);
  resting_call_ = num_calls_;
  resting_tick_ = simulation.tick();
  // Where things fall on edges, the last hundredth of a millimeter decides.
  resting_answer_ = {
      {"hand", ToString(hand)}, {"pose", nullptr}, {"stale", IsAnythingMoving(simulation, hand)}};
  if (X_WB) {
    resting_answer_["pose"] = PoseInUnits(*X_WB, simulation.scene().meters_per_unit);
  }
  return resting_answer_;
}

Json Session::Impl::Show(const page::RequestFields& fields) {
  const std::string id = fields.Text("recording");
  const double seconds = fields.OptionalNumber("seconds", 0, kMaxSeconds).value_or(0);
  if (rage_) RequireLive();
  const bool is_another = !playback_ || playback_->id() != id;
  if (is_another) {
    auto playback = std::make_unique<library::Playback>(id, library_.DirectoryOf(id));
    view_.reset();
    playback_ = std::move(playback);
  }
  view_.reset();
  playback_->Seek(seconds);
  if (is_another) TellAllOfScene();
  return {{"length", playback_->length()}};
}

Json Session::Impl::Branch(const page::Request& request) {
  const page::RequestFields fields(request);
  const std::string id = fields.Text("recording");
  const BranchPoint from{.step = static_cast<std::size_t>(fields.Whole("step", 1'000'000'000)),
                         .after = fields.OptionalNumber("after", 0, kMaxSeconds)};
  const std::filesystem::path directory = library_.DirectoryOf(id);
  RequireNoRecording();
  // Made in the workshop, entered here. It belongs to both: each may be gone before the other.
  const auto made = std::make_shared<std::unique_ptr<LiveWorld>>();
  const auto work = [made, id, directory, from,
                     desk = DeskOptions()](const recording::Progress& progress) -> Json {
    *made = GoOnWith(directory, from, desk, progress);
    return {{"recording", id}};
  };
  const auto conclude = [this, made] {
    is_branching_ = false;
    if (!*made) return;
    loaded_ = (*made)->simulation().scene();
    Enter(std::move(*made));
  };
  options_.workshop->Begin({.request = request, .work = work, .conclude = conclude});
  is_branching_ = true;
  return page::AnswersLater();
}

std::vector<library::BrainChoice> Session::Impl::Brains() const {
  std::vector<std::filesystem::path> folders = options_.brains;
  for (const char* shipped : {"matlab/examples", "python/examples", "matlab", "python"}) {
    folders.push_back(DataFile(shipped));
  }
  return library::BrainsIn(folders);
}

Json Session::Impl::DescribeBrains() const {
  Json described = Json::array();
  for (const library::BrainChoice& choice : Brains()) {
    described.push_back(
        {{"name", choice.name}, {"kind", choice.kind}, {"imitates", choice.imitates}});
  }
  return {{"brains", std::move(described)}};
}

library::BrainChoice Session::Impl::FindBrain(const std::string& name) const {
  const std::vector<library::BrainChoice> brains = Brains();
  if (const library::BrainChoice* choice = library::BrainNamed(brains, name)) return *choice;
  std::vector<std::string_view> known;
  for (const library::BrainChoice& choice : brains) known.push_back(choice.name);
  throw page::RequestError("\"brain\" is " + Quoted(name) + ", expected " + OneOf(known) +
                           DidYouMean(name, known));
}

void Session::Impl::RunBrain(const library::BrainChoice& choice,
                             const std::filesystem::path& demonstration) {
  brain::BrainDriverOptions options = experiment::DriverOptionsFor(choice.path, demonstration);
  options.eye = options_.eye;
  view_.reset();
  brain_.Start(choice, options, &world_->simulation());
}

Json Session::Impl::StartBrain(const page::RequestFields& fields) {
  const library::BrainChoice choice = FindBrain(fields.Text("brain"));
  const auto demonstration = fields.OptionalText("demonstration");
  const auto scene = fields.OptionalText("scene");
  const std::filesystem::path directory =
      demonstration ? library_.DirectoryOf(*demonstration) : std::filesystem::path();
  RequireIdleRobot();
  if (scene) {
    (void)Load(fields);
  } else {
    RequireLive();
  }
  RunBrain(choice, directory);
  return Json::object();
}

Json Session::Impl::Imitate(const page::RequestFields& fields) {
  const library::BrainChoice choice = FindBrain(fields.Text("brain"));
  if (!choice.imitates) {
    throw page::RequestError(Quoted(choice.name) +
                             " does not read demonstrations: its script lacks the line "
                             "\"smile: imitates\"");
  }
  const std::string scene = fields.Text("scene");
  const std::filesystem::path directory = library_.DirectoryOf(fields.Text("recording"));
  RequireNoRecording();
  RequireIdleRobot();
  const recording::Recording demonstration = recording::OpenRecording(directory);
  Imitation imitation{.exercise = task::MakeExercise(scene, demonstration, ReadNamedScene(scene)),
                      .witness = nullptr};
  auto world = MakeWorld(imitation.exercise.scene, options_.robot);
  loaded_ = imitation.exercise.scene;
  Enter(std::move(world));
  RunBrain(choice, directory);
  imitation.recording = RecordImitation(demonstration);
  imitation.witness = std::make_unique<task::CourseWitness>(&world_->simulation());
  imitation_ = std::move(imitation);
  return {{"recording", imitation_->recording.filename().string()}};
}

std::filesystem::path Session::Impl::RecordImitation(const recording::Recording& demonstration) {
  constexpr std::string_view kEnd = ", imitated";
  std::string title = demonstration.info.title;
  if (title.empty() || title.size() + kEnd.size() > recording::kMaxTitleBytes) {
    title = demonstration.directory.filename().string();
  }
  title += kEnd;
  if (const auto refusal = world_->Apply(
          sim::StartRecording{.name = recording::RecordingNameFor(title), .title = title})) {
    brain_.Stop(&world_->simulation());
    throw page::RequestError("the imitation cannot be recorded: " + *refusal);
  }
  return world_->recording_directory();
}

}  // namespace smile::studio

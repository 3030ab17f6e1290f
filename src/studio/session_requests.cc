// What a session can be asked for, and when.

#include <algorithm>
#include <utility>

#include "base/wording.h"
#include "page/snap_names.h"
#include "sim/add.h"
#include "sim/command_json.h"
#include "studio/internal_session.h"

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

}  // namespace

const std::vector<Session::Impl::RequestRow>& Session::Impl::RequestRows() {
  static const std::vector<RequestRow> kRows = {
      {"allowed", &Impl::Allowed},
      {"command", &Impl::Command, {Need::kCommands}},
      {"pause", &Impl::Pause, {Need::kTime}},
      {"resume", &Impl::Resume, {Need::kTime}},
      {"speed", &Impl::SetSpeed},
      {"snap", &Impl::SetSnap},
      {"support", &Impl::FindSupport, {Need::kCommands}},
      {"resting_place", &Impl::AnswerRestingPlace, {Need::kCommands}},
      {"load", &Impl::Load, {Need::kOtherWorld}},
      {"reload", &Impl::Reload, {Need::kOtherWorld}},
      {"check", &Impl::Check, {}, /*is_for_anyone=*/true},
      {"spawn", &Impl::Spawn, {Need::kCommands}},
      {"clear", &Impl::Clear, {Need::kCommands}, false, &Impl::RefuseClear},
      {"show", &Impl::Show, {Need::kShow}},
      {"play", &Impl::Play, {Need::kPlayback}},
      {"live", &Impl::GoLive, {Need::kPlayback}},
      {"branch", &Impl::Branch, {Need::kOtherWorld}},
      {"brains", &Impl::DescribeBrains, {}, /*is_for_anyone=*/true},
      {"start_brain",
       &Impl::StartBrain,
       {Need::kRobot, Need::kNoProgram},
       false,
       &Impl::RefuseStartBrain},
      {"stop_brain", &Impl::StopBrain, {Need::kProgram}},
      {"imitate", &Impl::Imitate, {Need::kOtherWorld, Need::kRobot, Need::kNoProgram}},
  };
  return kRows;
}

void Session::Impl::AddRequests() {
  for (const RequestRow& row : RequestRows()) {
    page::RequestTable::Entry& entry = requests_.entries[row.what];
    entry.is_for_anyone = row.is_for_anyone;
    entry.handle = [this, &row](const page::Request& request) {
      // It may change what is to be seen.
      view_.reset();
      Json answer = (this->*row.handle)(page::RequestFields(request));
      view_.reset();
      return answer;
    };
    if (row.needs.empty() && row.refuse == nullptr) continue;
    entry.refuse = [this, &row](const page::Request& request) { return RefusalOf(row, request); };
  }
}

std::optional<std::string> Session::Impl::Unmet(Need need) const {
  const auto unless = [](bool is_met, const char* reason) {
    return is_met ? std::nullopt : std::optional<std::string>(reason);
  };
  switch (need) {
    case Need::kPlayback:
      return unless(playback_ != nullptr, "no recording is shown");
    case Need::kRobot:
      return unless(options_.robot.has_value(), "there is no robot");
    case Need::kProgram:
      return unless(brain_.is_running(), "no robot program is running");
    case Need::kNoProgram:
      return unless(!brain_.is_running(), "a robot program is running: stop it first");
    default:
      break;
  }
  const std::initializer_list<const Activity*> all = {playback_.get(), restoring_.get(),
                                                      world_state_.get()};
  for (const Activity* activity : all) {
    if (activity == nullptr) continue;
    if (auto reason = activity->Unmet(need)) return reason;
  }
  return std::nullopt;
}

std::optional<std::string> Session::Impl::FirstUnmet(const Needs& needs) const {
  for (const Need need : needs) {
    if (auto reason = Unmet(need)) return reason;
  }
  return std::nullopt;
}

std::optional<std::string> Session::Impl::RefusalOf(const RequestRow& row,
                                                    const page::Request& request) {
  if (auto reason = FirstUnmet(row.needs)) return reason;
  if (row.refuse == nullptr) return std::nullopt;
  return (this->*row.refuse)(page::RequestFields(request));
}

std::optional<std::string> Session::Impl::RefuseStartBrain(const page::RequestFields& fields) {
  if (!fields.OptionalText("scene")) return Unmet(Need::kCommands);
  return Unmet(Need::kOtherWorld);
}

std::optional<std::string> Session::Impl::RefuseClear(const page::RequestFields& fields) {
  if (!fields.Flag("rage")) return std::nullopt;
  if (auto reason = Unmet(Need::kOtherWorld)) return reason;
  if (Rage::IsPossible(world_->simulation())) return std::nullopt;
  return "there is no robot to clear the table";
}

std::optional<std::string> Session::Impl::RefusalInSession(const sim::Command& command) const {
  const bool turns_back =
      std::holds_alternative<sim::Undo>(command) || std::holds_alternative<sim::Redo>(command);
  if (turns_back && brain_.is_running()) {
    return "a robot program is running and cannot turn back in time: stop it first";
  }
  const bool is_ended_by_restoring = std::holds_alternative<sim::StartRecording>(command) ||
                                     std::holds_alternative<sim::Load>(command);
  return is_ended_by_restoring ? Unmet(Need::kNewRecording) : std::nullopt;
}

std::optional<std::string> Session::Impl::RefusalOf(const sim::Command& command) const {
  if (auto reason = Unmet(Need::kCommands)) return reason;
  if (auto reason = RefusalInSession(command)) return reason;
  return world_->simulation().Refuse(command);
}

Json Session::Impl::DescribeAllowed() const {
  Json commands = Json::object();
  for (const sim::Command& command :
       {sim::Command(sim::StartRecording()), sim::Command(sim::FinishRecording()),
        sim::Command(sim::Undo()), sim::Command(sim::Redo())}) {
    const char* name = std::visit([](const auto& one) { return one.kName.name; }, command);
    commands[name] = page::AllowedUnless(RefusalOf(command));
  }
  return {{"requests", page::AllowedRequests(requests_)}, {"commands", std::move(commands)}};
}

Json Session::Impl::Allowed(const page::RequestFields& fields) {
  constexpr std::size_t kMaxRequests = 16;
  Json allowed = Json::array();
  for (const Json& wanted : fields.List("requests", kMaxRequests)) {
    allowed.push_back(page::AllowedUnless(RefusalOf(wanted)));
  }
  return {{"allowed", std::move(allowed)}};
}

std::optional<std::string> Session::Impl::RefusalOf(const Json& wanted) {
  page::Request request{.fields = wanted};
  const page::RequestFields fields(request);
  request.what = fields.Text("do");
  const auto row = std::ranges::find(RequestRows(), request.what, &RequestRow::what);
  if (row == RequestRows().end()) {
    throw page::RequestError("whether " + Quoted(request.what) + " is allowed is not known");
  }
  if (auto reason = RefusalOf(*row, request)) return reason;
  if (request.what != "command") return std::nullopt;
  const sim::Command command = MeantBy(fields.Object("command"), /*is_exact=*/true);
  if (auto reason = RefusalOf(command)) return reason;
  // Only the world itself has a history and recordings.
  const bool is_of_history = std::holds_alternative<sim::Undo>(command) ||
                             std::holds_alternative<sim::Redo>(command) ||
                             std::holds_alternative<sim::StartRecording>(command) ||
                             std::holds_alternative<sim::FinishRecording>(command);
  return is_of_history ? std::nullopt : rehearsal_.Try(command, world_->simulation());
}

Json Session::Impl::Command(const page::RequestFields& fields) {
  const sim::Command command = MeantBy(fields.Object("command"), fields.Flag("exact"));
  if (const auto refusal = RefusalInSession(command)) throw page::RequestError(*refusal);
  Apply(command);
  if (!std::holds_alternative<sim::StartRecording>(command)) return Json::object();
  return {{"recording", world_->recording_directory().filename().string()}};
}

void Session::Impl::Apply(const sim::Command& command) {
  view_.reset();
  const sim::Simulation& simulation = world_->simulation();
  const std::shared_ptr<const model::Model> model = simulation.shared_model();
  const std::shared_ptr<const model::Model> start_model = simulation.start_model();
  if (const auto refusal = world_->Apply(command)) throw page::RequestError(*refusal);
  if (simulation.start_model() != start_model) {
    BeginScene();
  } else if (simulation.shared_model() != model) {
    TellAllOfScene();
  }
}

sim::Command Session::Impl::MeantBy(const Json& wanted, bool is_exact) {
  const double meters_per_unit = world_->simulation().scene().meters_per_unit;
  if (sim::IsAdd(wanted)) {
    sim::Refusal refusal;
    const auto spawn = sim::SpawnOf(sim::ParseAdd(wanted), world_->simulation(), &refusal);
    if (!spawn) throw page::RequestError(refusal);
    return *spawn;
  }
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

Json Session::Impl::Pause(const page::RequestFields&) {
  is_paused_ = true;
  return Json::object();
}

Json Session::Impl::Resume(const page::RequestFields&) {
  is_paused_ = false;
  return Json::object();
}

Json Session::Impl::SetSpeed(const page::RequestFields& fields) {
  speed_factor_ = fields.Number("factor", 0.1, 4);
  return Json::object();
}

Json Session::Impl::SetSnap(const page::RequestFields& fields) {
  snapper_.to = SnapToOf(fields.Words("to", page::kSnapNames));
  return Json::object();
}

Json Session::Impl::AnswerRestingPlace(const page::RequestFields& fields) {
  return resting_place_.Answer(world_->simulation(), HandOf(fields), num_calls_, &rehearsal_);
}

Json Session::Impl::Load(const page::RequestFields& fields) {
  LoadScene(ReadSceneOf(fields));
  return Json::object();
}

Json Session::Impl::Reload(const page::RequestFields&) {
  LoadScene(world_->simulation().start_model()->scene());
  return Json::object();
}

Json Session::Impl::Check(const page::RequestFields& fields) {
  return {{"diagnostics", DescribeFindings(ReadText(fields).diagnostics)}};
}

Json Session::Impl::FindSupport(const page::RequestFields& fields) {
  const sim::Simulation& simulation = world_->simulation();
  const std::string id = fields.Text("object");
  const auto object = simulation.model().FindObject(id);
  if (!object) throw page::RequestError("there is no object " + Quoted(id));
  const auto support = simulation.SupportOf(*object);
  if (!support || !support->is_near()) return Json::object();
  return {{support->is_inside ? "into" : "on", support->object}};
}

Json Session::Impl::Show(const page::RequestFields& fields) {
  const std::string id = fields.Text("recording");
  const double seconds = fields.OptionalNumber("seconds", 0, kMaxSeconds).value_or(0);
  const bool is_another = !playback_ || playback_->playback().id() != id;
  if (is_another) playback_ = std::make_unique<PlaybackState>(id, library_.DirectoryOf(id));
  library::Playback& playback = playback_->playback();
  playback.Seek(seconds);
  if (is_another) TellAllOfScene();
  return {{"length", playback.length()}};
}

Json Session::Impl::Play(const page::RequestFields& fields) {
  const double rate = fields.OptionalNumber("rate", 0, library::Playback::kMaxRate).value_or(1);
  playback_->playback().SetRate(rate);
  return Json::object();
}

Json Session::Impl::GoLive(const page::RequestFields&) {
  playback_.reset();
  TellAllOfScene();
  return Json::object();
}

Json Session::Impl::Branch(const page::RequestFields& fields) {
  const std::string id = fields.Text("recording");
  const BranchPoint from{.step = static_cast<std::size_t>(fields.Whole("step", 1'000'000'000)),
                         .after = fields.OptionalNumber("after", 0, kMaxSeconds)};
  // It belongs to the session and to the workshop: each may be gone before the other.
  const auto restoring =
      std::make_shared<Restoring>(id, library_.DirectoryOf(id), from, DeskOptions());
  const auto work = [restoring](const recording::Progress& progress) -> Json {
    restoring->Make(progress);
    return {{"recording", restoring->recording()}};
  };
  const auto conclude = [this] {
    std::unique_ptr<LiveWorld> made = std::exchange(restoring_, nullptr)->TakeWorld();
    if (!made) return;
    Enter(std::move(made));
  };
  options_.workshop->Begin({.request = fields.request(), .work = work, .conclude = conclude});
  restoring_ = restoring;
  return page::AnswersLater();
}

}  // namespace smile::studio

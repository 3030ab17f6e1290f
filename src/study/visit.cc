// A trial is a small state machine in Update(): it waits for room, its session starts, it runs, it
// ends. Each change is an event in the log before the page hears of it, so a killed server
// continues from the log alone.

#include "study/visit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "recording/recording.h"
#include "study/measures.h"
#include "study/step_message.h"
#include "web_server/digest.h"

namespace smile::study {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

constexpr seconds kStartTime{30};     ///< for a session to serve
constexpr seconds kAwayTime{60};      ///< without a page, after which a trial is interrupted
constexpr seconds kFarewell{10};      ///< for a session to finish its recording
constexpr double kGraceSeconds = 15;  ///< after the limit, for the page to finish by itself
constexpr seconds kBetweenMeasuring{2};
constexpr std::uint64_t kMaxInputBytes = 16 << 20;
constexpr std::size_t kMaxInputLines = 500, kMaxInputLineBytes = 400;
constexpr std::size_t kCodeDigits = 8;

double SecondsSince(Visit::Clock::time_point when) {
  return std::chrono::duration<double>(Visit::Clock::now() - when).count();
}

/// Returns the size of all files in a folder [bytes].
std::uint64_t SizeOf(const fs::path& folder) {
  std::uint64_t size = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    // A file may disappear meanwhile, as temporary ones do.
    std::error_code gone;
    if (!entry->is_regular_file(gone)) continue;
    const std::uintmax_t bytes = entry->file_size(gone);
    if (!gone) size += bytes;
  }
  return size;
}

/// Returns the name of the recording in a trial's folder, the last one if there are several; empty
/// if there is none.
std::string RecordingIn(const fs::path& folder) {
  std::string found;
  fs::file_time_type latest;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || !recording::IsRecording(entry.path())) continue;
    const auto time = fs::last_write_time(entry.path());
    if (!found.empty() && time <= latest) continue;
    found = name;
    latest = time;
  }
  return found;
}

std::string TextIn(const Json& message, const char* name) {
  if (message.contains(name) && message[name].is_string()) return message[name].get<std::string>();
  throw std::invalid_argument("message: expected the member \"" + std::string(name) + "\", a text");
}

/// Returns a line of the log of mouse and keys, if it is one.
std::string InputLine(const Json& line) {
  const bool is_line = line.is_object() && line.contains("ms") && line["ms"].is_number() &&
                       line.contains("kind") && line["kind"].is_string();
  std::string text = ToText(line);
  if (is_line && text.size() <= kMaxInputLineBytes) return text + "\n";
  throw std::invalid_argument("log: expected short lines with \"ms\" and \"kind\"");
}

}  // namespace

Visit::Visit(const Definition* study, Participant participant, const VisitServices* services)
    : study_(study),
      participant_(std::move(participant)),
      services_(services),
      steps_(StepsOf(*study, participant_.number)),
      log_(participant_.events_file()),
      progress_(ProgressOf(log_.events(), participant_.events_file().string())) {
  if (!progress_.trials.empty() && !progress_.trials.back().has_ended) {
    Log("trial_end", {{"step", progress_.trials.back().step}, {"reason", "server"}});
  }
}

void Visit::Log(const std::string& event, const Json& fields) {
  study::Add(log_.Add(event, fields), &progress_);
}

void Visit::Enter(PageId page) {
  if (page_) services_->send(*page_, {{"t", "replaced"}});
  page_ = page;
  Log("opened", Json::object());
  ShowStep();
}

void Visit::Leave(PageId page) {
  if (page_ != page) return;
  page_.reset();
  left_ = Clock::now();
  Log("closed", Json::object());
}

void Visit::ShowStep() {
  const Step& now = step();
  if (now.kind == StepKind::kThanks && progress_.completion_code.empty()) {
    std::string code = web_server::Sha256(participant_.token).substr(0, kCodeDigits);
    for (char& digit : code)
      digit = static_cast<char>(std::toupper(static_cast<unsigned char>(digit)));
    Log("code", {{"code", code}});
    Log("done", {{"step", now.name}});
  }
  if (std::exchange(shown_step_, now.name) != now.name) {
    shown_ = Clock::now();
    Log("begin", {{"step", now.name}});
  }
  if (!page_) return;
  Json message = StepMessage(*study_, steps_, now, progress_);
  if (now.kind == StepKind::kBreak) {
    message["content"]["seconds"] = std::max(0.0, study_->break_seconds - SecondsSince(shown_));
  }
  services_->send(*page_, message);
  if (running_ && running_->began && running_->reason.empty()) {
    services_->send(*page_, {{"t", "session"}, {"left", SecondsLeft()}});
  }
}

void Visit::Receive(const Json& message) {
  const std::string what = TextIn(message, "do");
  if (what == "consent") return TakeConsent(message);
  if (what == "done") return TakeDone(message);
  if (what == "answers") return TakeAnswers(message);
  if (what == "trial_begin") return BeginTrial(message);
  if (what == "trial_end") return EndTrial(message);
  if (what == "log") return TakeInput(message);
  throw std::invalid_argument("message: there is no " + Quoted(what));
}

void Visit::ExpectStep(const Json& message, StepKind kind) const {
  const std::string name = TextIn(message, "step");
  if (name != step().name || step().kind != kind) {
    throw std::invalid_argument("message: found step " + Quoted(name) + ", expected " +
                                step().name);
  }
}

void Visit::Finish(const Step& done) {
  Log("done", {{"step", done.name}});
  ShowStep();
}

void Visit::TakeConsent(const Json& message) {
  ExpectStep(message, StepKind::kConsent);
  const bool is_agreed = message.contains("agreed") && message["agreed"] == true;
  Log("consent", {{"agreed", is_agreed}, {"sha256", web_server::Sha256(study_->consent)}});
  if (is_agreed) return Finish(step());
  ShowStep();
}

void Visit::TakeDone(const Json& message) {
  const StepKind kind = step().kind;
  if (kind != StepKind::kInstruction && kind != StepKind::kBreak) {
    throw std::invalid_argument("message: " + step().name + " is not done this way");
  }
  ExpectStep(message, kind);
  // A second less, as the page's clock began later.
  if (kind == StepKind::kBreak && SecondsSince(shown_) < study_->break_seconds - 1) {
    throw std::invalid_argument("message: the break is not over");
  }
  Finish(step());
}

void Visit::TakeAnswers(const Json& message) {
  ExpectStep(message, StepKind::kQuestions);
  const Json given = message.contains("answers") ? message["answers"] : Json();
  Json answers = Json::object();
  for (const auto& [name, answer] : CheckedAnswers(step().questionnaire, given)) {
    answers[name] = answer;
  }
  Log("answers", {{"step", step().name}, {"answers", answers}});
  Finish(step());
}

void Visit::BeginTrial(const Json& message) {
  ExpectStep(message, step().is_trial() ? step().kind : StepKind::kTask);
  if (running_) return;
  const int attempt = static_cast<int>(progress_.TrialsOf(step().name).size()) + 1;
  running_.emplace();
  running_->folder = TrialFolder(step().name, attempt);
  MakeDirectories(participant_.folder / running_->folder);
  Log("trial", {{"step", step().name}, {"attempt", attempt}, {"folder", running_->folder}});
  running_->input.emplace(participant_.folder / running_->folder / kInputLog);
}

void Visit::EndTrial(const Json& message) {
  const std::string reason = TextIn(message, "reason");
  if (!running_ || !running_->began || !running_->reason.empty()) {
    throw std::invalid_argument("message: no trial is running");
  }
  ExpectStep(message, step().kind);
  if (reason != "done" && !(reason == "limit" && SecondsLeft() < 1)) {
    throw std::invalid_argument("message: found reason " + Quoted(reason) +
                                ", expected done, or limit at the limit of time");
  }
  EndWith(reason);
}

void Visit::TakeInput(const Json& message) {
  if (!running_ || !running_->input || !message.contains("lines")) return;
  const Json& lines = message["lines"];
  if (!lines.is_array() || lines.size() > kMaxInputLines) {
    throw std::invalid_argument("log: expected at most " + std::to_string(kMaxInputLines) +
                                " lines");
  }
  std::string text;
  for (const Json& line : lines) text += InputLine(line);
  if (running_->input->size() + text.size() <= kMaxInputBytes) running_->input->Append(text);
}

double Visit::SecondsLeft() const {
  return TaskOf(*study_, step()).limit_seconds - SecondsSince(*running_->began);
}

void Visit::Update() {
  try {
    if (running_) UpdateRunning();
  } catch (const std::exception& error) {
    // The trial is lost, the participant and the others are not.
    if (running_) running_->reason = std::string("failed: ") + error.what();
    if (running_) CompleteTrial();
  }
}

void Visit::UpdateRunning() {
  if (!running_->session) {
    if (services_->has_room()) StartSession();
    return;
  }
  SessionProcess& session = *running_->session;
  session.Update();
  if (!running_->reason.empty()) {
    if (session.HasEnded() || Clock::now() - running_->ending > kFarewell) CompleteTrial();
    return;
  }
  if (session.HasEnded()) return EndWith("failed: the session ended");
  if (!running_->began && session.port()) {
    running_->began = Clock::now();
    services_->set_port(participant_.token, session.port());
    if (page_) services_->send(*page_, {{"t", "session"}, {"left", SecondsLeft()}});
  }
  CheckLimits();
}

void Visit::StartSession() {
  const StudyTask& task = TaskOf(*study_, step());
  // In real time a session computes less than a second in a second; twice this is plenty.
  const auto cpu_seconds = static_cast<std::uint64_t>(std::ceil(2 * task.limit_seconds)) + 60;
  running_->session.emplace(
      SessionPlan{.program = services_->program,
                  .scene = fs::absolute(study_->folder / task.scene),
                  .recordings = fs::absolute(participant_.folder / running_->folder),
                  .limits = {.cpu_seconds = cpu_seconds,
                             .memory_bytes = services_->memory_bytes,
                             .file_bytes = services_->disk_bytes}});
  running_->ending = running_->measured = Clock::now();
}

void Visit::CheckLimits() {
  // Until the session has begun, `ending` is when its process was started.
  if (!running_->began) {
    if (Clock::now() - running_->ending > kStartTime) EndWith("failed: the session did not start");
    return;
  }
  if (SecondsLeft() < -kGraceSeconds) return EndWith("limit");
  if (!page_ && Clock::now() - left_ > kAwayTime) return EndWith("left");
  if (Clock::now() - running_->measured < kBetweenMeasuring) return;
  running_->measured = Clock::now();
  if (SizeOf(participant_.folder) > services_->disk_bytes) EndWith("disk");
}

void Visit::EndWith(const std::string& reason) {
  running_->reason = reason;
  running_->ending = Clock::now();
  running_->session->Interrupt();
}

void Visit::CompleteTrial() {
  const Step now = step();
  const double wall_seconds =
      running_->began ? std::chrono::duration<double>(running_->ending - *running_->began).count()
                      : 0;
  std::string reason = running_->reason;
  if (running_->session && reason.starts_with("failed")) reason += ": " + running_->session->End();
  const fs::path folder = participant_.folder / running_->folder;
  services_->set_port(participant_.token, std::nullopt);
  running_.reset();
  std::string recording = RecordingIn(folder);
  bool is_success = false;
  try {
    if (!recording.empty()) {
      is_success = MeasuresOf(folder / recording, TaskOf(*study_, now).goal).is_success;
    }
  } catch (const InputError& error) {
    reason = std::string("failed: ") + error.what();
  }
  if (recording.empty() && (reason == "done" || reason == "limit")) reason = "failed: no recording";
  Log("trial_end", {{"step", now.name},
                    {"reason", reason},
                    {"recording", recording},
                    {"wall_seconds", wall_seconds},
                    {"success", is_success}});
  const std::vector<Trial> trials = progress_.TrialsOf(now.name);
  const auto num_complete = std::ranges::count_if(trials, &Trial::is_complete);
  const bool is_passed =
      now.kind == StepKind::kTask || is_success || num_complete >= study_->practice->max_attempts;
  if (trials.back().is_complete() && is_passed) return Finish(now);
  ShowStep();
}

}  // namespace smile::study

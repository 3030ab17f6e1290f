#include "studio/live_brain.h"

#include <utility>

// The session's side of a brain. At most one question is open at a time; while it is, the simulated
// time stands still and the session continues to serve pages. The program runs in a thread of its
// own, in which it also ends.

namespace smile::studio {
namespace {

/// Timeout per frame for the answer of a program: most answer within it, and the session stays
/// responsive if one does not.
constexpr std::chrono::milliseconds kMoment(4);

}  // namespace

void LiveBrain::Start(const library::BrainChoice& choice, const brain::BrainDriverOptions& options,
                      sim::Simulation* simulation) {
  Leave();
  name_ = choice.name;
  watched_ticks_ = 0;
  brain::BrainOptions brain_options = limits_;
  // Called in that thread; the console has a lock.
  brain_options.on_output = [this](std::string_view line) { console_.Write(line); };
  thread_ = std::make_unique<brain::BrainThread>(choice.path, std::move(brain_options),
                                                 std::move(former_));
  driver_.emplace(options);
  try {
    SubmitQuestion(simulation);
  } catch (...) {
    Leave();
    throw;
  }
}

void LiveBrain::Attend(sim::Simulation* simulation) {
  if (is_starting()) (void)TakeAnswer(std::chrono::nanoseconds(0), simulation);
}

bool LiveBrain::Drive(sim::Simulation* simulation) {
  // No tick before the program is ready, and none while a question is open.
  if (is_starting()) return false;
  if (!is_running()) return true;
  // The driver need not ask at every tick: without a question the world ticks at once.
  if (!is_question_pending_) SubmitQuestion(simulation);
  return !is_question_pending_ || TakeAnswer(kMoment, simulation);
}

void LiveBrain::SubmitQuestion(sim::Simulation* simulation) {
  std::optional<brain::BrainQuestion> question = driver_->NextQuestion(simulation);
  is_question_pending_ = question.has_value();
  watched_ticks_ = driver_->watched_ticks();
  if (question) thread_->Submit(*std::move(question));
}

bool LiveBrain::TakeAnswer(std::chrono::nanoseconds timeout, sim::Simulation* simulation) {
  auto answer = thread_->WaitForAnswer(timeout);
  if (!answer) return false;
  is_question_pending_ = false;
  driver_->Take(*std::move(answer), simulation);
  if (const auto& error = driver_->error()) {
    console_.Write(ToString(*error));
    thread_->Leave();  // the program itself may be well; the error may be in the demonstration
  }
  return true;
}

void LiveBrain::Stop(sim::Simulation* simulation) {
  if (!is_running()) return;
  Leave();
  was_stopped_ = true;
  // The last velocities would continue otherwise.
  (void)simulation->Apply(sim::StillVelocities(simulation->robot()->model()));
  // Face and markers are back to their defaults, as if no program had run.
  (void)simulation->Apply(sim::Face{});
  (void)simulation->Apply(sim::Markers{});
}

void LiveBrain::Leave() {
  driver_.reset();
  was_stopped_ = is_question_pending_ = false;
  if (!thread_) return;
  thread_->Leave();
  // Ending a process takes time; the former program ends in its own thread, and the next one waits
  // for it.
  former_ = std::move(thread_);
}

Json LiveBrain::Describe() const {
  Json described = {{"name", name_},    {"status", "none"}, {"message", ""},
                    {"claim", nullptr}, {"file", ""},       {"line", 0}};
  if (was_stopped_) described["status"] = "stopped";
  if (!driver_) return described;
  described["status"] = ToString(driver_->status());
  described["claim"] = experiment::ClaimJson(driver_->claim());
  if (const auto& error = driver_->error()) {
    described["message"] = error->message;
    described["file"] = error->file;
    described["line"] = error->line;
  }
  return described;
}

}  // namespace smile::studio

#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "recording/append_file.h"
#include "study/event_log.h"
#include "study/participants.h"
#include "study/progress.h"
#include "study/session_process.h"
#include "web_server/web_socket_handler.h"

namespace smile::study {

/// Number of a participant's page.
using PageId = web_server::WebSocketId;

/// Parts of the server that all visits use.
struct VisitServices {
  std::function<void(PageId, const Json&)> send;
  /// Called when a session serves at a port, and with nullopt when it has ended.
  std::function<void(const std::string& token, std::optional<int> port)> set_port;
  std::function<bool()> has_room;                  ///< for one more session
  std::filesystem::path program;                   ///< `smile`
  std::uint64_t memory_bytes = 0, disk_bytes = 0;  ///< of one participant
};

/// A participant's way through the study: takes the messages of the page, writes events, runs the
/// sessions of trials, and sends the present step. All in one thread, and nothing waits.
class Visit {
 public:
  using Clock = std::chrono::steady_clock;

  /// Opens the participant's events. A trial that was running when the server ended is interrupted.
  /// @param study, services  must outlive the visit.
  /// @throws InputError if the events are damaged, std::runtime_error if another server has them.
  Visit(const Definition* study, Participant participant, const VisitServices* services);

  /// A page of the participant has come; an earlier one is told that it is replaced.
  void Enter(PageId page);
  void Leave(PageId page);
  /// Carries out a message of the present page.
  /// @throws std::invalid_argument with the reason if it is wrong; nothing has happened then.
  void Receive(const Json& message);
  /// Goes on with what takes time; called often.
  void Update();

  /// Returns true while a process of a trial exists.
  bool is_in_session() const { return running_ && running_->session; }
  const Progress& progress() const { return progress_; }

 private:
  /// A trial from the press of its button to its end.
  struct RunningTrial {
    std::string folder;                     ///< below that of the participant
    std::optional<SessionProcess> session;  ///< nullopt while it waits for room
    std::optional<recording::AppendFile> input;
    std::optional<Clock::time_point> began;  ///< when the session was ready
    std::string reason;                      ///< for which it ends; empty: it goes on
    Clock::time_point ending;
    Clock::time_point measured;  ///< when its files were
  };

  void Log(const std::string& event, const Json& fields);
  const Step& step() const { return progress_.Next(steps_); }
  void ExpectStep(const Json& message, StepKind kind) const;
  void ShowStep();
  void Finish(const Step& step);
  void TakeConsent(const Json& message);
  void TakeDone(const Json& message);
  void TakeAnswers(const Json& message);
  void BeginTrial(const Json& message);
  void EndTrial(const Json& message);
  void TakeInput(const Json& message);

  void UpdateRunning();
  void StartSession();
  void CheckLimits();
  void EndWith(const std::string& reason);
  void CompleteTrial();
  double SecondsLeft() const;

  const Definition* study_;
  Participant participant_;
  const VisitServices* services_;
  std::vector<Step> steps_;
  EventLog log_;
  Progress progress_;
  std::optional<PageId> page_;
  Clock::time_point shown_, left_;  ///< when the step was shown, when the last page left
  std::string shown_step_;
  std::optional<RunningTrial> running_;
};

}  // namespace smile::study

#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "brain/brain_process.h"

namespace smile::brain {

/// BrainProcess on a thread of its own, for callers that must not wait while it starts and
/// computes. One question at a time.
class BrainThread {
 public:
  /// Checks the brain without starting it.
  /// @param options  their callbacks are called on other threads.
  /// @param before  the former program; this one starts only when that has ended. nullptr for none.
  ///                Moved from unless this throws.
  /// @throws as BrainProcess does.
  BrainThread(const std::filesystem::path& brain, BrainOptions options,
              std::unique_ptr<BrainThread>&& before);
  BrainThread(const BrainThread&) = delete;
  BrainThread& operator=(const BrainThread&) = delete;
  /// Calls Leave() and waits for the end of the program, about a second.
  ~BrainThread();

  /// Submits a question; the first one starts the program. Any failure becomes a BrainError.
  void Submit(BrainQuestion question);
  /// Returns the answer; nullopt if there is none within this time.
  std::optional<BrainAnswer> WaitForAnswer(std::chrono::nanoseconds timeout);

  /// Ends the program, even while it starts or computes, without waiting. No questions may follow.
  void Leave();

 private:
  BrainOptions WithEnd(BrainOptions options);
  void WorkerLoop();
  /// Returns nullopt when the program is to end.
  std::optional<BrainQuestion> AwaitQuestion();
  BrainAnswer AnswerTo(const BrainQuestion& question);
  void PutAnswer(BrainAnswer answer);

  std::atomic<bool> is_leaving_ = false;
  BrainProcess process_;  ///< used only by the thread, once that runs
  std::unique_ptr<BrainThread> before_;

  std::mutex mutex_;  ///< of question and answer
  std::condition_variable changed_;
  std::optional<BrainQuestion> question_;
  std::optional<BrainAnswer> answer_;

  std::thread thread_;
};

}  // namespace smile::brain

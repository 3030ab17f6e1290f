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

/// A robot program for whoever has other things to do while it starts and thinks: a BrainProcess
/// on a thread of its own, with which it lives and dies. One question at a time.
class BrainThread {
 public:
  /// Starts nothing yet.
  /// @param options  what they call is called on other threads.
  /// @param before   the program that was there before; this one starts only when that has ended.
  ///                 nullptr for none. Taken unless this throws.
  /// @throws as BrainProcess does.
  BrainThread(const std::filesystem::path& brain, BrainOptions options,
              std::unique_ptr<BrainThread>&& before);
  BrainThread(const BrainThread&) = delete;
  BrainThread& operator=(const BrainThread&) = delete;
  /// Leave(), and waits for its end: for a second or so.
  ~BrainThread();

  /// The first question starts it. What keeps it from answering is a BrainError, whatever it is.
  void Ask(BrainQuestion question);
  /// nullopt if there is none after so long.
  std::optional<BrainAnswer> WaitForAnswer(std::chrono::nanoseconds patience);

  /// Ends the program, also while it starts or thinks, and does not wait for that. Nothing is to be
  /// asked any more.
  void Leave();

 private:
  BrainOptions WithEnd(BrainOptions options);
  void WorkerLoop();
  /// nullopt when it shall leave.
  std::optional<BrainQuestion> AwaitQuestion();
  BrainAnswer AnswerTo(const BrainQuestion& question);
  void PutAnswer(BrainAnswer answer);

  std::atomic<bool> is_leaving_ = false;
  BrainProcess process_;  ///< touched by the thread alone, once that runs
  std::unique_ptr<BrainThread> before_;

  std::mutex mutex_;  ///< of question and answer
  std::condition_variable changed_;
  std::optional<BrainQuestion> question_;
  std::optional<BrainAnswer> answer_;

  std::thread thread_;
};

}  // namespace smile::brain

#include "brain/brain_thread.h"

#include <exception>
#include <utility>

namespace smile::brain {

BrainThread::BrainThread(const std::filesystem::path& brain, BrainOptions options,
                         std::unique_ptr<BrainThread>&& before)
    // The thread is the last member: all others exist when it starts. It is also the thread that
    // starts the process, which ends with the thread of its start (see BrainProcess).
    : process_(brain, WithEnd(std::move(options))),
      before_(std::move(before)),
      thread_([this] { WorkerLoop(); }) {}

BrainThread::~BrainThread() {
  Leave();
  thread_.join();
}

// Cancels the start and callbacks once Leave() was called.
BrainOptions BrainThread::WithEnd(BrainOptions options) {
  options.is_cancelled = [this, is_cancelled = std::move(options.is_cancelled)] {
    // Read by the worker while it waits for the program, without the lock: hence atomic.
    return is_leaving_ || (is_cancelled && is_cancelled());
  };
  return options;
}

void BrainThread::Submit(BrainQuestion question) {
  {
    const std::lock_guard lock(mutex_);
    question_ = std::move(question);
  }
  changed_.notify_all();
}

std::optional<BrainAnswer> BrainThread::WaitForAnswer(std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  // The answer is taken, so that it is returned once.
  changed_.wait_for(lock, timeout, [this] { return answer_.has_value(); });
  return std::exchange(answer_, std::nullopt);
}

void BrainThread::Leave() {
  {
    const std::lock_guard lock(mutex_);
    // Under the lock, although atomic: otherwise, the worker could test it, find it false, and miss
    // the notification before it starts to wait.
    is_leaving_ = true;
  }
  changed_.notify_all();
}

void BrainThread::WorkerLoop() {
  // Ends the former program first: two brains must not run at the same time.
  before_.reset();
  while (const auto question = AwaitQuestion()) PutAnswer(AnswerTo(*question));
  // At the end of its own thread, not in the destructor: nothing waits for it but the thread.
  process_.Stop();
}

// Leaving has priority over a question that waits.
std::optional<BrainQuestion> BrainThread::AwaitQuestion() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_leaving_ || question_.has_value(); });
  if (is_leaving_) return std::nullopt;
  return std::exchange(question_, std::nullopt);
}

BrainAnswer BrainThread::AnswerTo(const BrainQuestion& question) {
  try {
    return process_.Answer(question);
  } catch (const std::exception& error) {
    // The state of the program is unknown after an exception, so it must not be asked again.
    process_.Stop();
    const bool is_start = std::holds_alternative<Aux>(question);
    return BrainError{.phase = is_start ? BrainError::Phase::kStart : BrainError::Phase::kCallback,
                      .message = error.what()};
  }
}

void BrainThread::PutAnswer(BrainAnswer answer) {
  {
    const std::lock_guard lock(mutex_);
    answer_ = std::move(answer);
  }
  changed_.notify_all();
}

}  // namespace smile::brain

#include "thread_team.h"

#include <chrono>

#include <unistd.h>

namespace smile::python {
namespace {

/// How long a thread stays awake for the next work. Longer than what Python does between two steps
/// of a vector environment, shorter than anyone would notice.
constexpr auto kAwake = std::chrono::microseconds(400);

/// Waits until a value is another one.
template <typename Value>
void WaitForChange(const std::atomic<Value>& value, Value old) {
  const auto end = std::chrono::steady_clock::now() + kAwake;
  while (value.load(std::memory_order_acquire) == old) {
    if (std::chrono::steady_clock::now() < end) continue;
    value.wait(old, std::memory_order_acquire);
  }
}

}  // namespace

ThreadTeam::ThreadTeam(int num_threads) : num_threads_(num_threads) {}

ThreadTeam::~ThreadTeam() { Stop(); }

void ThreadTeam::Run(const std::function<void()>& work) {
  const std::scoped_lock lock(mutex_);
  if (process_ != getpid()) Start();
  shared_->work = &work;
  shared_->num_working = num_threads_ - 1;
  ++shared_->num_works;
  shared_->num_works.notify_all();
  work();
  while (const int num_working = shared_->num_working) {
    WaitForChange(shared_->num_working, num_working);
  }
}

void ThreadTeam::Help(Shared* shared) {
  for (unsigned done = 0;; ++done) {
    WaitForChange(shared->num_works, done);
    if (shared->work == nullptr) return;
    (*shared->work)();
    if (--shared->num_working == 0) shared->num_working.notify_one();
  }
}

void ThreadTeam::Start() {
  // A forked process has the memory of the team, but not its threads: nothing can wait for them.
  if (shared_) static_cast<void>(shared_.release());
  shared_ = std::make_unique<Shared>();
  for (int i = 1; i < num_threads_; ++i) shared_->helpers.emplace_back(Help, shared_.get());
  process_ = getpid();
}

void ThreadTeam::Stop() {
  if (!shared_) return;
  if (process_ != getpid()) {
    static_cast<void>(shared_.release());
    return;
  }
  shared_->work = nullptr;
  ++shared_->num_works;
  shared_->num_works.notify_all();
  for (std::thread& helper : shared_->helpers) helper.join();
}

}  // namespace smile::python

#include "studio/workshop.h"

#include <algorithm>
#include <utility>

namespace smile::studio {
namespace {

/// One for what is looked up, one for what is simulated.
constexpr int kNumThreads = 2;
constexpr std::size_t kMaxTasks = 256;
constexpr int kMaxTasksOfClient = 8;

page::Letter ProgressLetter(const std::string& what, double done, double total) {
  return {.message = {{"t", "progress"}, {"what", what}, {"done", done}, {"total", total}}};
}

}  // namespace

Workshop::Workshop() {
  for (int i = 0; i < kNumThreads; ++i) threads_.emplace_back([this] { Labor(); });
}

Workshop::~Workshop() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    for (Task& task : tasks_) task.given_up_for = "the program ends";
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workshop::Begin(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (job.replaces_older) {
      const auto is_older = [&newer = job.request](const Job& other) {
        return other.request.client == newer.client && other.request.what == newer.what;
      };
      GiveUp(is_older, "given up for what was asked for since");
    }
    const auto num_of_client = std::ranges::count_if(tasks_, [&job](const Task& task) {
      return task.job.request.client == job.request.client && task.given_up_for.empty();
    });
    if (tasks_.size() >= kMaxTasks || num_of_client >= kMaxTasksOfClient) {
      throw page::RequestError("too much is asked for at once: wait a bit");
    }
    tasks_.push_back({.job = std::move(job)});
  }
  changed_.notify_one();
}

void Workshop::Cancel(page::ClientId client, std::uint32_t seq) {
  const std::lock_guard lock(mutex_);
  const auto is_meant = [&](const Job& job) {
    return job.can_be_canceled && job.request.client == client && job.request.seq == seq;
  };
  GiveUp(is_meant, "canceled");
}

void Workshop::GiveUp(const std::function<bool(const Job&)>& is_meant, const std::string& why) {
  for (auto task = tasks_.begin(); task != tasks_.end();) {
    if (!is_meant(task->job)) {
      ++task;
    } else if (task->is_running) {
      task->given_up_for = why;
      ++task;
    } else {
      const auto fail = [&why]() -> Json { throw page::RequestError(why); };
      Send(task->job, AnswerWith(task->job.request, fail));
      task = tasks_.erase(task);
    }
  }
}

std::vector<page::Letter> Workshop::TakeLetters() {
  std::vector<page::Letter> letters;
  for (Outgoing& outgoing : TakeOutgoing()) {
    if (outgoing.conclude) outgoing.conclude();
    letters.push_back(std::move(outgoing.letter));
  }
  return letters;
}

std::vector<Workshop::Outgoing> Workshop::TakeOutgoing() {
  const std::lock_guard lock(mutex_);
  for (Task& task : tasks_) {
    if (!std::exchange(task.has_news, false)) continue;
    outgoing_.push_back({ProgressLetter(task.job.request.what, task.done, task.total), {}});
  }
  return std::exchange(outgoing_, {});
}

void Workshop::Send(const Job& job, Json answer) {
  outgoing_.push_back({{.client = job.request.client, .message = std::move(answer)}, job.conclude});
}

void Workshop::Labor() {
  while (Task* task = TakeTask()) Finish(task, CarryOut(task));
}

Workshop::Task* Workshop::TakeTask() {
  std::unique_lock lock(mutex_);
  while (!is_closing_) {
    const auto next =
        std::ranges::find_if(tasks_, [](const Task& task) { return !task.is_running; });
    if (next != tasks_.end()) {
      next->is_running = true;
      return &*next;
    }
    changed_.wait(lock);
  }
  return nullptr;
}

Json Workshop::CarryOut(Task* task) {
  return AnswerWith(task->job.request, [this, task] {
    FailIfGivenUp(*task);
    try {
      Json answer = task->job.work(
          [this, task](double done, double total) { return Tell(task, done, total); });
      // What somebody replaced is of no use; else what is done is done.
      if (task->job.replaces_older || task->was_told_to_end) FailIfGivenUp(*task);
      return answer;
    } catch (const std::exception&) {
      if (task->was_told_to_end) FailIfGivenUp(*task);
      throw;
    }
  });
}

void Workshop::FailIfGivenUp(const Task& task) {
  const std::lock_guard lock(mutex_);
  if (!task.given_up_for.empty()) throw page::RequestError(task.given_up_for);
}

bool Workshop::Tell(Task* task, double done, double total) {
  const std::lock_guard lock(mutex_);
  task->done = done;
  task->total = total;
  task->has_news = task->has_begun = true;
  task->was_told_to_end = !task->given_up_for.empty();
  return !task->was_told_to_end;
}

void Workshop::Finish(Task* task, Json answer) {
  const std::lock_guard lock(mutex_);
  // Whoever saw it begin sees it end, also when it failed.
  if (task->has_begun) {
    outgoing_.push_back({ProgressLetter(task->job.request.what, task->total, task->total), {}});
  }
  Send(task->job, std::move(answer));
  tasks_.remove_if([task](const Task& other) { return &other == task; });
}

}  // namespace smile::studio

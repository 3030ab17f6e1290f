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

Json FailAsGivenUp() { throw page::RequestError("given up for what was asked for since"); }

}  // namespace

Workshop::Workshop() {
  for (int i = 0; i < kNumThreads; ++i) threads_.emplace_back([this] { Labor(); });
}

Workshop::~Workshop() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    for (Task& task : tasks_) task.is_given_up = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workshop::Begin(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (job.replaces_older) GiveUpOlderThan(job.request);
    const auto num_of_client = std::ranges::count_if(tasks_, [&job](const Task& task) {
      return task.job.request.client == job.request.client && !task.is_given_up;
    });
    if (tasks_.size() >= kMaxTasks || num_of_client >= kMaxTasksOfClient) {
      throw page::RequestError("too much is asked for at once: wait a bit");
    }
    tasks_.push_back({.job = std::move(job)});
  }
  changed_.notify_one();
}

void Workshop::GiveUpOlderThan(const page::Request& newer) {
  for (auto task = tasks_.begin(); task != tasks_.end();) {
    const page::Request& request = task->job.request;
    const bool is_older = request.client == newer.client && request.what == newer.what;
    if (is_older && !task->is_running) {
      Send(task->job, AnswerWith(request, &FailAsGivenUp));
      task = tasks_.erase(task);
      continue;
    }
    if (is_older) task->is_given_up = true;
    ++task;
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
    const auto fail_if_given_up = [this, task] {
      const std::lock_guard lock(mutex_);
      if (task->is_given_up) FailAsGivenUp();
    };
    fail_if_given_up();
    Json answer =
        task->job.work([this, task](double done, double total) { return Tell(task, done, total); });
    fail_if_given_up();
    return answer;
  });
}

bool Workshop::Tell(Task* task, double done, double total) {
  const std::lock_guard lock(mutex_);
  task->done = done;
  task->total = total;
  task->has_news = task->has_begun = true;
  return !task->is_given_up;
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

// One thread takes jobs in order: child processes end with the thread that started them. mutex_ is
// not held while a program runs or progress is determined.

#include "datasets/job_queue.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>

#include "base/files.h"
#include "base/wording.h"
#include "experiment/program_pool.h"
#include "page/requests.h"
#include "texts/user_message.h"

namespace smile::datasets {

using texts::Say;
namespace {

namespace fs = std::filesystem;

/// Time between two looks at the progress of a job.
constexpr auto kBetweenReports = std::chrono::seconds(1);
/// Wall-clock time after which a job is ended: a month [s].
constexpr double kMaxJobSeconds = 30 * 86400.0;
constexpr std::streamoff kMaxTailBytes = 8 << 10;
constexpr std::size_t kMaxReasonLines = 6, kMaxVerdictLines = 100;

/// Returns the end of a file; empty if it cannot be read.
std::string TailOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return "";
  const std::streamoff size = in.tellg();
  std::string tail(static_cast<std::size_t>(std::min(size, kMaxTailBytes)), '\0');
  in.seekg(size - static_cast<std::streamoff>(tail.size()));
  in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  return tail;
}

/// Returns the lines that are not blank, cleaned.
std::vector<std::string> LinesIn(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(Printable(line));
  }
  return lines;
}

std::string LastLineIn(const fs::path& file) {
  const std::vector<std::string> lines = LinesIn(TailOf(file));
  return lines.empty() ? "" : lines.back();
}

/// What a check found.
Json VerdictOf(const JobProgram& program, const experiment::PoolEnd& end) {
  std::vector<std::string> lines = LinesIn(TailOf(program.log));
  if (lines.size() > kMaxVerdictLines) {
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kMaxVerdictLines));
  }
  return {{"ok", end.exit_code == 0}, {"lines", lines}};
}

}  // namespace

std::string ReasonIn(const std::string& log) {
  std::vector<std::string> lines = LinesIn(log);
  // Failures of attempts are no failure of the job.
  std::erase_if(lines, [](const std::string& line) { return line.starts_with("seed "); });
  std::string reason;
  const std::size_t first = lines.size() - std::min(lines.size(), kMaxReasonLines);
  for (std::size_t i = first; i < lines.size(); ++i) {
    reason += (reason.empty() ? "" : "\n") + lines[i];
  }
  return reason;
}

JobQueue::JobQueue() : thread_([this] { WorkerLoop(); }) {}

JobQueue::~JobQueue() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

int JobQueue::Add(Job job) {
  int number = 0;
  {
    const std::lock_guard lock(mutex_);
    const auto num_open =
        std::ranges::count_if(tasks_, [](const Task& task) { return task.is_open(); });
    if (num_open >= static_cast<std::ptrdiff_t>(kMaxWaiting)) {
      throw page::RequestError(Say("sets.tooManyJobs"));
    }
    if (HasOpen(job.what, job.name)) {
      throw page::RequestError(Say("sets.isBeingMade", {{"name", Quoted(job.name)}}));
    }
    number = ++num_added_;
    ++num_changes_;
    tasks_.push_back({.number = number, .job = std::move(job)});
    const auto is_done = [](const Task& task) { return !task.is_open(); };
    // The oldest are forgotten; they are in their folders anyway.
    while (std::ranges::count_if(tasks_, is_done) > static_cast<std::ptrdiff_t>(kMaxKept)) {
      tasks_.erase(std::ranges::find_if(tasks_, is_done));
    }
  }
  changed_.notify_one();
  return number;
}

void JobQueue::Stop(int number) {
  const std::lock_guard lock(mutex_);
  Task* task = FindOpen(number);
  if (task == nullptr) throw page::RequestError(Say("sets.noJob"));
  task->is_stopped = true;
  ++num_changes_;
  if (!task->is_running()) task->status = "stopped";
}

bool JobQueue::IsBusy(const std::string& what, const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return HasOpen(what, name);
}

bool JobQueue::IsUsing(const std::string& set) const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(
      tasks_, [&](const Task& task) { return task.is_open() && task.job.set == set; });
}

Json JobQueue::List() const {
  const std::lock_guard lock(mutex_);
  Json list = Json::array();
  for (const Task& task : tasks_) {
    Json entry{{"job", task.number},
               {"do", task.job.what},
               {"name", task.job.name},
               {"status", task.is_running() && task.is_stopped ? "stopping" : task.status},
               {"words", task.words},
               {"verdict", task.verdict}};
    entry.update(task.progress);
    list.push_back(std::move(entry));
  }
  return list;
}

std::size_t JobQueue::num_changes() const {
  const std::lock_guard lock(mutex_);
  return num_changes_;
}

JobQueue::Task* JobQueue::FindOpen(int number) {
  const auto found = std::ranges::find_if(
      tasks_, [number](const Task& task) { return task.number == number && task.is_open(); });
  return found != tasks_.end() ? &*found : nullptr;
}

bool JobQueue::HasOpen(const std::string& what, const std::string& name) const {
  return std::ranges::any_of(tasks_, [&](const Task& task) {
    return task.is_open() && task.job.what == what && task.job.name == name;
  });
}

void JobQueue::WorkerLoop() {
  while (Task* task = TakeTask()) {
    try {
      RunPrograms(task);
    } catch (const std::exception& error) {
      Finish(task, "failed", error.what());
    }
  }
}

JobQueue::Task* JobQueue::TakeTask() {
  std::unique_lock lock(mutex_);
  while (!is_closing_) {
    const auto next = std::ranges::find_if(
        tasks_, [](const Task& task) { return task.is_open() && !task.is_running(); });
    if (next != tasks_.end()) {
      next->status = "running";
      ++num_changes_;
      return &*next;
    }
    changed_.wait(lock);
  }
  return nullptr;
}

void JobQueue::RunPrograms(Task* task) {
  for (const JobProgram& program : task->job.programs) {
    if (!RunProgram(task, program)) return;
  }
  Finish(task, "done", LastLineIn(task->job.programs.back().log));
}

std::optional<experiment::PoolEnd> JobQueue::EndOf(Task* task, const JobProgram& program) {
  const experiment::PoolJob job{.command = {.arguments = program.arguments,
                                            .environment = {},
                                            .working_directory = fs::current_path()},
                                .log = program.log,
                                .max_seconds = kMaxJobSeconds};
  std::optional<experiment::PoolEnd> end;
  auto next = std::chrono::steady_clock::now();
  const auto report_sometimes = [&] {
    if (std::chrono::steady_clock::now() < next) return;
    next = std::chrono::steady_clock::now() + kBetweenReports;
    Report(task, program);
  };
  experiment::RunAll({job}, 1,
                     {.on_start = [](std::size_t) {},
                      .on_end = [&](std::size_t, const experiment::PoolEnd& how) { end = how; },
                      .on_wait = report_sometimes,
                      .is_cancelled = [&] { return IsStopped(*task); }});
  return end;
}

bool JobQueue::RunProgram(Task* task, const JobProgram& program) {
  MakeDirectories(program.log.parent_path());
  const std::optional<experiment::PoolEnd> end = EndOf(task, program);
  Report(task, program);
  if (!end) {
    Finish(task, "stopped", "");
    return false;
  }
  if (program.is_check && (end->exit_code == 0 || end->exit_code == 1)) {
    const std::lock_guard lock(mutex_);
    task->verdict = VerdictOf(program, *end);
    return true;
  }
  if (end->exit_code == 0) return true;
  const std::string reason = ReasonIn(TailOf(program.log));
  Finish(task, "failed", reason.empty() ? end->how : reason);
  return false;
}

void JobQueue::Report(Task* task, const JobProgram& program) {
  const std::string line = LastLineIn(program.log);
  Json progress = program.is_check ? task->progress : task->job.progress(line);
  const std::lock_guard lock(mutex_);
  if (progress == task->progress && line == task->words) return;
  task->progress = std::move(progress);
  task->words = line;
  ++num_changes_;
}

void JobQueue::Finish(Task* task, const char* status, const std::string& words) {
  const std::lock_guard lock(mutex_);
  task->status = status;
  task->words = words;
  ++num_changes_;
}

bool JobQueue::IsStopped(const Task& task) const {
  const std::lock_guard lock(mutex_);
  return is_closing_ || task.is_stopped;
}

}  // namespace smile::datasets

// One worker thread, because an OpenGL context belongs to the thread that made it. `mutex_` guards
// everything except the job in progress; rendering happens without it.

#include "library/thumbnail_queue.h"

#include <stdexcept>
#include <utility>

#include "library/thumbnail_renderer.h"

namespace smile::library {
namespace {

/// Limits: jobs that wait, and pictures that are kept.
constexpr std::size_t kMaxJobs = 256;
constexpr std::size_t kMaxKept = 2000;
constexpr std::size_t kMaxKeptBytes = 64 << 20;

std::size_t SizeOf(const ThumbnailQueue::Picture& picture) { return picture ? picture->size() : 0; }

}  // namespace

ThumbnailQueue::ThumbnailQueue() : thread_([this] { WorkerLoop(); }) {}

ThumbnailQueue::~ThumbnailQueue() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    // Waiting calls of Get() then throw std::future_error.
    jobs_.clear();  // breaks their promises
  }
  changed_.notify_all();
  thread_.join();
}

ThumbnailQueue::Picture ThumbnailQueue::Get(const std::string& key, const Render& render) {
  // Waits outside the lock.
  return Enqueue(key, render).get();
}

std::shared_future<ThumbnailQueue::Picture> ThumbnailQueue::Enqueue(const std::string& key,
                                                                    const Render& render) {
  const std::lock_guard lock(mutex_);
  // Finished and pending pictures share one map: equal requests wait for the same future.
  const auto known = pictures_.find(key);
  if (known != pictures_.end()) return known->second;
  // A page with many thumbnails requests them all at once; a client that asks for more is refused,
  // so that others do not wait behind it.
  if (is_closing_ || jobs_.size() >= kMaxJobs) {
    throw std::runtime_error("too many pictures are requested at once");
  }
  jobs_.push_back({.key = key, .render = render});
  changed_.notify_one();
  return pictures_[key] = jobs_.back().picture.get_future().share();
}

void ThumbnailQueue::WorkerLoop() {
  // Made and destroyed in this thread; its context opens with the first picture.
  ThumbnailRenderer renderer;
  while (auto job = TakeJob()) Run(*std::move(job), &renderer);
}

std::optional<ThumbnailQueue::Job> ThumbnailQueue::TakeJob() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_closing_ || !jobs_.empty(); });
  if (is_closing_) return std::nullopt;
  Job job = std::move(jobs_.front());
  jobs_.pop_front();
  return job;
}

void ThumbnailQueue::Run(Job job, ThumbnailRenderer* renderer) {
  try {
    Picture picture = job.render(renderer);
    const std::lock_guard lock(mutex_);
    kept_.push_back(job.key);
    kept_bytes_ += SizeOf(picture);
    // First in, first out: a picture is cheap to make again, and keys contain stamps, so old
    // entries are mostly of files that have changed since.
    while (kept_.size() > kMaxKept || kept_bytes_ > kMaxKeptBytes) {
      const auto oldest = pictures_.find(kept_.front());
      // The newest is not set yet; waiting for its future here would block forever.
      if (oldest->first == job.key) break;
      kept_bytes_ -= SizeOf(oldest->second.get());
      pictures_.erase(oldest);
      kept_.pop_front();
    }
    job.picture.set_value(std::move(picture));
  } catch (...) {
    const std::lock_guard lock(mutex_);
    // An error is reported to all who wait for it, but not kept.
    pictures_.erase(job.key);  // the next call may succeed
    job.picture.set_exception(std::current_exception());
  }
}

}  // namespace smile::library

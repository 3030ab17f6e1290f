#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace smile::library {

class ThumbnailRenderer;

/// Thumbnail queue: renders thumbnails one after another on a worker thread, which owns their
/// renderer, and caches the newest. Thread-safe.
class ThumbnailQueue {
 public:
  /// PNG file; nullopt if the requested content is missing.
  using Picture = std::optional<std::string>;
  using Render = std::function<Picture(ThumbnailRenderer* renderer)>;

  ThumbnailQueue();
  /// Pending calls of Get() throw.
  ~ThumbnailQueue();
  ThumbnailQueue(const ThumbnailQueue&) = delete;
  ThumbnailQueue& operator=(const ThumbnailQueue&) = delete;

  /// Returns the thumbnail from the cache, or waits until `render` has made it.
  /// @param key  same key, same picture.
  /// @throws what `render` throws, and std::runtime_error if too many jobs are queued.
  Picture Get(const std::string& key, const Render& render);

 private:
  struct Job {
    std::string key;
    Render render;
    std::promise<Picture> picture;
  };

  std::shared_future<Picture> Enqueue(const std::string& key, const Render& render);
  void WorkerLoop();
  /// Returns nullopt when the queue closes.
  std::optional<Job> TakeJob();
  void Run(Job job, ThumbnailRenderer* renderer);

  std::mutex mutex_;  ///< guards all members below
  std::condition_variable changed_;
  bool is_closing_ = false;
  std::deque<Job> jobs_;
  std::map<std::string, std::shared_future<Picture>> pictures_;  ///< also pending ones
  std::deque<std::string> kept_;                                 ///< keys, oldest first
  std::size_t kept_bytes_ = 0;
  std::thread thread_;
};

}  // namespace smile::library

#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace smile::studio {

/// What other threads want to know of a session is looked up by the thread it belongs to.
class Errands {
 public:
  using Lookup = std::function<std::optional<std::string>()>;

  /// Waits until CarryOut() has done it.
  /// @throws std::runtime_error if nobody does for long, or the studio ends.
  std::optional<std::string> Ask(Lookup lookup) {
    std::packaged_task<std::optional<std::string>()> task(std::move(lookup));
    std::future<std::optional<std::string>> answer = task.get_future();
    {
      const std::lock_guard lock(mutex_);
      if (is_closed_) throw std::runtime_error("the studio ends");
      waiting_.push_back(std::move(task));
    }
    if (answer.wait_for(std::chrono::seconds(30)) != std::future_status::ready) {
      throw std::runtime_error("the studio is busy");
    }
    return answer.get();
  }

  void CarryOut() {
    for (auto& task : TakeAll()) task();
  }

  /// Whoever waits, waits no longer.
  void Close() {
    {
      const std::lock_guard lock(mutex_);
      is_closed_ = true;
    }
    TakeAll();
  }

 private:
  using Tasks = std::deque<std::packaged_task<std::optional<std::string>()>>;

  Tasks TakeAll() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, {});
  }

  std::mutex mutex_;
  Tasks waiting_;
  bool is_closed_ = false;
};

}  // namespace smile::studio

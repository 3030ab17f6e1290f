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

class Painter;

/// Has pictures painted one after another on a thread of its own, to which their painter belongs,
/// and keeps the newest of them. May be used from several threads at once.
class Darkroom {
 public:
  /// A PNG; nullopt if there is nothing to be seen.
  using Picture = std::optional<std::string>;
  using Paint = std::function<Picture(Painter* painter)>;

  Darkroom();
  /// Whoever waits gets an exception.
  ~Darkroom();
  Darkroom(const Darkroom&) = delete;
  Darkroom& operator=(const Darkroom&) = delete;

  /// Waits for it, unless it is there already.
  /// @param key  same key, same picture.
  /// @throws what `paint` throws, and std::runtime_error if too many wait.
  Picture Get(const std::string& key, const Paint& paint);

 private:
  struct Order {
    std::string key;
    Paint paint;
    std::promise<Picture> picture;
  };

  std::shared_future<Picture> Ask(const std::string& key, const Paint& paint);
  void Labor();
  std::optional<Order> TakeOrder();
  void Fulfil(Order order, Painter* painter);

  std::mutex mutex_;  ///< of all that follows
  std::condition_variable changed_;
  bool is_closing_ = false;
  std::deque<Order> orders_;
  std::map<std::string, std::shared_future<Picture>> pictures_;  ///< also those to come
  std::deque<std::string> kept_;                                 ///< keys, oldest first
  std::size_t kept_bytes_ = 0;
  std::thread thread_;
};

}  // namespace smile::library

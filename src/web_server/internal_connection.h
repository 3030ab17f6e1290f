#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <chrono>
#include <exception>
#include <functional>
#include <list>
#include <memory>
#include <optional>

#include "web_server/internal_access_policy.h"
#include "web_server/internal_static_files.h"
#include "web_server/web_server_options.h"
#include "web_server/web_socket_handler.h"

namespace smile::web_server {

/// Time for the other end to read the last message and to close the connection.
constexpr std::chrono::milliseconds kLastWordTimeout{1000};

/// Connection of a client. Belongs to the server's thread.
///
/// Shared, because a pending completion of Asio may be its last owner.
class ClientConnection {
 public:
  using Time = std::chrono::steady_clock::time_point;

  virtual ~ClientConnection() = default;
  /// Fails all pending operations, so that the connection ends.
  virtual void Abort() = 0;
  /// Sends waiting messages, and continues reading if it was paused.
  virtual void Resume() {}
  /// Returns the time since which it has been waiting for a request or for its end; nullopt while
  /// it is being served.
  std::optional<Time> idle_since() const { return idle_since_; }

 protected:
  void BeginIdle() { idle_since_ = std::chrono::steady_clock::now(); }
  void EndIdle() { idle_since_.reset(); }
  /// Releases its resources and leaves the server.
  virtual void End() = 0;
  /// Runs an action; if it throws, because memory is exhausted, only this connection ends.
  template <typename Action>
  void EndOnFailure(const Action& action) {
    try {
      action();
    } catch (const std::exception&) {
      End();
    }
  }

 private:
  std::optional<Time> idle_since_;
};

/// Connections of a server, limited in number.
class Connections {
 public:
  explicit Connections(int max) : max_(static_cast<std::size_t>(max)) {}

  /// Makes room for one more: if the limit is reached, closes the connection that has been idle
  /// longest. Returns false if none is idle.
  [[nodiscard]] bool MakeRoom();
  void Add(std::shared_ptr<ClientConnection> connection) { all_.push_back(std::move(connection)); }
  void Remove(const ClientConnection* connection);
  bool is_empty() const { return all_.empty(); }

  void Resume();
  /// Closes idle connections.
  void AbortIdle();

 private:
  std::size_t max_;
  std::list<std::shared_ptr<ClientConnection>> all_;
};

/// Parts of the server that its connections use.
struct Services {
  boost::asio::io_context* context = nullptr;
  boost::asio::thread_pool* workers = nullptr;  ///< for the handler of GETs
  const WebServerOptions* options = nullptr;
  const AccessPolicy* access = nullptr;
  const StaticFiles* files = nullptr;
  WebSocketHandler* handler = nullptr;
  Connections* connections = nullptr;
  bool is_loopback = false;
  /// WebServer::Resume().
  std::function<void()> resume_all;
  WebSocketId last_id = 0;
};

/// Timer that runs `action` at a time, unless it is set again or cleared before.
class Deadline {
 public:
  explicit Deadline(boost::asio::io_context* context) : timer_(*context) {}

  template <typename Duration, typename Action>
  void Set(Duration after, Action action) {
    const unsigned number = ++*number_;
    timer_.expires_after(std::chrono::duration_cast<std::chrono::milliseconds>(after));
    timer_.async_wait([action = std::move(action), shared = number_, number](const auto&) {
      if (*shared == number) action();
    });
  }
  void Clear() {
    ++*number_;
    timer_.cancel();
  }

 private:
  boost::asio::steady_timer timer_;
  /// Counts calls of Set() and Clear(): a late handler finds another number and does nothing.
  std::shared_ptr<unsigned> number_ = std::make_shared<unsigned>(0);
};

}  // namespace smile::web_server

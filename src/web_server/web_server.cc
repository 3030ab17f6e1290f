#include "web_server/web_server.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/ssl/context.hpp>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "web_server/internal_connection.h"
#include "web_server/internal_http_connection.h"
#include "web_server/internal_listening.h"
#include "web_server/internal_tcp_link.h"

// The server's thread runs one io_context: it owns all connections, the handler's calls and all
// timers, so none of them needs a lock. Other threads reach it by net::post only (Resume, replies
// of the workers, the destructor).

namespace smile::web_server {
namespace {

using net::ip::tcp;

/// Size of the send buffer: a small one keeps poses recent, since they are chosen when there is
/// room.
constexpr int kSendBufferBytes = 256 * 1024;
/// Threads that run the handler of GETs.
constexpr std::size_t kNumWorkers = 8;
// Time for clients to receive the last messages when the server stops.
constexpr std::chrono::milliseconds kStopTimeout{500};
/// Pause after a failed accept, for example because too many files are open, which is temporary.
constexpr std::chrono::milliseconds kAcceptPause{50};

// Sets an option directly, since Asio has no type for TCP_USER_TIMEOUT. A failure is ignored: the
// options improve speed and cleaning up, and are not needed for correctness.
void SetNumber(const tcp::socket& socket, int level, int option, int number) {
  setsockopt(const_cast<tcp::socket&>(socket).native_handle(), level, option, &number,
             sizeof number);
}

}  // namespace

class WebServer::Impl {
 public:
  Impl(WebServerOptions options, WebSocketHandler* handler)
      : options_(std::move(options)),
        files_(options_.files),
        tls_(options_.tls ? LoadTls(*options_.tls) : nullptr),
        listening_(ListenAt(&context_, options_.address, options_.port, options_.first_port)),
        access_({.address = options_.address,
                 .port = listening_.port,
                 .is_loopback = listening_.is_loopback,
                 .is_tls = options_.tls.has_value(),
                 .needs_token = options_.needs_token,
                 .public_origin = options_.public_origin,
                 .public_prefix = options_.public_prefix,
                 .cookie = options_.cookie}),
        connections_(options_.limits.connections),
        services_{.context = &context_,
                  .workers = &workers_,
                  .options = &options_,
                  .access = &access_,
                  .files = &files_,
                  .handler = handler,
                  .connections = &connections_,
                  .is_loopback = listening_.is_loopback,
                  .resume_all = [this] { Resume(); }} {
    // The thread starts last, when all members exist.
    for (tcp::acceptor& acceptor : listening_.acceptors) Accept(&acceptor);
    thread_ = std::thread([this] { Serve(); });
  }

  ~Impl() {
    // Connections belong to the server's thread, so it ends them itself. Workers end afterwards: a
    // slow handler then delays only this destructor.
    net::post(context_, [this] { Stop(); });
    thread_.join();
    workers_.stop();
    workers_.join();
  }

  std::string link() const { return access_.link(); }
  std::string origin() const { return access_.origin(); }
  int port() const { return listening_.port; }
  bool is_loopback() const { return listening_.is_loopback; }

  void Resume() {
    // One turn of the server's thread handles everything before it, so calls are merged.
    if (is_resuming_.exchange(true)) return;
    net::post(context_, [this] {
      is_resuming_ = false;
      connections_.Resume();
    });
  }

 private:
  void Serve() {
    while (!context_.stopped()) {
      try {
        context_.run();
      } catch (const std::exception&) {
        // Memory is exhausted: the current operation is lost, the server continues.
      }
    }
  }

  void Accept(tcp::acceptor* acceptor) {
    acceptor->async_accept([this, acceptor](error_code error, tcp::socket socket) {
      if (is_stopping_) return;
      if (error) return AcceptLater(acceptor);
      // Without room the socket is closed by its destructor.
      if (connections_.MakeRoom()) Welcome(std::move(socket));
      Accept(acceptor);
    });
  }

  void AcceptLater(tcp::acceptor* acceptor) {
    auto timer = std::make_shared<net::steady_timer>(context_, kAcceptPause);
    timer->async_wait([this, acceptor, timer](error_code) {
      if (!is_stopping_) Accept(acceptor);
    });
  }

  void Welcome(tcp::socket socket) {
    const auto stall_ms = static_cast<int>(std::lround(1000 * options_.limits.stall_seconds));
    // Small messages are sent without delay (Nagle's algorithm off).
    SetNumber(socket, IPPROTO_TCP, TCP_NODELAY, 1);
    SetNumber(socket, SOL_SOCKET, SO_SNDBUF, kSendBufferBytes);
    // Detects clients whose machine is gone: they acknowledge nothing.
    SetNumber(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, stall_ms);
    const auto connection =
        std::make_shared<HttpConnection>(MakeTcpLink(std::move(socket), tls_.get()), &services_);
    connections_.Add(connection);
    connection->Start();
  }

  /// Sends last messages to clients that read; does not wait for the others.
  void Stop() {
    is_stopping_ = true;
    for (tcp::acceptor& acceptor : listening_.acceptors) acceptor.close();
    connections_.AbortIdle();
    connections_.Resume();
    stop_deadline_.Set(kStopTimeout, [this] { context_.stop(); });
    StopWhenEmpty();
  }

  void StopWhenEmpty() {
    // Polled, since the end of a connection has no callback; stopping takes half a second at most.
    if (connections_.is_empty()) return context_.stop();
    constexpr std::chrono::milliseconds kPause{5};
    stop_poll_.Set(kPause, [this] { StopWhenEmpty(); });
  }

  WebServerOptions options_;
  StaticFiles files_;
  net::io_context context_{1};
  std::shared_ptr<net::ssl::context> tls_;
  Listening listening_;
  AccessPolicy access_;
  net::thread_pool workers_{kNumWorkers};
  Connections connections_;
  Services services_;
  net::executor_work_guard<net::io_context::executor_type> work_{context_.get_executor()};
  Deadline stop_deadline_{&context_}, stop_poll_{&context_};
  bool is_stopping_ = false;
  std::atomic<bool> is_resuming_ = false;
  std::thread thread_;
};

WebServer::WebServer(WebServerOptions options, WebSocketHandler* handler)
    : impl_(std::make_unique<Impl>(std::move(options), handler)) {}
WebServer::~WebServer() = default;

std::string WebServer::link() const { return impl_->link(); }
std::string WebServer::origin() const { return impl_->origin(); }
int WebServer::port() const { return impl_->port(); }
bool WebServer::is_loopback() const { return impl_->is_loopback(); }
void WebServer::Resume() { impl_->Resume(); }

}  // namespace smile::web_server

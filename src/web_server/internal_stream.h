#pragma once

#include <array>
#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace smile::web_server {

namespace net = boost::asio;
using boost::system::error_code;

/// Connected pair of byte queues: TCP, TLS over TCP, or memory.
///
/// At most one operation of each kind is pending. A completion is never called from within the
/// function that started the operation.
class Link {
 public:
  using Completion = std::function<void(error_code, std::size_t)>;
  /// Pieces of memory to be sent one after the other; unused ones are empty.
  using Buffers = std::array<net::const_buffer, 4>;

  virtual ~Link() = default;
  /// Opens the link: with TLS, performs the handshake.
  virtual void Open(std::function<void(error_code)> completion) = 0;
  virtual void Read(net::mutable_buffer buffer, Completion completion) = 0;
  virtual void Write(const Buffers& buffers, Completion completion) = 0;
  /// Announces the end of sending; completes when the other end has ended as well.
  virtual void Finish(std::function<void()> completion) = 0;
  /// Fails the pending read.
  virtual void CancelRead() = 0;
  /// Fails all pending operations.
  virtual void Close() = 0;
};

/// Adapter of a link to Asio and Beast: their templates are instantiated for this type only,
/// whatever the kind of link. A link that accepts nothing for `stall` is closed.
class Stream {
 public:
  using executor_type = net::io_context::executor_type;

  Stream(net::io_context* context, std::unique_ptr<Link> link, std::chrono::milliseconds stall)
      : context_(context),
        link_(std::move(link)),
        stall_(stall),
        timer_(std::make_unique<net::steady_timer>(*context)) {}

  executor_type get_executor() const noexcept { return context_->get_executor(); }
  Link& link() { return *link_; }
  /// Returns the number of bytes read so far.
  std::uint64_t bytes_read() const { return *bytes_read_; }
  /// Called before each read of the link.
  void set_before_read(std::function<void()> before_read) { before_read_ = std::move(before_read); }
  /// Makes the next reads return these bytes first.
  void PutBack(std::string_view bytes) { put_back_.insert(0, bytes); }

  template <typename Buffers, typename Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    return net::async_initiate<Handler, void(error_code, std::size_t)>(
        [this](auto&& done, net::mutable_buffer buffer) {
          Read(buffer, Erased(std::forward<decltype(done)>(done)));
        },
        handler, FirstOf<net::mutable_buffer>(buffers));
  }
  template <typename Buffers, typename Handler>
  auto async_write_some(const Buffers& buffers, Handler&& handler) {
    return net::async_initiate<Handler, void(error_code, std::size_t)>(
        [this](auto&& done, const Link::Buffers& parts) {
          Write(parts, Erased(std::forward<decltype(done)>(done)));
        },
        handler, AllOf(buffers));
  }

 private:
  void Read(net::mutable_buffer buffer, Link::Completion completion);
  void Write(const Link::Buffers& buffers, Link::Completion completion);

  /// Makes a std::function from a handler that can only be moved.
  template <typename Handler>
  static Link::Completion Erased(Handler&& handler) {
    auto shared = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler));
    return [shared](error_code error, std::size_t count) { std::move (*shared)(error, count); };
  }
  template <typename Buffer, typename Buffers>
  static Buffer FirstOf(const Buffers& buffers) {
    for (auto it = net::buffer_sequence_begin(buffers); it != net::buffer_sequence_end(buffers);
         ++it) {
      if (Buffer buffer(*it); buffer.size() > 0) return buffer;
    }
    return {};
  }
  /// Maximal number of buffers that are written at once.
  template <typename Buffers>
  static Link::Buffers AllOf(const Buffers& buffers) {
    Link::Buffers parts;
    std::size_t count = 0;
    for (auto it = net::buffer_sequence_begin(buffers);
         it != net::buffer_sequence_end(buffers) && count < parts.size(); ++it) {
      if (net::const_buffer part(*it); part.size() > 0) parts[count++] = part;
    }
    return parts;
  }

  net::io_context* context_;
  std::shared_ptr<Link> link_;  ///< shared with the timer's handler, which may come late
  std::chrono::milliseconds stall_;
  std::unique_ptr<net::steady_timer> timer_;  ///< of the write that is pending
  std::unique_ptr<std::uint64_t> bytes_read_ = std::make_unique<std::uint64_t>(0);
  std::string put_back_;
  std::function<void()> before_read_;
};

/// Required by Beast at the end of a WebSocket. The connection ends the link itself.
void teardown(boost::beast::role_type role, Stream& stream, error_code& error);
template <typename Handler>
void async_teardown(boost::beast::role_type, Stream& stream, Handler&& handler) {
  net::post(stream.get_executor(),
            [done = std::forward<Handler>(handler)]() mutable { done(error_code()); });
}
/// Called by Beast to end a link immediately; part of its interface for streams of other types.
void beast_close_socket(Stream& stream);

}  // namespace smile::web_server

#include "web_server/internal_stream.h"

#include <memory>
#include <utility>

// The only stream type for which Beast is instantiated. It adds three things to a Link: bytes that
// were read too early by the HTTP parser, a count of all bytes read, and a limit on the time of
// each write.

namespace smile::web_server {

void Stream::Read(net::mutable_buffer buffer, Link::Completion completion) {
  if (before_read_) before_read_();
  // The counter is on the heap, since the stream itself is moved from HttpConnection to WebSocket.
  auto counted = [total = bytes_read_.get(), completion = std::move(completion)](
                     error_code error, std::size_t count) {
    *total += count;
    completion(error, count);
  };
  // Bytes that were put back come first; they complete later, as completions must not run inside
  // Read().
  if (put_back_.empty()) return link_->Read(buffer, std::move(counted));
  const std::size_t count = net::buffer_copy(buffer, net::buffer(put_back_));
  put_back_.erase(0, count);
  net::post(*context_, [counted = std::move(counted), count] { counted(error_code(), count); });
}

void Stream::Write(const Link::Buffers& buffers, Link::Completion completion) {
  // Per write and not per message: a large message to a slow client that accepts some bytes at
  // least every `stall_` is not cut off.
  timer_->expires_after(stall_);
  // The timer must not keep the link alive.
  timer_->async_wait([weak = std::weak_ptr<Link>(link_)](error_code error) {
    const std::shared_ptr<Link> link = weak.lock();
    if (!error && link) link->Close();
  });
  link_->Write(buffers, [timer = timer_.get(), completion = std::move(completion)](
                            error_code error, std::size_t count) {
    timer->cancel();
    completion(error, count);
  });
}

void teardown(boost::beast::role_type, Stream& stream, error_code&) { stream.link().Close(); }

void beast_close_socket(Stream& stream) { stream.link().Close(); }

}  // namespace smile::web_server

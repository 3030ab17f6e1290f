#include "web_server/internal_relay.h"

#include <algorithm>
#include <boost/asio/write.hpp>
#include <set>
#include <utility>

// Two chains of asynchronous steps, one in each direction: read a piece, write it, and again. A
// piece is read only when the one before has been written, so a slow end slows the other one down
// and nothing piles up here. Whatever fails ends both.

namespace smile::web_server {
namespace {

using net::ip::tcp;

/// Names of headers that are about the client's own connection.
bool IsOfConnection(std::string_view name) {
  static const std::set<std::string_view> kNames{"host",       "origin",     "cookie",
                                                 "connection", "keep-alive", "content-length"};
  return kNames.contains(name);
}

/// Encodes the segments of a path.
std::string EncodedPath(std::string_view path) {
  std::string encoded;
  while (!path.empty()) {
    const std::size_t size = std::min(path.find('/'), path.size());
    encoded += PercentEncoded(path.substr(0, size));
    if (size < path.size()) encoded += '/';
    path.remove_prefix(std::min(size + 1, path.size()));
  }
  return encoded;
}

}  // namespace

std::string RelayedHead(const HttpRequest& request, const RelayTarget& target) {
  std::string head = request.method + " " + EncodedPath(target.path) +
                     " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(target.port) + "\r\n";
  const bool is_upgrade = !request.Header("upgrade").empty();
  head += is_upgrade ? "Connection: Upgrade\r\n" : "Connection: close\r\n";
  for (const auto& [name, value] : request.headers) {
    if (!IsOfConnection(name)) head += name + ": " + value + "\r\n";
  }
  return head + "\r\n";
}

Relay::Relay(Stream stream, std::string head, int port, Services* services)
    : services_(services),
      client_(std::move(stream)),
      target_(*services->context),
      head_(std::move(head)),
      port_(port) {}

void Relay::Start() {
  const tcp::endpoint target(net::ip::address_v4::loopback(), static_cast<std::uint16_t>(port_));
  target_.async_connect(target, [self = shared_from_this()](error_code error) {
    if (error) return self->End();
    // Small messages are passed on without delay (Nagle's algorithm off).
    error_code ignored;
    self->target_.set_option(tcp::no_delay(true), ignored);
    self->SendToTarget(self->head_);
    self->ReadTarget();
  });
}

void Relay::SendToTarget(std::string_view bytes) {
  net::async_write(target_, net::buffer(bytes.data(), bytes.size()),
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (error) return self->End();
                     self->ReadClient();
                   });
}

void Relay::ReadClient() {
  client_.async_read_some(net::buffer(from_client_),
                          [self = shared_from_this()](error_code error, std::size_t count) {
                            if (error) return self->End();
                            self->SendToTarget({self->from_client_.data(), count});
                          });
}

void Relay::ReadTarget() {
  target_.async_read_some(
      net::buffer(from_target_), [self = shared_from_this()](error_code error, std::size_t count) {
        if (error) return self->End();
        net::async_write(self->client_, net::buffer(self->from_target_.data(), count),
                         [self](error_code write_error, std::size_t) {
                           if (write_error) return self->End();
                           self->ReadTarget();
                         });
      });
}

void Relay::Abort() {
  error_code ignored;
  target_.close(ignored);
  client_.link().Close();
}

void Relay::End() {
  Abort();
  services_->connections->Remove(this);
}

}  // namespace smile::web_server

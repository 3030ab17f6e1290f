#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <string>

#include "web_server/internal_connection.h"
#include "web_server/internal_http.h"
#include "web_server/internal_stream.h"
#include "web_server/web_server_options.h"

namespace smile::web_server {

/// Returns the head of a relayed request: with the path and the address of the target, and without
/// `Origin`, cookies and further requests on the connection. Upgrades to a WebSocket stay upgrades.
std::string RelayedHead(const HttpRequest& request, const RelayTarget& target);

/// Connection that is relayed to a server of this machine: after the head, all bytes are passed on
/// in both directions, as fast as the slower end takes them.
class Relay : public ClientConnection, public std::enable_shared_from_this<Relay> {
 public:
  /// @param head  RelayedHead() of the request that the client has sent.
  Relay(Stream stream, std::string head, int port, Services* services);

  void Start();
  void Abort() override;

 private:
  void ReadClient();
  void ReadTarget();
  /// Passes on to the target.
  void SendToTarget(std::string_view bytes);
  void End() override;

  Services* services_;
  Stream client_;
  net::ip::tcp::socket target_;
  std::string head_;
  int port_;
  std::array<char, 16384> from_client_{}, from_target_{};
};

}  // namespace smile::web_server

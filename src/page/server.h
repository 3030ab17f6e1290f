#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "page/requests.h"
#include "web_server/http.h"
#include "web_server/web_server.h"

namespace smile::page {

/// Limits on resources of clients.
struct ServerLimits {
  std::size_t message_bytes = 1 << 20;
  double requests_per_second = 200;  ///< of one client
  int clients = 64;
  double hello_seconds = 10;  ///< until the first request; less if the limit of clients is reached
  int connections = 256;      ///< of clients and of browsers that load the page
  std::size_t outbox_bytes = 8 << 20;  ///< of messages that wait for one client
  double stall_seconds = 10;           ///< for which a client may receive nothing
  double silence_seconds =
      30;  ///< of inactivity of the asked controller, until control may be taken by force
};

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< reachable from other machines: a token is required
  int port = 0;                       ///< 0: the first free one from 8470 on
  std::filesystem::path page;
  web_server::HttpHandler get;  ///< for all other paths; may be empty
  std::string public_prefix;    ///< of paths that need no token, see WebServerOptions
  /// Pages of other origins may show this one in a frame. Only for pages that can change nothing:
  /// otherwise a foreign page could make people click in it.
  bool may_be_framed = false;
  ServerLimits limits;
  std::optional<web_server::TlsFiles> tls;  ///< the page is at https:// and wss://
};

/// Poses of the frames that moved; a key has all frames.
struct Poses {
  std::uint32_t scene = 0, tick = 0;
  bool is_key = false;
  std::vector<std::uint32_t> frames;
  std::vector<float> values;  ///< seven a frame: x, y, z [units], qx, qy, qz, qw
};

/// Server: serves the page and its clients. Its threads only queue requests and send messages; none
/// accesses a session.
class Server {
 public:
  /// Starts to serve.
  /// @throws std::runtime_error if no port is free or the page is missing.
  explicit Server(ServerOptions options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Returns the link, such as `http://127.0.0.1:8470/`, with a token if one is required.
  std::string link() const;
  /// Returns the beginning of all links: `http://127.0.0.1:8470`.
  std::string origin() const;
  /// Returns true if no other machine can connect.
  bool is_loopback() const;

  /// Returns the requests since the last call: all of the controller, in order, and one of each
  /// watcher, so that many watchers do not delay the controller. The server itself carries out
  /// hello, ping and requests about control.
  std::vector<Request> TakeRequests();
  /// Returns the clients that have said hello since the last call: the caller sends them
  /// everything.
  std::vector<ClientId> TakeNewClients();
  bool IsController(ClientId client) const;

  /// Sends a message. A reply marks its request as executed; poses sent from then on acknowledge
  /// it.
  void Send(ClientId client, const Json& message);
  /// Sends to all clients that have received everything.
  void SendToAll(const Json& message);
  /// Sends poses. A client that missed some receives each frame that moved since the last one it
  /// received.
  void SendPoses(const Poses& poses);
  /// Sends a view. Slow clients miss views.
  void SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::page

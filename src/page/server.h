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

/// What nobody may exceed.
struct ServerLimits {
  std::size_t message_bytes = 1 << 20;
  double requests_per_second = 200;  ///< of one client
  int clients = 64;
  double hello_seconds = 10;           ///< for the first request; when all places are taken, less
  int connections = 256;               ///< of clients, and of browsers that load the page
  std::size_t outbox_bytes = 8 << 20;  ///< of messages that wait for one client
  double stall_seconds = 10;           ///< so long a client may take nothing
  double silence_seconds =
      30;  ///< of a controller who was asked, until control may be taken by force
};

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< elsewhere than on this machine, a token is asked for
  int port = 0;                       ///< 0: the first free one from 8470 on
  std::filesystem::path page;
  web_server::HttpHandler get;  ///< what is no file of the page; may be empty
  ServerLimits limits;
  std::optional<web_server::TlsFiles> tls;  ///< the page is at https:// and wss://
};

/// Where frames are that moved; of all of them in a key.
struct Poses {
  std::uint32_t scene = 0, tick = 0;
  bool is_key = false;
  std::vector<std::uint32_t> frames;
  std::vector<float> values;  ///< seven a frame: x, y, z [units], qx, qy, qz, qw
};

/// The page and its clients on a web server. Its threads deliver requests and take messages to be
/// sent; none touches a session.
class Server {
 public:
  /// Serves at once. @throws std::runtime_error when no port is free or there is no page.
  explicit Server(ServerOptions options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// `http://127.0.0.1:8470/`, with the token where one is needed.
  std::string link() const;

  /// What is asked for since this was last asked: all of the controller's requests, in order, and
  /// one of each watcher, so that no crowd delays who works. Hellos, pings and control are the
  /// server's own.
  std::vector<Request> TakeRequests();
  /// Returns the clients that have said hello since the last call: the caller sends them
  /// everything.
  std::vector<ClientId> TakeNewClients();
  bool IsController(ClientId client) const;

  /// A reply marks its request as carried out; poses sent from then on acknowledge it.
  void Send(ClientId client, const Json& message);
  /// Sends to all clients that have received everything.
  void SendToAll(const Json& message);
  /// A client that missed some poses receives each frame that moved since the last one it received.
  void SendPoses(const Poses& poses);
  /// Clients that do not keep up miss views.
  void SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::page

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "studio/requests.h"

namespace smile::studio {

/// What a GET is answered with; nullopt where there is nothing.
struct HttpAnswer {
  std::string type;  ///< `application/json`, `image/png`, …
  std::string body;
  std::string file_name;  ///< to be saved under; empty: to be shown
};
/// Called from several threads at once.
using HttpHandler = std::function<std::optional<HttpAnswer>(const std::string& path)>;

struct ServerOptions {
  std::string address = "127.0.0.1";
  int port = 0;  ///< 0: the first free one from 8470 on
  std::filesystem::path page;
  HttpHandler get;
};

/// A frame for one client or all: text, or bytes of which only the newest matters.
struct Poses {
  std::uint32_t scene = 0, tick = 0;
  bool is_key = false;
  std::vector<std::uint32_t> frames;
  std::vector<float> values;  ///< seven a frame: x, y, z [units], qx, qy, qz, qw
};

/// The page's door: HTTP and WebSocket. Clients come and go; whoever stalls, floods or lies harms
/// nobody else. Its threads hand over requests and take what is to be sent; none touches a session.
class Server {
 public:
  /// Serves at once. @throws std::runtime_error when no port is free or there is no page.
  explicit Server(ServerOptions options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// `http://127.0.0.1:8470/`, with the token where one is needed.
  std::string link() const;

  /// Requests since this was last asked, in order; hellos, pings and control are the server's own.
  std::vector<Request> TakeRequests();
  /// Clients that have said hello since this was last asked: tell them everything.
  std::vector<ClientId> TakeNewClients();
  bool IsController(ClientId client) const;

  void Send(ClientId client, const Json& message);
  void SendToAll(const Json& message);
  /// `acks`: each client's own last request is filled in.
  void SendPoses(const Poses& poses);
  void SendView(std::uint32_t scene, std::uint32_t tick, std::string png, bool is_recorded);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio

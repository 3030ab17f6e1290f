#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "web_server/http.h"
#include "web_server/web_socket_handler.h"

namespace smile::web_server {

/// Bounds on what clients may use.
struct Limits {
  std::size_t message_bytes = 1 << 20;  ///< of a WebSocket message
  double messages_per_second = 200;     ///< of one WebSocket; its frame heads count, too
  int connections = 256;                ///< when all are taken, the longest idle one is closed
  double head_seconds = 10;             ///< for the head of a request, and the keys of TLS
  double keep_alive_seconds = 30;       ///< between two requests of a connection
  double stall_seconds = 10;            ///< during which a client may accept no byte of a write
};

/// Files in PEM format: the server speaks TLS only.
struct TlsFiles {
  std::filesystem::path certificate;  ///< chain, the server's own first
  std::filesystem::path key;          ///< without a password
};

struct WebServerOptions {
  /// Where to listen: a number like `127.0.0.1` or `::1`, or a name of this machine: then at all
  /// addresses it resolves to. `localhost` is both of these numbers. Clients of addresses that are
  /// reachable from other machines need the token in link().
  std::string address = "127.0.0.1";
  int port = 0;  ///< 0: the first free one of `first_port` and the hundred after it
  int first_port = 8470;
  std::string cookie = "token";  ///< name of the token's cookie, followed by the port
  std::filesystem::path files;   ///< folder that is served, from memory; `/` is its index.html
  HttpHandler get;               ///< answers paths that name no file; may be empty
  std::string web_socket_path = "/ws";
  std::optional<TlsFiles> tls;
  Limits limits;
};

/// HTTP/1.1 server: files, a handler of GETs, and WebSockets.
///
/// Requests must be for this machine (`Host`) and, if a page sent them, for the page's own server
/// (`Origin`). One thread serves all connections; some more run the handler of GETs. A client that
/// stalls, floods or violates the protocol loses its connection and delays no other.
class WebServer {
 public:
  /// Serves at once. `handler` must outlive the server.
  /// @throws std::runtime_error if no port is free, a file is missing, or a TLS file is wrong.
  WebServer(WebServerOptions options, WebSocketHandler* handler);
  /// Sends what the handler still has, for half a second at most.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// `http://127.0.0.1:8470/`, with the token where one is needed.
  std::string link() const;
  /// Asks the handler for messages to be sent, and whether clients that it made wait may send
  /// again. May be called from any thread; returns at once.
  void Resume();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::web_server

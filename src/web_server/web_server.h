#pragma once

#include <memory>
#include <string>

#include "web_server/web_server_options.h"
#include "web_server/web_socket_handler.h"

namespace smile::web_server {

/// HTTP/1.1 server: files, a handler of GETs, and WebSockets.
///
/// Requests must be for this machine (`Host`) and, if a page sent them, for the page's own server
/// (`Origin`). One thread serves all connections; some more run the handler of GETs. A client that
/// stalls, floods or violates the protocol loses its connection and delays no other.
class WebServer {
 public:
  /// Starts to serve. `handler` must outlive the server.
  /// @throws std::runtime_error if no port is free, a file is missing, or a TLS file is invalid.
  WebServer(WebServerOptions options, WebSocketHandler* handler);
  /// Sends the remaining messages of the handler, for half a second at most.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Returns the link, such as `http://127.0.0.1:8470/`, with the token if one is required.
  std::string link() const;
  /// Returns the beginning of all links: `http://127.0.0.1:8470`.
  std::string origin() const;
  /// Returns the port at which it listens on this machine; behind a proxy links do not contain it.
  int port() const;
  /// Returns true if no other machine can connect.
  bool is_loopback() const;
  /// Asks the handler for messages, and if paused clients may send again. May be called from any
  /// thread; returns at once.
  void Resume();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::web_server

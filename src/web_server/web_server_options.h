#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "web_server/http.h"

namespace smile::web_server {

/// Limits on resources of clients.
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

/// Server of this machine to which a request is passed on.
struct RelayTarget {
  int port = 0;      ///< at 127.0.0.1
  std::string path;  ///< of the request there; decoded

  bool operator==(const RelayTarget&) const = default;
};

/// Returns where a request for a path is passed on, with its WebSocket if it asks for one; nullopt
/// if this server answers itself. Called in the server's thread; may not wait.
using RelayFinder = std::function<std::optional<RelayTarget>(const std::string& path)>;

struct WebServerOptions {
  /// Address to listen at: a number like `127.0.0.1` or `::1`, or a name of this machine: then at
  /// all addresses to which it resolves. `localhost` is both of these numbers. Clients of addresses
  /// that are reachable from other machines need the token in link().
  std::string address = "127.0.0.1";
  int port = 0;  ///< 0: the first free one of `first_port` and the hundred after it
  int first_port = 8470;
  std::string cookie = "token";  ///< name of the token's cookie, followed by the port
  std::filesystem::path files;   ///< folder that is served, from memory; `/` is its index.html
  HttpHandler get;               ///< answers paths that name no file; may be empty
  RelayFinder relay;             ///< may be empty
  /// Clients of other machines need the token in link(). False if paths contain secrets of their
  /// own.
  bool needs_token = true;
  /// Prefix of paths that need no token in any case: what they lead to is public, or they contain
  /// secrets of their own. Empty: none.
  std::string public_prefix;
  /// Where browsers find this server if a proxy passes their requests on, as from OriginOf(); empty
  /// without one. As the proxy's clients may be anywhere, paths must contain secrets of their own.
  std::string public_origin;
  std::string web_socket_path = "/ws";
  bool may_be_framed = false;  ///< pages of other origins may show the files in a frame
  std::optional<TlsFiles> tls;
  Limits limits;
};

}  // namespace smile::web_server

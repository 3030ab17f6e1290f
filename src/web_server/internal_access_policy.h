#pragma once

#include <string>

#include "web_server/internal_http.h"

namespace smile::web_server {

/// Access policy: decides which requests are answered. Pages of other sites are refused, even if
/// the user's own browser sends them: `Host` must be this machine, so that no foreign name leads
/// here, and `Origin` must be this server; or both the proxy in front of it. If other machines can
/// connect, the token of link() is required as well.
class AccessPolicy {
 public:
  struct Config {
    std::string address;  ///< at which the server listens
    int port = 0;
    bool is_loopback = false;  ///< no other machine can connect
    bool is_tls = false;
    bool needs_token = true;    ///< unless it is_loopback
    std::string public_origin;  ///< of a proxy in front of the server; empty without one
    std::string public_prefix;  ///< of the paths that need no token; empty without any
    std::string cookie;         ///< name of the token's cookie, followed by the port
  };
  explicit AccessPolicy(Config config);

  /// Returns the link, such as `http://127.0.0.1:8470/`, with the token if one is required.
  std::string link() const;
  /// Returns the beginning of all links: `http://127.0.0.1:8470`.
  std::string origin() const;
  /// @throws HttpError if the request must not be answered.
  void Check(const HttpRequest& request) const;
  /// Returns the value of `Set-Cookie` by which a browser stores the token of this request's query;
  /// empty if the query has none.
  std::string CookieFor(const HttpRequest& request) const;

 private:
  bool IsOwnHost(std::string_view host) const;
  std::string scheme() const { return config_.is_tls ? "https://" : "http://"; }
  std::string cookie_name() const { return config_.cookie + "_" + std::to_string(config_.port); }

  Config config_;
  std::string machine_;
  std::string token_;  ///< empty: not required
};

}  // namespace smile::web_server

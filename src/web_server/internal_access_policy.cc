#include "web_server/internal_access_policy.h"

#include <arpa/inet.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "web_server/secret.h"

// The rules of access, checked for each request before anything else. They protect from three
// parties: pages of other sites in the user's own browser (Origin), foreign names that resolve to
// this machine (Host), and other machines and users of the network (token).

namespace smile::web_server {
namespace {

std::string NameOfMachine() {
  std::array<char, 256> name{};
  // One byte less, so that a name that is cut off still ends with a zero.
  gethostname(name.data(), name.size() - 1);
  return LowerCase(name.data());
}

/// Returns the host name of a `Host` header without its port, which differs behind a tunnel. An
/// IPv6 number loses its brackets.
std::string HostNameIn(std::string_view host) {
  if (host.starts_with('[')) return LowerCase(host.substr(1, host.find(']') - 1));
  return LowerCase(host.substr(0, host.find(':')));
}

bool IsAddressNumber(const std::string& name) {
  in6_addr address{};
  return inet_pton(AF_INET, name.c_str(), &address) == 1 ||
         inet_pton(AF_INET6, name.c_str(), &address) == 1;
}

}  // namespace

AccessPolicy::AccessPolicy(Config config)
    : config_(std::move(config)),
      machine_(NameOfMachine()),
      token_(config_.is_loopback || !config_.needs_token ? "" : RandomSecret()) {}

std::string AccessPolicy::link() const {
  if (!config_.public_origin.empty()) return origin() + "/";
  return origin() + "/" + (token_.empty() ? "" : "?token=" + token_);
}

std::string AccessPolicy::origin() const {
  if (!config_.public_origin.empty()) return config_.public_origin;
  std::string host = config_.address;
  // All addresses of this machine are no address to connect to; its name usually is one.
  if (host == "0.0.0.0" || host == "::") {
    host = machine_;
  } else if (host.find(':') != std::string::npos) {
    host = "[" + host + "]";
  }
  return scheme() + host + ":" + std::to_string(config_.port);
}

bool AccessPolicy::IsOwnHost(std::string_view host) const {
  const std::string name = HostNameIn(host);
  // Browsers resolve `localhost` themselves, so no foreign server can claim it.
  if (name == "localhost" || name == LowerCase(config_.address)) return true;
  if (!config_.public_origin.empty() && config_.public_origin.ends_with("://" + LowerCase(host))) {
    return true;
  }
  // Protection from DNS rebinding: a foreign name can be made to resolve to this machine, a number
  // cannot.
  if (!config_.is_loopback) return name == machine_ || IsAddressNumber(name);
  return name == "::1" || (name.starts_with("127.") && IsAddressNumber(name));
}

void AccessPolicy::Check(const HttpRequest& request) const {
  const std::string_view host = request.Header("host");
  if (!IsOwnHost(host)) throw HttpError(403, "this server does not have the requested address");
  // Browsers send `Origin` with requests from pages; requests of other programs have none.
  const std::string_view origin = request.Header("origin");
  // A proxy may pass the name of the public server on, or replace it by that of this one.
  const bool is_by_proxy =
      !config_.public_origin.empty() && LowerCase(origin) == config_.public_origin;
  if (!origin.empty() && !is_by_proxy && LowerCase(origin) != scheme() + LowerCase(host)) {
    throw HttpError(403, "pages of other sites have no access to this server");
  }
  const bool is_public =
      !config_.public_prefix.empty() && request.path.starts_with(config_.public_prefix);
  // A browser presents the token once in the link and afterwards in a cookie; other programs may
  // put it into each request.
  if (token_.empty() || is_public || IsSecret(request.Parameter("token"), token_) ||
      IsSecret(request.Cookie(cookie_name()), token_)) {
    return;
  }
  throw HttpError(403, "open the link that the program printed: it contains a token");
}

std::string AccessPolicy::CookieFor(const HttpRequest& request) const {
  if (token_.empty() || !IsSecret(request.Parameter("token"), token_)) return {};
  // Scripts cannot read the cookie, and other sites cannot make the browser send it. Its name has
  // the port, since browsers share cookies among all ports of a machine.
  return cookie_name() + "=" + token_ + "; HttpOnly; SameSite=Strict; Path=/" +
         (config_.is_tls ? "; Secure" : "");
}

}  // namespace smile::web_server

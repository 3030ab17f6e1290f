#include "studio/internal_doorkeeper.h"

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace smile::studio {
namespace {

/// 128 bits that nobody can guess, as 32 digits.
std::string RandomToken() {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("there are no random numbers for the studio's token");
  }
  std::string token;
  for (const unsigned char byte : bytes)
    token.append({kHexDigits[byte >> 4], kHexDigits[byte & 15]});
  return token;
}

std::string NameOfMachine() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return LowerCase(name.data());
}

/// `Host` without its port: a tunnel may have another one. An IPv6 number loses its brackets.
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

Doorkeeper::Doorkeeper(std::string address, int port, bool is_loopback)
    : address_(std::move(address)),
      machine_(NameOfMachine()),
      port_(port),
      is_loopback_(is_loopback),
      token_(is_loopback ? "" : RandomToken()) {}

std::string Doorkeeper::link() const {
  std::string host = address_;
  if (address_ == "0.0.0.0" || address_ == "::") {
    host = machine_;
  } else if (address_.find(':') != std::string::npos) {
    host = "[" + address_ + "]";
  }
  return "http://" + host + ":" + std::to_string(port_) + "/" +
         (token_.empty() ? "" : "?token=" + token_);
}

bool Doorkeeper::IsOurs(std::string_view host) const {
  const std::string name = HostNameIn(host);
  if (name == "localhost" || name == LowerCase(address_)) return true;
  // Only a name can be made to lead elsewhere, a number cannot.
  if (!is_loopback_) return name == machine_ || IsAddressNumber(name);
  return name == "::1" || (name.starts_with("127.") && IsAddressNumber(name));
}

bool Doorkeeper::IsToken(std::string_view text) const {
  // Takes as long for a wrong one, whatever of it is right.
  if (text.size() != token_.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < token_.size(); ++k) {
    difference |= static_cast<unsigned char>(text[k]) ^ static_cast<unsigned char>(token_[k]);
  }
  return difference == 0;
}

void Doorkeeper::Check(const HttpRequest& request) const {
  const std::string_view host = request.Header("host");
  if (!IsOurs(host)) throw HttpError(403, "the studio is not at the address you asked for");
  const std::string_view origin = request.Header("origin");
  if (!origin.empty() && LowerCase(origin) != "http://" + LowerCase(host)) {
    throw HttpError(403, "pages of other sites have no access to the studio");
  }
  if (token_.empty() || IsToken(request.Parameter("token")) ||
      IsToken(request.Cookie(cookie_name()))) {
    return;
  }
  throw HttpError(403, "open the link that `smile studio` printed: it has a token in it");
}

std::string Doorkeeper::CookieFor(const HttpRequest& request) const {
  if (token_.empty() || !IsToken(request.Parameter("token"))) return {};
  return cookie_name() + "=" + token_ + "; HttpOnly; SameSite=Strict; Path=/";
}

}  // namespace smile::studio

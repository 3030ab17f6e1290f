#include "brain/internal_served_brain.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>

#include "base/diagnostic.h"
#include "brain/brain_process.h"
#include "process/unique_fd.h"

namespace smile::brain {
namespace {

constexpr std::string_view kTcp = "tcp://";
constexpr std::string_view kUnix = "unix:";
constexpr int kConnectSliceMs = 20;  ///< of waiting; how late a cancellation may be noticed

using Connected = std::variant<MessageChannel, ChannelFault>;

[[noreturn]] void RejectAddress(const std::string& brain, const std::string& message) {
  throw InputError(Diagnostic{.file = brain, .line = 0, .element = {}, .message = message});
}

bool IsPort(std::string_view text) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port >= 1 && port <= 65535;
}

/// Returns the fault of a wait that is over; nullopt while it goes on.
std::optional<ChannelFault> EndOfWait(const process::WaitLimit& limit) {
  if (limit.IsCancelled()) return ChannelFault{ChannelFault::Kind::kCancelled, "canceled"};
  if (limit.HasPassed()) return ChannelFault{ChannelFault::Kind::kTimedOut, "timed out"};
  return std::nullopt;
}

ChannelFault FailedConnection(int reason) {
  return {ChannelFault::Kind::kClosed, std::strerror(reason)};
}

/// Waits until a connection that is on its way has arrived or failed.
std::optional<ChannelFault> WaitForConnection(int fd, const process::WaitLimit& limit) {
  pollfd watched{fd, POLLOUT, 0};
  while (::poll(&watched, 1, limit.SliceMs(kConnectSliceMs)) <= 0) {
    if (auto fault = EndOfWait(limit)) return fault;
  }
  int reason = 0;
  socklen_t size = sizeof reason;
  ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &reason, &size);
  return reason == 0 ? std::nullopt : std::optional(FailedConnection(reason));
}

Connected ConnectSocket(int family, const sockaddr* name, socklen_t size,
                        const process::WaitLimit& limit) {
  process::UniqueFd fd(::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!fd) return FailedConnection(errno);
  // Questions and answers alternate, so none of them may wait to be sent with the next.
  const int yes = 1;
  if (family != AF_UNIX) ::setsockopt(fd.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  while (::connect(fd.get(), name, size) != 0) {
    if (errno == EINPROGRESS) {
      if (auto fault = WaitForConnection(fd.get(), limit)) return std::move(*fault);
      break;
    }
    // A Unix socket answers so while as many wait as its queue holds.
    if (errno != EAGAIN && errno != EINTR) return FailedConnection(errno);
    if (auto fault = EndOfWait(limit)) return std::move(*fault);
    std::this_thread::sleep_for(std::chrono::milliseconds(kConnectSliceMs));
  }
  return MessageChannel(std::move(fd));
}

Connected ConnectToHost(const ServerAddress& address, const process::WaitLimit& limit) {
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* first = nullptr;
  const int failure = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &first);
  if (failure != 0) {
    return ChannelFault{ChannelFault::Kind::kClosed,
                        "the host '" + address.host + "' is unknown: " + ::gai_strerror(failure)};
  }
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> all(first, &::freeaddrinfo);
  Connected result = FailedConnection(EADDRNOTAVAIL);
  for (const addrinfo* one = first; one != nullptr; one = one->ai_next) {
    result = ConnectSocket(one->ai_family, one->ai_addr, one->ai_addrlen, limit);
    const auto* fault = std::get_if<ChannelFault>(&result);
    if (fault == nullptr || fault->kind != ChannelFault::Kind::kClosed) break;
  }
  return result;
}

/// Parses `unix:PATH`.
ServerAddress AddressOfPath(const std::string& brain) {
  ServerAddress address{.text = brain, .host = {}, .port = {}, .path = brain.substr(kUnix.size())};
  constexpr std::size_t kLongest = sizeof(sockaddr_un::sun_path) - 1;
  if (address.path.empty() || address.path.size() > kLongest) {
    RejectAddress(brain, "the path has " + std::to_string(address.path.size()) +
                             " letters, expected unix:PATH with 1 to " + std::to_string(kLongest));
  }
  return address;
}

/// Parses `tcp://HOST:PORT`.
ServerAddress AddressOfHost(const std::string& brain) {
  const std::string rest = brain.substr(kTcp.size());
  const std::size_t colon = rest.rfind(':');
  ServerAddress address{.text = brain, .host = rest.substr(0, colon), .port = {}, .path = {}};
  // Addresses of version 6 contain colons, and stand in brackets.
  const bool has_brackets = address.host.starts_with('[') && address.host.ends_with(']');
  if (has_brackets) address.host = address.host.substr(1, address.host.size() - 2);
  address.port = colon == std::string::npos ? "" : rest.substr(colon + 1);
  if (address.host.empty() || !IsPort(address.port) ||
      (!has_brackets && address.host.find(':') != std::string::npos)) {
    RejectAddress(brain, "not an address, expected tcp://HOST:PORT with a port from 1 to 65535");
  }
  return address;
}

}  // namespace

bool IsServedBrain(const std::filesystem::path& brain) {
  const std::string& text = brain.native();
  return text.starts_with(kTcp) || text.starts_with(kUnix);
}

std::optional<ServerAddress> ParseServerAddress(const std::string& brain) {
  if (!IsServedBrain(brain)) return std::nullopt;
  return brain.starts_with(kUnix) ? AddressOfPath(brain) : AddressOfHost(brain);
}

Connected ConnectTo(const ServerAddress& address, const process::WaitLimit& limit) {
  if (address.path.empty()) return ConnectToHost(address, limit);
  sockaddr_un name = {};
  name.sun_family = AF_UNIX;
  address.path.copy(name.sun_path, sizeof name.sun_path - 1);
  return ConnectSocket(AF_UNIX, reinterpret_cast<const sockaddr*>(&name), sizeof name, limit);
}

}  // namespace smile::brain

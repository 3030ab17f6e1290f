#include "studio/internal_socket.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <thread>

namespace smile::studio {
namespace {

constexpr int kMaxWaiting = 64;
/// How much may be on its way to a client: what is sent later is fresher.
constexpr int kSendBufferBytes = 256 * 1024;
constexpr int kNumPortsTried = 100;

void SetNumber(int fd, int level, int option, int number) {
  setsockopt(fd, level, option, &number, sizeof number);
}

/// True once the socket is ready; false if it is not within `patience` (negative: forever).
bool WaitFor(int fd, short events, int patience_ms) {
  pollfd waited{.fd = fd, .events = events, .revents = 0};
  int answer = 0;
  do {
    answer = poll(&waited, 1, patience_ms);
  } while (answer < 0 && errno == EINTR);
  return answer > 0;
}

struct Address {
  sockaddr_storage bytes{};
  socklen_t size = 0;
};

void AddAddressesOf(const std::string& name, std::vector<Address>* addresses) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(name.c_str(), nullptr, &hints, &found);
  if (error != 0) {
    throw std::runtime_error("cannot listen at " + name + ": " + gai_strerror(error));
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, &freeaddrinfo);
  for (; found != nullptr; found = found->ai_next) {
    Address address{.size = found->ai_addrlen};
    std::memcpy(&address.bytes, found->ai_addr, found->ai_addrlen);
    // A name may lead to one place in several ways.
    const bool is_known = std::ranges::any_of(*addresses, [&address](const Address& known) {
      return std::memcmp(&known.bytes, &address.bytes, sizeof known.bytes) == 0;
    });
    if (!is_known) addresses->push_back(address);
  }
}

/// To browsers `localhost` is both, whatever the machine's tables say.
std::vector<Address> AddressesOf(const std::string& name) {
  std::vector<Address> addresses;
  const bool is_localhost = name == "localhost";
  AddAddressesOf(is_localhost ? "127.0.0.1" : name, &addresses);
  if (is_localhost) AddAddressesOf("::1", &addresses);
  return addresses;
}

bool IsLoopback(const Address& address) {
  if (address.bytes.ss_family == AF_INET6) {
    sockaddr_in6 v6{};
    std::memcpy(&v6, &address.bytes, sizeof v6);
    return IN6_IS_ADDR_LOOPBACK(&v6.sin6_addr) != 0;
  }
  sockaddr_in v4{};
  std::memcpy(&v4, &address.bytes, sizeof v4);
  return (ntohl(v4.sin_addr.s_addr) >> 24) == 127;
}

/// A socket that listens, or none, and errno says why.
Socket TryToListen(Address address, int port) {
  const int family = address.bytes.ss_family;
  Socket socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.is_open()) return {};
  SetNumber(socket.fd(), SOL_SOCKET, SO_REUSEADDR, 1);
  // The port is at the same place for both families.
  reinterpret_cast<sockaddr_in*>(&address.bytes)->sin_port =
      htons(static_cast<std::uint16_t>(port));
  if (bind(socket.fd(), reinterpret_cast<sockaddr*>(&address.bytes), address.size) != 0 ||
      listen(socket.fd(), kMaxWaiting) != 0) {
    const int reason = errno;
    socket = {};
    errno = reason;
  }
  return socket;
}

struct Attempt {
  std::vector<Socket> sockets;  ///< none if it failed
  int error = 0;                ///< why not, or why not everywhere: as errno has it
};

/// At all addresses that this machine has; nowhere if the port is not free at one of them.
Attempt TryToListen(const std::vector<Address>& addresses, int port) {
  Attempt attempt;
  for (const Address& address : addresses) {
    Socket socket = TryToListen(address, port);
    if (socket.is_open()) {
      attempt.sockets.push_back(std::move(socket));
      continue;
    }
    attempt.error = errno;
    const bool is_elsewhere = errno == EADDRNOTAVAIL || errno == EAFNOSUPPORT;
    if (!is_elsewhere) return {.error = attempt.error};
  }
  return attempt;
}

}  // namespace

Socket::~Socket() {
  if (is_open()) close(fd_);
}

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

Socket::Reading Socket::Read(std::string* bytes, Patience patience) const {
  if (!WaitFor(fd_, POLLIN, static_cast<int>(patience.count()))) return Reading::kNothing;
  std::array<char, 16384> buffer;
  const ssize_t count = recv(fd_, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Reading::kNothing;
  if (count <= 0) return Reading::kEnd;
  bytes->append(buffer.data(), static_cast<std::size_t>(count));
  return Reading::kBytes;
}

bool Socket::Write(std::string_view head, std::string_view body, Patience patience) const {
  while (!head.empty() || !body.empty()) {
    std::array<iovec, 2> parts{{{const_cast<char*>(head.data()), head.size()},
                                {const_cast<char*>(body.data()), body.size()}}};
    msghdr message{};
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    const ssize_t sent = sendmsg(fd_, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0) {
      if (errno == EINTR) continue;
      if (errno != EAGAIN || !WaitFor(fd_, POLLOUT, static_cast<int>(patience.count()))) {
        return false;
      }
      continue;
    }
    const std::size_t of_head = std::min(static_cast<std::size_t>(sent), head.size());
    head.remove_prefix(of_head);
    body.remove_prefix(static_cast<std::size_t>(sent) - of_head);
  }
  return true;
}

void Socket::FinishWriting() const { shutdown(fd_, SHUT_WR); }

void Socket::Stop() const { shutdown(fd_, SHUT_RDWR); }

Socket Listening::Accept(Patience stall) const {
  std::vector<pollfd> waited;
  for (const Socket& socket : sockets) waited.push_back({.fd = socket.fd(), .events = POLLIN});
  while (true) {
    (void)poll(waited.data(), waited.size(), -1);
    for (const pollfd& door : waited) {
      if (door.revents == 0) continue;
      Socket accepted(accept4(door.fd, nullptr, nullptr, SOCK_CLOEXEC));
      if (accepted.is_open()) {
        SetNumber(accepted.fd(), IPPROTO_TCP, TCP_NODELAY, 1);
        SetNumber(accepted.fd(), SOL_SOCKET, SO_SNDBUF, kSendBufferBytes);
        SetNumber(accepted.fd(), IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(stall.count()));
        return accepted;
      }
      if (errno == EINVAL || errno == EBADF) return {};  // Stop() was called
      // Whoever came is gone again, or there are too many open files: that passes.
      if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    }
  }
}

void Listening::Stop() const {
  for (const Socket& socket : sockets) socket.Stop();
}

Listening ListenAt(const std::string& address, int port, int first_port) {
  const std::vector<Address> addresses = AddressesOf(address);
  const int begin = port == 0 ? first_port : port;
  const int end = port == 0 ? first_port + kNumPortsTried : port + 1;
  int error = 0;
  for (int tried = begin; tried < end; ++tried) {
    Attempt attempt = TryToListen(addresses, tried);
    if (!attempt.sockets.empty()) {
      return {std::move(attempt.sockets), tried, std::ranges::all_of(addresses, IsLoopback)};
    }
    error = attempt.error;
    if (error != EADDRINUSE) break;
  }
  throw std::runtime_error("cannot listen at " + address + ", port " + std::to_string(begin) +
                           (port == 0 ? " and those after it" : "") + ": " + std::strerror(error));
}

}  // namespace smile::studio

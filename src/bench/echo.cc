#include "bench/internal_echo.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>

namespace smile::bench {
namespace {

/// Sends all bytes; false if the other end is closed.
bool SendAll(int socket, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

/// Receives until the buffer is full; false if the other end is closed.
bool ReceiveAll(int socket, std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::recv(socket, bytes.data(), bytes.size(), 0);
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

[[noreturn]] void FailEcho(const std::string& what) {
  throw std::runtime_error("bare socket: " + what + ": " + std::strerror(errno));
}

}  // namespace

Echo::Echo(std::size_t question_bytes, std::size_t answer_bytes)
    : question_(question_bytes), answer_(answer_bytes) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    FailEcho("cannot create a socket");
  child_ = ::fork();
  if (child_ == 0) {
    // The child calls only async-signal-safe functions, since the program has threads.
    ::close(ends[0]);
    while (ReceiveAll(ends[1], question_) && SendAll(ends[1], answer_)) {
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  socket_ = ends[0];
  if (child_ < 0) FailEcho("cannot create a process");
}

Echo::~Echo() {
  ::close(socket_);
  ::waitpid(child_, nullptr, 0);
}

void Echo::RoundTrip() {
  if (!SendAll(socket_, question_) || !ReceiveAll(socket_, answer_))
    FailEcho("the echo process has ended");
}

}  // namespace smile::bench

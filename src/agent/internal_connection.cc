#include "agent/internal_connection.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace smile::agent {

Connection::Connection(const std::string& address) {
  sockaddr_un name = {};
  name.sun_family = AF_UNIX;
  if (address.size() >= sizeof name.sun_path) throw std::runtime_error(address + ": too long");
  address.copy(name.sun_path, sizeof name.sun_path - 1);
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket_ < 0 ||
      ::connect(socket_, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) {
    const std::string reason = std::strerror(errno);
    if (socket_ >= 0) ::close(socket_);
    throw std::runtime_error(address + ": " + reason);
  }
}

Connection::~Connection() { ::close(socket_); }

void Connection::Send(std::span<const std::byte> frame) {
  while (!frame.empty()) {
    const ssize_t count = ::send(socket_, frame.data(), frame.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw std::runtime_error("the simulator has gone");
    frame = frame.subspan(static_cast<std::size_t>(count));
  }
}

std::optional<wire::Message> Connection::Receive() {
  while (true) {
    if (auto received = inbox_.TakeMessage()) {
      if (auto* message = std::get_if<wire::Message>(&*received)) return std::move(*message);
      throw std::runtime_error(std::get<wire::WireError>(*received).message);
    }
    const std::span<std::byte> room = inbox_.Room();
    const ssize_t count = ::read(socket_, room.data(), room.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    inbox_.Fill(static_cast<std::size_t>(count));
  }
}

}  // namespace smile::agent

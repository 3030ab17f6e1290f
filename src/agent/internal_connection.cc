#include "agent/internal_connection.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

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

bool Connection::ReadAll(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::read(socket_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

std::optional<wire::Message> Connection::Receive() {
  std::array<std::byte, wire::kHeaderBytes> head;
  if (!ReadAll(head)) return std::nullopt;
  const auto header = wire::DecodeHeader(head);
  if (const auto* error = std::get_if<wire::WireError>(&header)) {
    throw std::runtime_error(error->message);
  }
  std::vector<std::byte> body(std::get<wire::FrameHeader>(header).body_bytes);
  if (!ReadAll(body)) return std::nullopt;
  auto message = wire::DecodeBody(std::get<wire::FrameHeader>(header), body);
  if (const auto* error = std::get_if<wire::WireError>(&message)) {
    throw std::runtime_error(error->message);
  }
  return std::move(std::get<wire::Message>(message));
}

}  // namespace smile::agent

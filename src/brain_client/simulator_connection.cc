#include "brain_client/simulator_connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace smile::brain_client {
namespace {

[[noreturn]] void FailToConnect(int reason, const std::string& address) {
  throw std::system_error(reason, std::generic_category(), address);
}

}  // namespace

SimulatorConnection::SimulatorConnection(const std::string& address, Options options)
    : options_(std::move(options)), inbox_(options_.make_room) {
  sockaddr_un name = {};
  name.sun_family = AF_UNIX;
  // A path that does not fit would be cut without notice and name another socket.
  if (address.size() >= sizeof name.sun_path) FailToConnect(ENAMETOOLONG, address);
  address.copy(name.sun_path, sizeof name.sun_path - 1);
  socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket_ < 0 ||
      ::connect(socket_, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) {
    // Saved, since close() may change it.
    const int reason = errno;
    if (socket_ >= 0) ::close(socket_);
    FailToConnect(reason, address);
  }
}

SimulatorConnection::SimulatorConnection(int connected_socket, Options options)
    : options_(std::move(options)), socket_(connected_socket), inbox_(options_.make_room) {}

SimulatorConnection::~SimulatorConnection() { ::close(socket_); }

void SimulatorConnection::Greet(const Introduction& introduction) {
  wire::MessageWriter writer(wire::MessageType::kHello, 0);
  // The version decides about everything else, so it comes first.
  writer.AddScalar("version", wire::kProtocolVersion);
  writer.AddLogical("guard", introduction.has_guard);
  writer.AddLogical("rows", introduction.takes_rows);
  writer.AddText("client", introduction.client);
  if (!introduction.language.empty()) writer.AddText("language", introduction.language);
  Send(writer.Finish());
}

void SimulatorConnection::Send(std::span<const std::byte> frame) {
  while (!frame.empty()) {
    // The socket blocks: there is nothing else to do for a brain, and the simulator ends brains
    // that are late. MSG_NOSIGNAL turns a dead simulator into an error code instead of SIGPIPE.
    const ssize_t count = ::send(socket_, frame.data(), frame.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) {
      if (options_.on_signal) options_.on_signal();
      continue;
    }
    if (count <= 0) throw SimulatorGone();
    frame = frame.subspan(static_cast<std::size_t>(count));
  }
}

// Octave cannot interrupt read(), so its client polls with a timeout and looks for Ctrl+C in
// between.
bool SimulatorConnection::HasArrivals(int milliseconds) const {
  // Bytes that were read already do not show up in poll().
  if (inbox_.HasBytes()) return true;
  pollfd watched{socket_, POLLIN, 0};
  return ::poll(&watched, 1, milliseconds) > 0;
}

std::optional<wire::MessageView> SimulatorConnection::Receive() {
  while (true) {
    if (auto received = inbox_.TakeMessage()) {
      if (auto* message = std::get_if<wire::MessageView>(&*received)) return std::move(*message);
      throw ProtocolError(std::get<wire::WireError>(*received).message);
    }
    const std::span<std::byte> room = inbox_.Room();
    const ssize_t count = ::read(socket_, room.data(), room.size());
    if (count < 0 && errno == EINTR) {
      if (options_.on_signal) options_.on_signal();
      continue;
    }
    // End of file, or a reset by a simulator that was killed: for the brain, both mean the end.
    if (count <= 0) return std::nullopt;
    inbox_.Fill(static_cast<std::size_t>(count));
  }
}

}  // namespace smile::brain_client

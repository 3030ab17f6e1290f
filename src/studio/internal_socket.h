#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smile::studio {

using Patience = std::chrono::milliseconds;

/// A TCP socket that never waits forever.
class Socket {
 public:
  Socket() = default;
  explicit Socket(int fd) : fd_(fd) {}
  ~Socket();
  Socket(Socket&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Socket& operator=(Socket&& other) noexcept;

  enum class Reading { kBytes, kNothing, kEnd };
  /// Appends what has come, some 10 kB at a time; kNothing if nothing came within `patience`.
  Reading Read(std::string* bytes, Patience patience) const;
  /// Writes both parts. False if the other end is gone, or took nothing at all for `patience`.
  bool Write(std::string_view head, std::string_view body, Patience patience) const;
  /// The other end is told that nothing more comes.
  void FinishWriting() const;
  /// Ends all waiting, now and later. May be called from any thread.
  void Stop() const;

  bool is_open() const { return fd_ >= 0; }
  int fd() const { return fd_; }

 private:
  int fd_ = -1;
};

/// Where a server listens: at one port, of one address or several.
struct Listening {
  std::vector<Socket> sockets;  ///< that never wait in accept()
  int port = 0;
  bool is_loopback = false;  ///< only programs of this machine come in

  /// Waits until somebody comes to any of them; no socket once Stop() was called.
  /// @param stall  a connection whose other end acknowledges nothing for so long is given up.
  Socket Accept(Patience stall) const;
  /// Ends all waiting, now and later. May be called from any thread.
  void Stop() const;
};

/// @param address  a number like `127.0.0.1` or `::1`, or a name of this machine: then at all that
///                 it leads to and this machine has. `localhost` is both of these numbers.
/// @param port     0 for the first of `first_port` and the hundred after it that is free at all.
/// @throws std::runtime_error naming address, port and reason.
Listening ListenAt(const std::string& address, int port, int first_port);

}  // namespace smile::studio

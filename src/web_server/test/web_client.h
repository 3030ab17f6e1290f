#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smile::web_server {

/// The other end of the server: a browser without manners.
class WebClient {
 public:
  /// To 127.0.0.1.
  explicit WebClient(int port) : WebClient(AF_INET, port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ConnectTo(address);
  }
  /// To ::1.
  static WebClient OverIpv6(int port) {
    WebClient client(AF_INET6, port);
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    address.sin6_port = htons(static_cast<std::uint16_t>(port));
    address.sin6_addr = in6addr_loopback;
    client.ConnectTo(address);
    return client;
  }
  ~WebClient() { Leave(); }
  WebClient(WebClient&& other) noexcept
      : fd_(std::exchange(other.fd_, -1)), port_(other.port_), bytes_(std::move(other.bytes_)) {}
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  void Leave() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
  }
  /// False if the other end is gone.
  bool SendBytes(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }
  /// All up to its end.
  std::string ReadAll() {
    while (ReadMore()) {
    }
    return std::exchange(bytes_, {});
  }

  /// Sends the only request of this connection and returns all that comes.
  std::string Get(const std::string& path, const std::string& headers = "",
                  const std::string& method = "GET") {
    SendRequest(path, headers + "Connection: close\r\n", method);
    return ReadAll();
  }
  void SendRequest(const std::string& path, const std::string& headers = "",
                   const std::string& method = "GET") const {
    SendBytes(method + " " + path + " HTTP/1.1\r\n" + WithHost(headers) + "\r\n");
  }
  /// The next of several responses. Empty at the end.
  std::string ReadResponse(bool has_body = true) {
    std::size_t end = 0;
    while ((end = bytes_.find("\r\n\r\n")) == std::string::npos) {
      if (!ReadMore()) return {};
    }
    end += 4;
    const std::size_t length = bytes_.find("Content-Length: ");
    if (has_body && length < end) end += std::stoul(bytes_.substr(length + 16));
    while (bytes_.size() < end && ReadMore()) {
    }
    return TakeBytes(end);
  }

  /// The status of the answer; 101 when it is a WebSocket from now on.
  int Upgrade(const std::string& headers = "", const std::string& path = "/ws") {
    SendBytes("GET " + path + " HTTP/1.1\r\n" + WithHost(headers) +
              "Upgrade: websocket\r\nConnection: keep-alive, Upgrade\r\n"
              "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    while (bytes_.find("\r\n\r\n") == std::string::npos && ReadMore()) {
    }
    const std::size_t end = bytes_.find("\r\n\r\n");
    if (end == std::string::npos) return 0;
    head_ = bytes_.substr(0, end);
    bytes_.erase(0, end + 4);
    return std::stoi(head_.substr(9));
  }
  const std::string& head() const { return head_; }

  /// A masked frame.
  static std::string Frame(std::string_view payload, int opcode = 1, bool is_last = true) {
    std::string frame(1, static_cast<char>((is_last ? 0x80 : 0) | opcode));
    if (payload.size() < 126) {
      frame.push_back(static_cast<char>(0x80 | payload.size()));
    } else {
      // No more bytes of length than it takes.
      const int size_bytes = payload.size() < 65536 ? 2 : 8;
      frame.push_back(static_cast<char>(size_bytes == 2 ? 0xFE : 0xFF));
      for (int k = size_bytes - 1; k >= 0; --k)
        frame.push_back(static_cast<char>(payload.size() >> (8 * k)));
    }
    const char mask[4] = {1, 2, 3, 4};
    frame.append(mask, 4);
    for (std::size_t k = 0; k < payload.size(); ++k) {
      frame.push_back(static_cast<char>(payload[k] ^ mask[k % 4]));
    }
    return frame;
  }
  bool SendText(std::string_view text) const { return SendBytes(Frame(text)); }
  struct Message {
    int opcode = 0;
    std::string payload;
  };
  /// nullopt at the end.
  std::optional<Message> Next() {
    while (true) {
      if (auto message = TakeMessage()) return message;
      if (!ReadMore()) return std::nullopt;
    }
  }
  /// Code of the close frame that ends it all; 0 if none comes.
  int CloseCode() {
    while (const std::optional<Message> message = Next()) {
      if (message->opcode != 8 || message->payload.size() < 2) continue;
      return static_cast<unsigned char>(message->payload[0]) << 8 |
             static_cast<unsigned char>(message->payload[1]);
    }
    return 0;
  }
  int fd() const { return fd_; }

 private:
  WebClient(int family, int port) : fd_(socket(family, SOCK_STREAM, 0)), port_(port) {}

  template <typename Address>
  void ConnectTo(const Address& address) const {
    if (connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error("no server listens");
    }
  }

  std::string TakeBytes(std::size_t count) {
    std::string taken = bytes_.substr(0, count);
    bytes_.erase(0, count);
    return taken;
  }

  std::string WithHost(const std::string& headers) const {
    if (headers.find("Host:") != std::string::npos) return headers;
    return "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n" + headers;
  }

  /// False at the end, or when nothing comes for ten seconds.
  bool ReadMore() {
    pollfd waited{.fd = fd_, .events = POLLIN, .revents = 0};
    if (poll(&waited, 1, 10'000) <= 0) return false;
    char buffer[65536];
    const ssize_t count = recv(fd_, buffer, sizeof buffer, 0);
    if (count <= 0) return false;
    bytes_.append(buffer, static_cast<std::size_t>(count));
    return true;
  }

  std::optional<Message> TakeMessage() {
    const auto byte = [this](std::size_t k) { return static_cast<unsigned char>(bytes_[k]); };
    if (bytes_.size() < 2) return std::nullopt;
    std::size_t size = byte(1), begin = 2;
    if (size >= 126) {
      begin = size == 126 ? 4 : 10;
      if (bytes_.size() < begin) return std::nullopt;
      size = 0;
      for (std::size_t k = 2; k < begin; ++k) size = size << 8 | byte(k);
    }
    if (bytes_.size() < begin + size) return std::nullopt;
    Message message{byte(0) & 0x0F, bytes_.substr(begin, size)};
    bytes_.erase(0, begin + size);
    return message;
  }

  int fd_;
  int port_;
  std::string bytes_, head_;
};

}  // namespace smile::web_server

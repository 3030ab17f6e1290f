#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "web_client.h"
#include "web_server/web_server.h"

namespace smile::web_server {

/// Sends each message back, of the same kind; closes after one that says `bye`.
class EchoHandler : public WebSocketHandler {
 public:
  bool Open(WebSocketId id) override {
    const std::lock_guard lock(mutex_);
    return num_places_ > outgoing_.size() && outgoing_.try_emplace(id).second;
  }
  void Receive(WebSocketId id, bool is_text, std::string_view message) override {
    using Kind = OutgoingMessage::Kind;
    const std::lock_guard lock(mutex_);
    ++num_received_;
    const Kind kind = message == "bye" ? Kind::kClose : is_text ? Kind::kText : Kind::kBinary;
    Post(id, kind, std::string(message));
  }
  bool CanReceive(WebSocketId) override {
    const std::lock_guard lock(mutex_);
    return num_received_ < max_received_;
  }
  void LimitExceeded(WebSocketId id, const std::string& reason) override {
    const std::lock_guard lock(mutex_);
    Post(id, OutgoingMessage::Kind::kClose, reason, CloseCode::kPolicyViolation);
  }
  std::optional<OutgoingMessage> NextMessage(WebSocketId id) override {
    const std::lock_guard lock(mutex_);
    std::deque<OutgoingMessage>& waiting = outgoing_.at(id);
    if (waiting.empty()) return std::nullopt;
    OutgoingMessage message = std::move(waiting.front());
    waiting.pop_front();
    return message;
  }
  void Close(WebSocketId id) override {
    const std::lock_guard lock(mutex_);
    outgoing_.erase(id);
  }

  void SendToAll(const std::string& text) {
    const std::lock_guard lock(mutex_);
    for (auto& [id, waiting] : outgoing_) Post(id, OutgoingMessage::Kind::kText, text);
  }
  void SetPlaces(std::size_t count) { num_places_ = count; }
  void SetMaxReceived(int count) {
    const std::lock_guard lock(mutex_);
    max_received_ = count;
  }
  std::size_t num_open() {
    const std::lock_guard lock(mutex_);
    return outgoing_.size();
  }

 private:
  void Post(WebSocketId id, OutgoingMessage::Kind kind, std::string text,
            CloseCode code = CloseCode::kNormal) {
    outgoing_.at(id).push_back(
        {.kind = kind, .body = std::make_shared<const std::string>(std::move(text)), .code = code});
  }

  std::mutex mutex_;
  std::map<WebSocketId, std::deque<OutgoingMessage>> outgoing_;
  std::size_t num_places_ = 64;
  int num_received_ = 0, max_received_ = 1 << 30;
};

/// A server of two files, a handler of GETs and an echo.
class WebServerTest : public ::testing::Test {
 protected:
  WebServerTest() {
    std::filesystem::create_directories(folder_ / "page");
    Write("page/index.html", "<html>the page</html>");
    Write("page/studio.js", "studio()");
    Write("page/studio.js.gz", "gzipped");
    Write("secret.txt", "secret");
    options_.files = folder_ / "page";
    options_.cookie = "smile_studio";
    options_.limits.stall_seconds = 0.3;
    options_.get = [](const std::string& path) -> std::optional<HttpResponse> {
      if (path == "/recordings/a b.zip") return HttpResponse{"application/zip", "zip", "a b.zip"};
      if (path == "/long") return HttpResponse{"text/plain", std::string(64 << 20, 'x'), ""};
      if (path == "/fails") throw std::runtime_error("the disk is gone");
      return std::nullopt;
    };
  }
  ~WebServerTest() override {
    server_.reset();
    std::filesystem::remove_all(folder_);
  }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  WebServer& server() {
    if (!server_) server_.emplace(options_, &handler_);
    return *server_;
  }
  int port() { return server().port(); }
  WebClient Connect() { return WebClient(port()); }
  /// A WebSocket.
  WebClient Join() {
    WebClient client = Connect();
    EXPECT_EQ(client.Upgrade(), 101);
    return client;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("smile_web_server_" + std::to_string(getpid()));
  EchoHandler handler_;
  WebServerOptions options_;
  std::optional<WebServer> server_;
};

inline bool IsStatus(const std::string& answer, int status) {
  return answer.starts_with("HTTP/1.1 " + std::to_string(status) + " ");
}

}  // namespace smile::web_server

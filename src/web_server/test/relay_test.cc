// Requests that are passed on to another server of this machine.

#include "web_server/internal_relay.h"

#include "web_server_fixture.h"

namespace smile::web_server {
namespace {

/// The server of the fixture passes on what is below /p/secret/ to another one, an echo.
class RelayTest : public WebServerTest {
 protected:
  RelayTest() {
    inner_options_.files = folder_ / "page";
    inner_.emplace(inner_options_, &inner_handler_);
    options_.relay = [port =
                          inner_->port()](const std::string& path) -> std::optional<RelayTarget> {
      constexpr std::string_view kPrefix = "/p/secret/";
      if (!path.starts_with(kPrefix)) return std::nullopt;
      return RelayTarget{port, "/" + path.substr(kPrefix.size())};
    };
  }

  EchoHandler inner_handler_;
  WebServerOptions inner_options_;
  std::optional<WebServer> inner_;
};

TEST_F(RelayTest, PassesOnFiles) {
  server();
  const std::string answer = Connect().Get("/p/secret/studio.js");
  EXPECT_TRUE(IsStatus(answer, 200)) << answer;
  EXPECT_TRUE(answer.ends_with("studio()"));
  EXPECT_TRUE(IsStatus(Connect().Get("/p/other/studio.js"), 404));
}

TEST_F(RelayTest, PassesOnWebSockets) {
  server();
  WebClient client = Connect();
  ASSERT_EQ(client.Upgrade("", "/p/secret/ws"), 101);
  EXPECT_EQ(handler_.num_open(), 0u);
  EXPECT_EQ(inner_handler_.num_open(), 1u);
  // More than the buffers of the relay.
  const std::string text(100'000, 'x');
  ASSERT_TRUE(client.SendText(text));
  EXPECT_EQ(client.Next()->payload, text);
  client.Leave();
  for (int k = 0; k < 200 && inner_handler_.num_open() > 0; ++k) usleep(10'000);
  EXPECT_EQ(inner_handler_.num_open(), 0u);
}

TEST_F(RelayTest, ChecksTheOriginItself) {
  server();
  EXPECT_EQ(Connect().Upgrade("Origin: http://elsewhere.example\r\n", "/p/secret/ws"), 403);
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(port()) + "\r\n";
  EXPECT_EQ(Connect().Upgrade(own, "/p/secret/ws"), 101);
  EXPECT_TRUE(IsStatus(Connect().Get("/p/secret/studio.js", "", "POST"), 405));
}

TEST_F(RelayTest, EndsWithItsTarget) {
  server();
  WebClient client = Connect();
  ASSERT_EQ(client.Upgrade("", "/p/secret/ws"), 101);
  inner_.reset();
  EXPECT_FALSE(client.Next().value_or(WebClient::Message{8}).opcode == 1);
  // Without a target there is no answer, and the server goes on.
  EXPECT_EQ(Connect().Get("/p/secret/studio.js"), "");
  EXPECT_TRUE(IsStatus(Connect().Get("/studio.js"), 200));
}

TEST(RelayedHeads, KeepNothingThatIsTheClientsOwn) {
  const HttpRequest request = ParseHttpHead(
      "GET /p/secret/a%20b HTTP/1.1\r\nHost: here:1\r\nOrigin: http://here:1\r\nCookie: a=b\r\n"
      "Accept: */*\r\nConnection: keep-alive");
  EXPECT_EQ(RelayedHead(request, {.port = 7, .path = "/a b"}),
            "GET /a%20b HTTP/1.1\r\nHost: 127.0.0.1:7\r\nConnection: close\r\naccept: */*\r\n\r\n");
}

}  // namespace
}  // namespace smile::web_server

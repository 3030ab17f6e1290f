// Requests and responses, and who gets any.

#include <chrono>
#include <thread>

#include "web_server/public_origin.h"
#include "web_server/secret.h"
#include "web_server_fixture.h"

namespace smile::web_server {
namespace {

using namespace std::chrono_literals;

TEST_F(WebServerTest, ServesThePageAndNothingElse) {
  const std::string page = Connect().Get("/");
  EXPECT_TRUE(IsStatus(page, 200));
  EXPECT_NE(page.find("<html>the page</html>"), std::string::npos);
  EXPECT_NE(page.find("Content-Security-Policy: default-src 'self'"), std::string::npos);
  EXPECT_TRUE(IsStatus(Connect().Get("/studio"), 404));
  EXPECT_TRUE(IsStatus(Connect().Get("/", "", "POST"), 405));
  EXPECT_EQ(Connect().Get("/studio.js", "", "HEAD").find("studio()"), std::string::npos);
}

TEST_F(WebServerTest, PathsCannotLeaveTheFolderOfThePage) {
  for (const char* path :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/x/../../secret.txt", "/..%2fsecret.txt",
        "//etc/passwd", "/..%5csecret.txt", "/index.html%00", "/%2", "secret.txt", "*"}) {
    const std::string answer = Connect().Get(path);
    EXPECT_TRUE(IsStatus(answer, 404) || IsStatus(answer, 400)) << path << ": " << answer;
    EXPECT_EQ(answer.find("secret\n"), std::string::npos);
  }
}

TEST_F(WebServerTest, SendsFilesSmallAndOnlyWhenTheyChanged) {
  EXPECT_NE(Connect().Get("/studio.js", "Accept-Encoding: br, gzip\r\n").find("\r\n\r\ngzipped"),
            std::string::npos);
  const std::string whole = Connect().Get("/studio.js");
  EXPECT_NE(whole.find("\r\n\r\nstudio()"), std::string::npos);
  EXPECT_NE(whole.find("\r\nVary: Accept-Encoding\r\n"), std::string::npos);
  // Both bodies have this one tag, so it must be weak.
  const std::size_t tag = whole.find("ETag: ") + 6;
  ASSERT_EQ(whole.substr(tag, 3), "W/\"");
  EXPECT_TRUE(IsStatus(
      Connect().Get("/studio.js", "If-None-Match: " + whole.substr(tag, 20) + "\r\n"), 304));
}

TEST_F(WebServerTest, GivesWhatItsOwnerHas) {
  const std::string answer = Connect().Get("/recordings/a%20b.zip");
  EXPECT_TRUE(IsStatus(answer, 200));
  EXPECT_NE(answer.find("attachment; filename*=UTF-8''a%20b.zip"), std::string::npos);
  EXPECT_TRUE(IsStatus(Connect().Get("/recordings/b.zip"), 404));
  EXPECT_TRUE(IsStatus(Connect().Get("/fails"), 500));
}

TEST_F(WebServerTest, GarbageIsNoRequest) {
  for (const std::string& garbage :
       {std::string("\x16\x03\x01\x02\r\n\r\n"), std::string("GET / HTTP/1.1\r\nno header\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n")}) {
    WebClient client = Connect();
    client.SendBytes(garbage);
    EXPECT_TRUE(IsStatus(client.ReadAll(), 400)) << garbage;
  }
  WebClient client = Connect();
  client.SendBytes("GET / HTTP/1.1\r\nA: " + std::string(20'000, 'a'));
  EXPECT_TRUE(IsStatus(client.ReadAll(), 431));
}

TEST_F(WebServerTest, OtherSitesHaveNoAccess) {
  const std::string host = "Host: localhost:" + std::to_string(port()) + "\r\n";
  const auto upgrade = [this](const std::string& headers) { return Connect().Upgrade(headers); };
  EXPECT_EQ(upgrade("Host: evil.example\r\n"), 403);
  EXPECT_EQ(upgrade("Host: 192.168.1.1\r\n"), 403);
  EXPECT_EQ(upgrade(host + "Origin: http://evil.example\r\n"), 403);
  EXPECT_EQ(upgrade(host + "Origin: null\r\n"), 403);
  EXPECT_EQ(upgrade(host + "Origin: http://localhost:1\r\n"), 403);
  EXPECT_EQ(upgrade(host + "Origin: http://localhost:" + std::to_string(port()) + "\r\n"), 101);
  EXPECT_TRUE(IsStatus(Connect().Get("/", "Host: evil.example\r\n"), 403));
}

TEST_F(WebServerTest, BehindAProxyThePublicNameIsItsOwn) {
  options_.needs_token = false;
  options_.public_origin = OriginOf("https://Lab.example.org/");
  EXPECT_EQ(server().link(), "https://lab.example.org/");
  const auto upgrade = [&](const std::string& headers) {
    return WebClient(port()).Upgrade(headers);
  };
  // Some proxies pass the name on, others replace it.
  const std::string named = "Host: lab.example.org\r\n", own = "Host: localhost\r\n";
  const std::string page = "Origin: https://lab.example.org\r\n";
  EXPECT_EQ(upgrade(named + page), 101);
  EXPECT_EQ(upgrade(own + page), 101);
  EXPECT_EQ(upgrade("Host: evil.example\r\n" + page), 403);
  EXPECT_EQ(upgrade(named + "Origin: https://evil.example\r\n"), 403);
  EXPECT_NE(WebClient(port()).Get("/", own).find("connect-src 'self' blob: wss://lab.example.org;"),
            std::string::npos);
}

TEST(PublicOrigin, HasNoPath) {
  EXPECT_EQ(OriginOf("http://10.0.0.7:8080"), "http://10.0.0.7:8080");
  for (const char* url :
       {"lab.example.org", "https://", "https://lab.example.org/study", "https://a b",
        "https://user@lab.example.org", "https://lab.example.org:port"}) {
    EXPECT_THROW(OriginOf(url), std::invalid_argument) << url;
  }
}

TEST_F(WebServerTest, ElsewhereThanOnThisMachineATokenIsNeeded) {
  options_.address = "0.0.0.0";
  const std::string link = server().link();
  const std::string token = link.substr(link.find("?token=") + 7);
  const int port = server().port();
  EXPECT_NE(link.find(":" + std::to_string(port) + "/?"), std::string::npos) << link;
  ASSERT_EQ(token.size(), 32u);
  EXPECT_TRUE(IsStatus(WebClient(port).Get("/"), 403));
  EXPECT_TRUE(IsStatus(WebClient(port).Get("/?token=" + std::string(32, '0')), 403));
  EXPECT_EQ(WebClient(port).Upgrade(), 403);

  const std::string answer = WebClient(port).Get("/?token=" + token);
  EXPECT_TRUE(IsStatus(answer, 303));
  const std::string cookie = "smile_studio_" + std::to_string(port) + "=" + token;
  EXPECT_NE(answer.find("Set-Cookie: " + cookie + "; HttpOnly; SameSite=Strict"),
            std::string::npos);
  EXPECT_EQ(WebClient(port).Upgrade("Cookie: a=b; " + cookie + "\r\n"), 101);
  EXPECT_EQ(WebClient(port).Upgrade("Cookie: " + cookie + "\r\nHost: evil.example\r\n"), 403);
}

TEST_F(WebServerTest, PublicPathsNeedNoTokenAndLeadNowhereElse) {
  options_.address = "0.0.0.0";
  options_.public_prefix = "/shared/";
  options_.get = [](const std::string& path) -> std::optional<HttpResponse> {
    if (path != "/shared/secret" && path != "/private") return std::nullopt;
    return HttpResponse{.type = "text/plain",
                        .gzipped = std::make_shared<const std::string>("bytes")};
  };
  EXPECT_EQ(server().link().find(server().origin() + "/?token="), 0u);
  EXPECT_FALSE(server().is_loopback());
  const int port = server().port();
  const std::string answer = WebClient(port).Get("/shared/secret");
  EXPECT_TRUE(IsStatus(answer, 200)) << answer;
  EXPECT_NE(answer.find("Content-Encoding: gzip"), std::string::npos);
  EXPECT_TRUE(answer.ends_with("\r\n\r\nbytes"));
  EXPECT_TRUE(IsStatus(WebClient(port).Get("/shared/other"), 404));
  for (const char* path : {"/private", "/", "/studio.js", "/shared", "/sharedother", "//shared/a",
                           "/ws", "/SHARED/secret"}) {
    EXPECT_FALSE(IsStatus(WebClient(port).Get(path), 200)) << path;
  }
  EXPECT_TRUE(IsStatus(WebClient(port).Get("/shared/../private"), 404));
  EXPECT_TRUE(IsStatus(WebClient(port).Get("/shared/%2e%2e/private"), 404));
  EXPECT_TRUE(IsStatus(WebClient(port).Get("/shared/secret", "Host: evil.example\r\n"), 403));
  EXPECT_EQ(WebClient(port).Upgrade(), 403);
  EXPECT_EQ(WebClient(port).Upgrade("", "/shared/secret"), 200) << "it is no WebSocket";
}

TEST(Secret, HasThirtyTwoDigitsAndNoOther) {
  const std::string secret = RandomSecret();
  EXPECT_EQ(secret.size(), kSecretDigits);
  EXPECT_EQ(secret.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(secret, RandomSecret());
  EXPECT_TRUE(IsSecret(secret, secret));
  for (std::size_t k = 0; k < secret.size(); ++k) {
    std::string other = secret;
    other[k] = other[k] == '0' ? '1' : '0';
    EXPECT_FALSE(IsSecret(other, secret)) << k;
  }
  EXPECT_FALSE(IsSecret("", secret));
  EXPECT_FALSE(IsSecret(secret + "0", secret));
}

TEST_F(WebServerTest, ServersFindPortsOfTheirOwn) {
  EchoHandler second;
  WebServer other(options_, &second);
  EXPECT_NE(server().link(), other.link());
  options_.port = port();
  try {
    WebServer third(options_, &second);
    FAIL() << "two servers at one port";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "cannot listen at 127.0.0.1, port " +
                                             std::to_string(port()) + ": Address already in use");
  }
}

bool HasIpv6() {
  const int fd = socket(AF_INET6, SOCK_STREAM, 0);
  const sockaddr_in6 address{.sin6_family = AF_INET6, .sin6_addr = in6addr_loopback};
  const bool has_it = bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(fd);
  return has_it;
}

TEST_F(WebServerTest, LocalhostIsBothAddressesAtOnePort) {
  options_.address = "localhost";
  EXPECT_EQ(server().link(), "http://localhost:" + std::to_string(port()) + "/");
  EXPECT_TRUE(IsStatus(WebClient(port()).Get("/"), 200));
  if (!HasIpv6()) GTEST_SKIP() << "this machine has no ::1";
  EXPECT_TRUE(IsStatus(WebClient::OverIpv6(port()).Get("/", "Host: localhost\r\n"), 200));
  // Who has but one of them has it to itself.
  WebServerOptions there = options_;
  there.address = "::1";
  EchoHandler second;
  const WebServer other(there, &second);
  options_.port = other.port();
  EXPECT_THROW(WebServer(options_, &second), std::runtime_error);
}

TEST_F(WebServerTest, AConnectionCarriesManyRequests) {
  WebClient client = Connect();
  for (int k = 0; k < 3; ++k) {
    client.SendRequest("/studio.js");
    EXPECT_NE(client.ReadResponse().find("\r\n\r\nstudio()"), std::string::npos) << k;
  }
  client.SendRequest("/nowhere");
  EXPECT_TRUE(IsStatus(client.ReadResponse(), 404));
  client.SendRequest("/studio.js", "", "HEAD");
  EXPECT_TRUE(IsStatus(client.ReadResponse(/*has_body=*/false), 200));
  // Requests need not wait for responses.
  client.SendRequest("/");
  client.SendRequest("/recordings/a%20b.zip");
  EXPECT_NE(client.ReadResponse().find("the page"), std::string::npos);
  EXPECT_NE(client.ReadResponse().find("\r\n\r\nzip"), std::string::npos);
  EXPECT_EQ(client.Upgrade(), 101);
}

TEST_F(WebServerTest, ABodyEndsTheConnectionUnread) {
  WebClient client = Connect();
  client.SendRequest("/", "Content-Length: 40\r\n");
  client.SendBytes("GET /studio.js HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const std::string all = client.ReadAll();
  EXPECT_TRUE(IsStatus(all, 200));
  EXPECT_EQ(all.find("studio()"), std::string::npos);
}

TEST_F(WebServerTest, ARequestThatDoesNotEndIsNotWaitedFor) {
  options_.limits.head_seconds = 0.2;
  WebClient slow = Connect(), silent = Connect();
  slow.SendBytes("GET / HTTP/1.1\r\nHost: loc");
  EXPECT_TRUE(IsStatus(slow.ReadAll(), 408));
  EXPECT_EQ(silent.ReadAll(), "");
}

TEST_F(WebServerTest, AnIdleConnectionIsClosed) {
  options_.limits.keep_alive_seconds = 0.2;
  WebClient client = Connect();
  client.SendRequest("/");
  EXPECT_TRUE(IsStatus(client.ReadResponse(), 200));
  EXPECT_EQ(client.ReadAll(), "");
}

TEST_F(WebServerTest, HalfOpenRequestsDoNotBlockOtherClients) {
  options_.limits.connections = 20;
  std::vector<WebClient> half;
  for (int k = 0; k < 200; ++k) {
    half.push_back(Connect());
    half.back().SendBytes("GET / HTTP/1.1\r\n");
    if (k % 50 == 49) {
      EXPECT_TRUE(IsStatus(Connect().Get("/"), 200)) << k;
      EXPECT_EQ(Connect().Upgrade(), 101) << k;
    }
  }
}

TEST_F(WebServerTest, AReaderThatReadsNothingIsDisconnected) {
  WebClient stalled = Connect();
  stalled.SendRequest("/long");
  std::this_thread::sleep_for(1500ms);
  EXPECT_LT(stalled.ReadAll().size(), 64u << 20);
  EXPECT_GT(Connect().Get("/long").size(), 64u << 20) << "others get all of it";
}

TEST_F(WebServerTest, ARequestWithoutHostIsRefused) {
  WebClient client = Connect();
  client.SendBytes("GET / HTTP/1.1\r\n\r\n");
  EXPECT_TRUE(IsStatus(client.ReadResponse(), 403));
}

}  // namespace
}  // namespace smile::web_server

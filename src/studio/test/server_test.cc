#include "studio/server.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/bytes.h"
#include "web_client.h"

namespace smile::studio {
namespace {

/// A server with a page of two files, and limits that a test can reach.
class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    std::filesystem::create_directories(folder_ / "page");
    std::ofstream(folder_ / "page/index.html") << "<html>the page</html>";
    std::ofstream(folder_ / "page/studio.js") << "studio()";
    std::ofstream(folder_ / "page/studio.js.gz") << "gzipped";
    std::ofstream(folder_ / "secret.txt") << "secret";
    options_.page = folder_ / "page";
    options_.limits.stall_seconds = 0.3;
    options_.limits.silence_seconds = 0;
    options_.get = [](const std::string& path) -> std::optional<HttpAnswer> {
      if (path == "/recordings/a b.zip") return HttpAnswer{"application/zip", "zip", "a b.zip"};
      if (path == "/fails") throw std::runtime_error("the disk is gone");
      return std::nullopt;
    };
  }
  ~ServerTest() override {
    server_.reset();
    std::filesystem::remove_all(folder_);
  }

  Server& server() {
    if (!server_) server_.emplace(options_);
    return *server_;
  }
  int port() { return std::stoi(server().link().substr(server().link().rfind(':') + 1)); }
  WebClient Connect() { return WebClient(port()); }
  /// A client that said hello and, if asked for, was told everything.
  WebClient Join(bool knows_everything = true) {
    WebClient client = Connect();
    EXPECT_EQ(client.Upgrade(), 101);
    EXPECT_EQ(client.Hello()["ok"], true);
    if (knows_everything) server().TakeNewClients();
    return client;
  }
  /// What clients ask for, once so much of it is there.
  std::vector<Request> Requests(std::size_t count) {
    std::vector<Request> requests;
    while (requests.size() < count) {
      for (Request& request : server().TakeRequests()) requests.push_back(std::move(request));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return requests;
  }
  static Poses PosesOf(std::vector<std::uint32_t> frames, float x, bool is_key = false) {
    Poses poses{.scene = 1, .is_key = is_key, .frames = std::move(frames)};
    for (std::size_t k = 0; k < poses.frames.size(); ++k) {
      poses.values.insert(poses.values.end(), {x, 0, 0, 0, 0, 0, 1});
    }
    return poses;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("smile_server_" + std::to_string(getpid()));
  ServerOptions options_;
  std::optional<Server> server_;
};

bool IsStatus(const std::string& answer, int status) {
  return answer.starts_with("HTTP/1.1 " + std::to_string(status) + " ");
}

/// Numbers of the frames in a message of poses, as the page reads them.
std::vector<std::uint32_t> FramesIn(const WebClient::Message& message) {
  ByteReader reader(std::as_bytes(std::span(message.payload)));
  reader.GetBytes(2);
  std::vector<std::uint32_t> frames(reader.Get<std::uint16_t>());
  reader.GetBytes(12);
  for (std::uint32_t& frame : frames) {
    frame = reader.Get<std::uint32_t>();
    reader.GetBytes(28);
  }
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(reader.remaining(), 0u);
  return frames;
}

std::uint32_t AckIn(const WebClient::Message& message) {
  ByteReader reader(std::as_bytes(std::span(message.payload).subspan(12)));
  return reader.Get<std::uint32_t>();
}

TEST_F(ServerTest, ServesThePageAndNothingElse) {
  const std::string page = Connect().Get("/");
  EXPECT_TRUE(IsStatus(page, 200));
  EXPECT_NE(page.find("<html>the page</html>"), std::string::npos);
  EXPECT_NE(page.find("Content-Security-Policy: default-src 'self'"), std::string::npos);
  EXPECT_TRUE(IsStatus(Connect().Get("/studio"), 404));
  EXPECT_TRUE(IsStatus(Connect().Get("/", "", "POST"), 405));
  EXPECT_EQ(Connect().Get("/studio.js", "", "HEAD").find("studio()"), std::string::npos);
}

TEST_F(ServerTest, NobodyClimbsOutOfThePagesFolder) {
  for (const char* path :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/x/../../secret.txt", "/..%2fsecret.txt",
        "//etc/passwd", "/..%5csecret.txt", "/index.html%00", "/%2", "secret.txt", "*"}) {
    const std::string answer = Connect().Get(path);
    EXPECT_TRUE(IsStatus(answer, 404) || IsStatus(answer, 400)) << path << ": " << answer;
    EXPECT_EQ(answer.find("secret\n"), std::string::npos);
  }
}

TEST_F(ServerTest, SendsFilesSmallAndOnlyWhenTheyChanged) {
  EXPECT_NE(Connect().Get("/studio.js", "Accept-Encoding: br, gzip\r\n").find("\r\n\r\ngzipped"),
            std::string::npos);
  const std::string whole = Connect().Get("/studio.js");
  EXPECT_NE(whole.find("\r\n\r\nstudio()"), std::string::npos);
  const std::size_t tag = whole.find("ETag: ") + 6;
  EXPECT_TRUE(IsStatus(
      Connect().Get("/studio.js", "If-None-Match: " + whole.substr(tag, 18) + "\r\n"), 304));
}

TEST_F(ServerTest, GivesWhatItsOwnerHas) {
  const std::string answer = Connect().Get("/recordings/a%20b.zip");
  EXPECT_TRUE(IsStatus(answer, 200));
  EXPECT_NE(answer.find("attachment; filename*=UTF-8''a%20b.zip"), std::string::npos);
  EXPECT_TRUE(IsStatus(Connect().Get("/recordings/b.zip"), 404));
  EXPECT_TRUE(IsStatus(Connect().Get("/fails"), 500));
}

TEST_F(ServerTest, GarbageIsNoRequest) {
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

TEST_F(ServerTest, OtherSitesHaveNoAccess) {
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

TEST_F(ServerTest, ElsewhereThanOnThisMachineATokenIsNeeded) {
  options_.address = "0.0.0.0";
  const std::string link = server().link();
  const std::string token = link.substr(link.find("?token=") + 7);
  const int port = std::stoi(link.substr(link.rfind(':') + 1));
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

TEST_F(ServerTest, ServersFindPortsOfTheirOwn) {
  Server other(options_);
  EXPECT_NE(server().link(), other.link());
  options_.port = port();
  try {
    Server third(options_);
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

TEST_F(ServerTest, LocalhostIsBothAddressesAtOnePort) {
  options_.address = "localhost";
  EXPECT_EQ(server().link(), "http://localhost:" + std::to_string(port()) + "/");
  EXPECT_TRUE(IsStatus(WebClient(port()).Get("/"), 200));
  if (!HasIpv6()) GTEST_SKIP() << "this machine has no ::1";
  EXPECT_TRUE(IsStatus(WebClient::OverIpv6(port()).Get("/", "Host: localhost\r\n"), 200));
  // Who has but one of them has it to itself.
  ServerOptions there = options_;
  there.address = "::1";
  const Server other(there);
  const std::string link = other.link();
  options_.port = std::stoi(link.substr(link.rfind(':') + 1));
  EXPECT_THROW(Server{options_}, std::runtime_error);
}

TEST_F(ServerTest, SaysHowAMissingPageIsBuilt) {
  options_.page = folder_ / "nowhere";
  EXPECT_THROW(server(), std::runtime_error);
}

TEST_F(ServerTest, ShakesHandsAsTheStandardSays) {
  WebClient client = Connect();
  client.Upgrade();
  EXPECT_NE(client.head().find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="),
            std::string::npos);
}

TEST_F(ServerTest, OneControlsAndHandsOver) {
  WebClient first = Join(), second = Join();
  const Json client = first.Ask({{"do", "take_control"}});
  EXPECT_EQ(client["granted"], true);
  EXPECT_EQ(first.Await("clients")["controller"], 1);
  EXPECT_TRUE(server().IsController(1));

  EXPECT_EQ(second.Ask({{"do", "take_control"}})["granted"], false);
  EXPECT_EQ(first.Await("control_wanted")["by"], 2);
  EXPECT_EQ(second.Ask({{"do", "give_control"}, {"to", 2}})["ok"], false);
  EXPECT_EQ(first.Ask({{"do", "give_control"}, {"to", 9}})["error"],
            "there is no client 9 to give control to");
  EXPECT_EQ(first.Ask({{"do", "give_control"}, {"to", 2}})["ok"], true);
  EXPECT_TRUE(server().IsController(2));
}

TEST_F(ServerTest, ASilentControllerMayBeReplacedAndOneThatLeftIsNone) {
  WebClient first = Join(), second = Join();
  first.Ask({{"do", "take_control"}});
  EXPECT_EQ(second.Ask({{"do", "take_control"}, {"by_force", true}})["granted"], true);
  second.Leave();
  Json clients;
  do {
    clients = first.Await("clients");
  } while (clients["clients"].size() != 1);
  EXPECT_TRUE(clients["controller"].is_null());
  EXPECT_EQ(clients["you"], 1);
}

TEST_F(ServerTest, HandsOverTheControllersRequestsAndOneOfEachWatcher) {
  WebClient controller = Join(), watcher = Join();
  controller.Ask({{"do", "take_control"}});
  for (int seq = 2; seq <= 4; ++seq) {
    controller.SendJson({{"seq", seq}, {"do", "command"}});
    watcher.SendJson({{"seq", seq}, {"do", "library"}});
  }
  // All have come once the answers to what came after them have.
  controller.Ask({{"do", "ping"}});
  watcher.Ask({{"do", "ping"}});
  std::vector<std::pair<ClientId, std::uint32_t>> taken;
  for (const Request& request : server().TakeRequests()) {
    taken.emplace_back(request.client, request.seq);
  }
  EXPECT_EQ(taken,
            (std::vector<std::pair<ClientId, std::uint32_t>>{{1, 2}, {1, 3}, {1, 4}, {2, 2}}));
  EXPECT_EQ(server().TakeRequests().front().seq, 3u);
}

TEST_F(ServerTest, NewsGoToThoseWhoKnowWhatTheyAreAbout) {
  WebClient client = Join(/*knows_everything=*/false);
  server().SendToAll({{"t", "event"}, {"kind", "early"}});
  EXPECT_EQ(server().TakeNewClients(), std::vector<ClientId>{1});
  EXPECT_TRUE(server().TakeNewClients().empty());
  server().SendToAll({{"t", "event"}, {"kind", "late"}});
  EXPECT_EQ(client.Await("event")["kind"], "late");
}

TEST_F(ServerTest, PosesTellWhatMovedAndAcknowledgeWhatWasDone) {
  WebClient client = Join();
  server().SendPoses(PosesOf({1, 2, 3}, 0, /*is_key=*/true));
  std::optional<WebClient::Message> poses = client.Next();
  while (poses && poses->opcode != 2) poses = client.Next();
  ASSERT_TRUE(poses);
  EXPECT_EQ(poses->payload[1], 1);  // a key
  EXPECT_EQ(FramesIn(*poses), (std::vector<std::uint32_t>{1, 2, 3}));

  client.SendJson({{"seq", 7}, {"do", "command"}});
  server().Send(1, Answer({}, Requests(1)[0], false));
  server().SendPoses(PosesOf({2}, 1));
  do {
    poses = client.Next();
  } while (poses && poses->opcode != 2);
  EXPECT_EQ(FramesIn(*poses), std::vector<std::uint32_t>{2});
  EXPECT_EQ(AckIn(*poses), 7u);
}

TEST_F(ServerTest, WhoTakesNothingIsSentAwayAndHarmsNobody) {
  WebClient stalled = Join(), other = Join();
  other.Await("clients");  // both
  const std::string long_text(200'000, 'x');
  std::size_t num_clients = 2;
  for (int k = 0; num_clients == 2; ++k) {
    ASSERT_LT(k, 2000);
    server().SendToAll({{"t", "event"}, {"number", k}, {"text", long_text}});
    while (true) {
      const std::optional<WebClient::Message> message = other.Next();
      ASSERT_TRUE(message);
      const Json json = Json::parse(message->payload);
      if (json["t"] == "clients") num_clients = json["clients"].size();
      if (json["t"] != "event") continue;
      EXPECT_EQ(json["number"], k);  // the other misses nothing
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST_F(ServerTest, AMessageThatIsTooLongIsNotEvenRead) {
  WebClient client = Join();
  // Its head alone says that a gigabyte will come.
  client.SendBytes(std::string("\x81\xFF\0\0\0\0\x40\0\0\0\1\2\3\4", 14));
  EXPECT_EQ(client.CloseCode(), 1009);
  WebClient other = Join();
  const std::string piece(700'000, ' ');
  other.SendBytes(WebClient::Frame(piece, 1, false) + WebClient::Frame(piece, 0, true));
  EXPECT_EQ(other.CloseCode(), 1009);
}

TEST_F(ServerTest, MessagesMayComeInPieces) {
  WebClient client = Join();
  client.SendBytes(WebClient::Frame("{\"seq\":5,", 1, false) + WebClient::Frame("hm", 9) +
                   WebClient::Frame("\"do\":\"ping\"}", 0));
  client.Await("clients");
  const std::optional<WebClient::Message> pong = client.Next();
  EXPECT_EQ(pong->opcode, 10);
  EXPECT_EQ(pong->payload, "hm");
  EXPECT_EQ(client.Await("reply")["seq"], 5);
}

TEST_F(ServerTest, WhoFloodsIsToldAndSentAway) {
  WebClient client = Join();
  std::string flood;
  for (int k = 0; k < 1000; ++k) flood += WebClient::Frame("{\"seq\":2,\"do\":\"ping\"}");
  client.SendBytes(flood);
  EXPECT_EQ(client.Await("error")["error"], "more than 200 requests a second");
  EXPECT_EQ(client.CloseCode(), 1008);
  // Neither do pieces of nothing.
  WebClient other = Join();
  std::string nothing = WebClient::Frame("", 1, false);
  for (int k = 0; k < 1000; ++k) nothing += WebClient::Frame("", 0, false);
  other.SendBytes(nothing);
  EXPECT_EQ(other.CloseCode(), 1008);
}

TEST_F(ServerTest, WrongRequestsAreAnsweredAndManyAreEnough) {
  WebClient client = Connect();
  client.Upgrade();
  EXPECT_EQ(client.Ask({{"do", "ping"}})["error"], "say hello first");
  EXPECT_EQ(client.Ask({{"do", "hello"}, {"version", 2}})["error"], "found version 2, expected 1");
  client.SendText(std::string(100'000, '['));
  EXPECT_EQ(client.Await("reply")["error"], "this JSON is nested deeper than 32 levels");
  for (const char* wrong : {"", "7", "{}", R"({"seq":0,"do":"ping"})", R"({"seq":1,"do":3})",
                            R"({"seq":-1,"do":"ping"})", "\xff", R"({"seq":1e99,"do":"ping"})"}) {
    client.SendText(wrong);
    EXPECT_EQ(client.Await("reply")["ok"], false) << wrong;
  }
  EXPECT_EQ(client.CloseCode(), 1008);
}

TEST_F(ServerTest, WhatIsNoWebSocketIsClosed) {
  const auto code_for = [this](const std::string& bytes) {
    WebClient client = Join();
    client.SendBytes(bytes);
    return client.CloseCode();
  };
  EXPECT_EQ(code_for(std::string("\x81\x02hi", 4)), 1002);        // not masked
  EXPECT_EQ(code_for(std::string("\xF1\x80\1\2\3\4", 6)), 1002);  // reserved bits
  EXPECT_EQ(code_for(WebClient::Frame("", 3)), 1002);             // unknown kind
  EXPECT_EQ(code_for(WebClient::Frame("", 0)), 1002);             // goes on with nothing
  EXPECT_EQ(code_for(WebClient::Frame("", 9, false)), 1002);      // a ping in pieces
  EXPECT_EQ(code_for(WebClient::Frame("", 1, false) + WebClient::Frame("")), 1002);
  EXPECT_EQ(code_for(WebClient::Frame("picture", 2)), 1003);
  EXPECT_EQ(code_for(WebClient::Frame("", 8)), 1000);
}

TEST_F(ServerTest, ThereIsAnEndToClients) {
  options_.limits.clients = 3;
  std::vector<WebClient> clients;
  for (int k = 0; k < 3; ++k) clients.push_back(Join());
  EXPECT_EQ(Connect().Upgrade(), 503);
  clients.pop_back();
  clients[0].Await("clients");  // of the second
  while (clients[0].Await("clients")["clients"].size() != 2) {
  }
  // Its place is free as soon as its connection is closed from here, too.
  int status = 503;
  while (status == 503) status = Connect().Upgrade();
  EXPECT_EQ(status, 101);
}

TEST_F(ServerTest, EndsSoonWhoeverIsThere) {
  WebClient listens = Join(), stalled = Join(), silent = Connect();
  const std::string long_text(200'000, 'x');
  for (int k = 0; k < 30; ++k) {
    server().SendToAll({{"t", "event"}, {"text", long_text}});
    EXPECT_EQ(listens.Await("event")["text"], long_text);
  }
  const auto start = std::chrono::steady_clock::now();
  server_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_EQ(listens.CloseCode(), 1001);
}

}  // namespace
}  // namespace smile::studio

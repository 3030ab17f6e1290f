#include "page/server.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/bytes.h"
#include "page/control_requests.h"
#include "page/page_protocol.h"
#include "texts/message_json.h"
#include "web_client.h"

namespace smile::page {
namespace {

/// A server with a page, and limits that a test can reach.
class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    std::filesystem::create_directories(folder_ / "page");
    std::ofstream(folder_ / "page/index.html") << "<html>the page</html>";
    options_.page = folder_ / "page";
    options_.limits.stall_seconds = 0.3;
    options_.limits.silence_seconds = 0;
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
  /// Returns a client that has said hello and, on request, has received everything.
  WebClient Join(bool has_scene = true) {
    WebClient client = Connect();
    EXPECT_EQ(client.Upgrade(), 101);
    EXPECT_EQ(client.Hello()["ok"], true);
    if (has_scene) server().TakeNewClients();
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

TEST_F(ServerTest, ExplainsHowToBuildAMissingPage) {
  options_.page = folder_ / "nowhere";
  EXPECT_THROW(server(), std::runtime_error);
}

TEST_F(ServerTest, AControllerCanHandOver) {
  WebClient first = Join(), second = Join();
  const Json client = first.Ask({{"do", "take_control"}});
  EXPECT_EQ(client["granted"], true);
  EXPECT_EQ(first.Await("clients")["controller"], 1);
  EXPECT_TRUE(server().IsController(1));

  EXPECT_EQ(second.Ask({{"do", "take_control"}})["granted"], false);
  EXPECT_EQ(first.Await("control_wanted")["by"], 2);
  EXPECT_EQ(second.Ask({{"do", "give_control"}, {"to", 2}})["ok"], false);
  EXPECT_EQ(texts::MessageOf(first.Ask({{"do", "give_control"}, {"to", 9}})["error"]),
            "there is no client 9 to give control to");
  EXPECT_EQ(first.Ask({{"do", "give_control"}, {"to", 2}})["ok"], true);
  EXPECT_TRUE(server().IsController(2));
}

TEST_F(ServerTest, SendsMessagesThatMatchTheTables) {
  const auto expect_fits_protocol = [](const Json& message, const std::string& request = "") {
    EXPECT_TRUE(message.is_object());
    EXPECT_EQ(MisfitOf(message, request), "") << ToText(message);
  };
  WebClient first = Connect();
  first.Upgrade();
  expect_fits_protocol(first.Hello(), "hello");
  expect_fits_protocol(first.Ask({{"do", "take_control"}}), "take_control");
  expect_fits_protocol(first.Await("clients"));
  WebClient second = Join();
  expect_fits_protocol(second.Ask({{"do", "take_control"}}), "take_control");
  expect_fits_protocol(first.Await("control_wanted"));
  expect_fits_protocol(first.Ask({{"do", "give_control"}, {"to", 9}}), "give_control");
  expect_fits_protocol(first.Ask({{"do", "give_control"}, {"to", 2}}), "give_control");
  expect_fits_protocol(second.Await("clients"));

  RequestTable table;
  AddControlRequests(&table);
  const Request keep{.client = 2, .seq = 1, .what = "keep_control", .fields = {{"from", 1}}};
  expect_fits_protocol(Answer(table, keep, /*is_controller=*/true), "keep_control");
  for (const DeferredMessage& deferred : TakeDeferred(table))
    expect_fits_protocol(deferred.message);
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

TEST_F(ServerTest, UpdatesAreSentOnlyToClientsThatHaveTheScene) {
  WebClient client = Join(/*has_scene=*/false);
  server().SendToAll({{"t", "event"}, {"kind", "early"}});
  EXPECT_EQ(server().TakeNewClients(), std::vector<ClientId>{1});
  EXPECT_TRUE(server().TakeNewClients().empty());
  server().SendToAll({{"t", "event"}, {"kind", "late"}});
  EXPECT_EQ(client.Await("event")["kind"], "late");
}

TEST_F(ServerTest, PosesContainMovedFramesAndAcknowledgeRequests) {
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

TEST_F(ServerTest, AClientThatReadsNothingIsDisconnectedWithoutHarm) {
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

TEST_F(ServerTest, ReportsTheLimitToFloodingClientsAndClosesThem) {
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
  EXPECT_EQ(client.Ask({{"do", "ping"}})["error"], "send hello first");
  EXPECT_EQ(client.Ask({{"do", "hello"}, {"version", 2}})["error"], "found version 2, expected 1");
  client.SendText(std::string(100'000, '['));
  EXPECT_EQ(client.Await("reply")["error"], "this JSON is nested deeper than 32 levels");
  for (const char* wrong : {"", "7", "{}", R"({"seq":0,"do":"ping"})", R"({"seq":1,"do":3})",
                            R"({"seq":-1,"do":"ping"})", R"([1])", R"({"seq":1e99,"do":"ping"})"}) {
    client.SendText(wrong);
    EXPECT_EQ(client.Await("reply")["ok"], false) << wrong;
  }
  EXPECT_EQ(client.CloseCode(), 1008);
}

TEST_F(ServerTest, RequestsAreTextInUtf8) {
  WebClient bytes = Join();
  bytes.SendBytes(WebClient::Frame("picture", 2));
  EXPECT_EQ(bytes.CloseCode(), 1003);
  WebClient text = Join();
  text.SendText("{\"seq\":1,\"do\":\"\xff\"}");
  EXPECT_EQ(text.CloseCode(), 1007);
}

TEST_F(ServerTest, ClientsWithoutHelloHoldNoPlaceForLong) {
  options_.limits.hello_seconds = 1;
  WebClient silent = Connect(), polite = Join();
  EXPECT_EQ(silent.Upgrade(), 101);
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  server().TakeRequests();
  EXPECT_EQ(silent.CloseCode(), 1008);
  EXPECT_EQ(polite.Ask({{"do", "ping"}})["ok"], true);
}

TEST_F(ServerTest, ClientsWithoutHelloMakeRoomForOthers) {
  WebClient controller = Join();
  std::vector<WebClient> silent;
  for (int k = 0; k < 63; ++k) {
    silent.push_back(Connect());
    ASSERT_EQ(silent.back().Upgrade(), 101) << k;
  }
  std::vector<WebClient> others;
  for (int k = 0; k < 5; ++k) others.push_back(Join());
  EXPECT_EQ(silent.front().CloseCode(), 1008) << "the oldest";
  EXPECT_EQ(controller.Ask({{"do", "ping"}})["ok"], true) << "not those who said hello";
}

TEST_F(ServerTest, TheNumberOfClientsIsLimited) {
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

TEST_F(ServerTest, EndsSoonWithConnectedClients) {
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
}  // namespace smile::page

// WebSockets, and what becomes of clients that are not browsers.

#include <fstream>

#include "web_server_fixture.h"

namespace smile::web_server {
namespace {

/// Memory of this process in use [bytes].
std::size_t ResidentBytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// The masked head of a frame that announces `bytes` and has none.
std::string HeadAnnouncing(std::uint64_t bytes, int first_byte) {
  std::string head{static_cast<char>(first_byte), '\xFF'};
  for (int k = 7; k >= 0; --k) head.push_back(static_cast<char>(bytes >> (8 * k)));
  return head + std::string("\1\2\3\4");
}

TEST_F(WebServerTest, ShakesHandsAsTheStandardRequires) {
  WebClient client = Connect();
  client.Upgrade();
  EXPECT_NE(client.head().find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="),
            std::string::npos);
}

TEST_F(WebServerTest, EchoesTextAndBytes) {
  WebClient client = Join();
  client.SendBytes(WebClient::Frame("text") + WebClient::Frame(std::string("\0\xFF", 2), 2));
  EXPECT_EQ(client.Next()->payload, "text");
  const std::optional<WebClient::Message> bytes = client.Next();
  EXPECT_EQ(bytes->opcode, 2);
  EXPECT_EQ(bytes->payload, std::string("\0\xFF", 2));
  const std::string long_text(1 << 20, 'x');
  client.SendText(long_text);
  EXPECT_EQ(client.Next()->payload, long_text);
  client.SendText("bye");
  EXPECT_EQ(client.CloseCode(), 1000);
}

TEST_F(WebServerTest, FramesMayFollowTheirRequestInOnePacket) {
  WebClient client = Connect();
  client.SendRequest("/ws",
                     "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                     "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n" +
                         WebClient::Frame("early"));
  EXPECT_TRUE(IsStatus(client.ReadResponse(), 101));
  EXPECT_EQ(client.Next()->payload, "early");
}

TEST_F(WebServerTest, AFrameOfAnyAnnouncedLengthTakesNoMemory) {
  server();
  const std::size_t before = ResidentBytes();
  for (const std::uint64_t announced : {1ULL << 21, 1ULL << 30, 1ULL << 40, (1ULL << 63) - 1}) {
    WebClient client = Join();
    // Its head alone is enough to refuse it.
    client.SendBytes(HeadAnnouncing(announced, 0x81));
    EXPECT_EQ(client.CloseCode(), 1009) << announced;
  }
  WebClient endless = Join();
  endless.SendBytes(HeadAnnouncing(1ULL << 40, 0x82));
  const std::string piece(1 << 20, 'x');
  for (int k = 0; k < 64 && endless.SendBytes(piece); ++k) {
  }
  WebClient in_pieces = Join();
  const std::string much(700'000, ' ');
  in_pieces.SendBytes(WebClient::Frame(much, 1, false) + WebClient::Frame(much, 0, true));
  EXPECT_EQ(in_pieces.CloseCode(), 1009);
#ifndef __SANITIZE_ADDRESS__
  EXPECT_LT(ResidentBytes(), before + (16 << 20));
#endif
}

TEST_F(WebServerTest, TextThatIsNoUtf8EndsWith1007) {
  for (const char* wrong : {"\xff", "\xc3", "\xed\xa0\x80", "\xf5\x80\x80\x80", "ok\xc0\xaf"}) {
    WebClient client = Join();
    client.SendText(wrong);
    EXPECT_EQ(client.CloseCode(), 1007) << wrong;
  }
  // A character may be cut by frames.
  WebClient client = Join();
  client.SendBytes(WebClient::Frame("\xc3", 1, false) + WebClient::Frame("\xa4", 0));
  EXPECT_EQ(client.Next()->payload, "\xc3\xa4");
}

TEST_F(WebServerTest, OtherProtocolsAreClosed) {
  const auto code_for = [this](const std::string& bytes) {
    WebClient client = Join();
    client.SendBytes(bytes);
    return client.CloseCode();
  };
  EXPECT_EQ(code_for(std::string("\x81\x02hi", 4)), 1002);        // not masked
  EXPECT_EQ(code_for(std::string("\xF1\x80\1\2\3\4", 6)), 1002);  // reserved bits
  EXPECT_EQ(code_for(WebClient::Frame("", 3)), 1002);             // unknown kind
  EXPECT_EQ(code_for(WebClient::Frame("", 0)), 1002);             // continues nothing
  EXPECT_EQ(code_for(WebClient::Frame("", 9, false)), 1002);      // a ping in pieces
  EXPECT_EQ(code_for(WebClient::Frame("", 1, false) + WebClient::Frame("")), 1002);
  EXPECT_EQ(code_for(HeadAnnouncing(5, 0x81)), 1002);  // more bytes of length than it takes
  EXPECT_EQ(code_for(WebClient::Frame("", 8)), 1000);
  EXPECT_TRUE(IsStatus(Connect().Get("/ws"), 426));
}

TEST_F(WebServerTest, AnyFloodEndsTheConnection) {
  const auto code_for = [this](const std::string& first, const std::string& again) {
    WebClient client = Join();
    std::string flood = first;
    for (int k = 0; k < 1000; ++k) flood += again;
    client.SendBytes(flood);
    return client.CloseCode();
  };
  EXPECT_EQ(code_for("", WebClient::Frame("x")), 1008);
  EXPECT_EQ(code_for(WebClient::Frame("", 1, false), WebClient::Frame("", 0, false)), 1008);
  EXPECT_EQ(code_for("", WebClient::Frame("ping", 9)), 1008);
  EXPECT_EQ(code_for("", WebClient::Frame("", 10)), 1008);
  // What is allowed is not one.
  WebClient client = Join();
  std::string messages;
  for (int k = 0; k < 190; ++k) messages += WebClient::Frame(std::string(200, 'x'));
  client.SendBytes(messages);
  for (int k = 0; k < 190; ++k) ASSERT_TRUE(client.Next()) << k;
}

TEST_F(WebServerTest, AHandlerThatWaitsLeavesTheRestInTheNetwork) {
  handler_.SetMaxReceived(1);
  WebClient client = Join();
  client.SendBytes(WebClient::Frame("one") + WebClient::Frame("two"));
  EXPECT_EQ(client.Next()->payload, "one");
  handler_.SetMaxReceived(2);
  server().Resume();
  EXPECT_EQ(client.Next()->payload, "two");
}

TEST_F(WebServerTest, AClientThatReadsNothingIsDisconnectedAndDelaysNoOther) {
  WebClient stalled = Join(), other = Join();
  const std::string long_text(200'000, 'x');
  for (int k = 0; handler_.num_open() == 2; ++k) {
    ASSERT_LT(k, 2000);
    handler_.SendToAll(long_text + std::to_string(k));
    server().Resume();
    EXPECT_EQ(other.Next()->payload, long_text + std::to_string(k));
    usleep(2000);
  }
}

TEST_F(WebServerTest, ARefusedClientReceives503) {
  handler_.SetPlaces(1);
  WebClient client = Join();
  EXPECT_EQ(Connect().Upgrade(), 503);
  client.Leave();
  int status = 503;
  while (status == 503) status = Connect().Upgrade();
  EXPECT_EQ(status, 101);
}

}  // namespace
}  // namespace smile::web_server

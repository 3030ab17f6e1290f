// Brains that another program serves, over real sockets on this machine.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <thread>

#include "base/diagnostic.h"
#include "brain/internal_served_brain.h"
#include "brain_fixture.h"
#include "process/unique_fd.h"
#include "wire/wire.h"

namespace smile::brain {
namespace {

using wire::MessageType;
using wire::MessageWriter;

/// A server with one client: what it does with its connection. It joins in the end.
class OneClientServer {
 public:
  /// @param path  of a Unix socket; empty: a free port of 127.0.0.1.
  OneClientServer(const std::string& path, std::function<void(int)> talk) {
    listener_ = process::UniqueFd(::socket(path.empty() ? AF_INET : AF_UNIX, SOCK_STREAM, 0));
    if (path.empty()) {
      sockaddr_in name = {};
      name.sin_family = AF_INET;
      name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      Bind(reinterpret_cast<sockaddr*>(&name), sizeof name);
      socklen_t size = sizeof name;
      ::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&name), &size);
      address_ = "tcp://127.0.0.1:" + std::to_string(ntohs(name.sin_port));
    } else {
      sockaddr_un name = {};
      name.sun_family = AF_UNIX;
      path.copy(name.sun_path, sizeof name.sun_path - 1);
      Bind(reinterpret_cast<sockaddr*>(&name), sizeof name);
      address_ = "unix:" + path;
    }
    thread_ = std::thread([this, talk = std::move(talk)] {
      const process::UniqueFd client(::accept(listener_.get(), nullptr, nullptr));
      talk(client.get());
    });
  }
  ~OneClientServer() { thread_.join(); }

  const std::string& address() const { return address_; }

 private:
  void Bind(const sockaddr* name, socklen_t size) {
    EXPECT_EQ(::bind(listener_.get(), name, size), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
  }

  process::UniqueFd listener_;
  std::string address_;
  std::thread thread_;
};

void SendFrame(int client, const std::vector<std::byte>& frame) {
  EXPECT_EQ(::send(client, frame.data(), frame.size(), MSG_NOSIGNAL),
            static_cast<ssize_t>(frame.size()));
}

std::vector<std::byte> HelloFrame() {
  MessageWriter writer(MessageType::kHello, 0);
  writer.AddScalar("version", wire::kProtocolVersion);
  return writer.Finish();
}

/// Reads a question. @returns its sequence; 0 at the end of the connection.
std::uint32_t ReadQuestion(int client) {
  std::uint32_t header[4];
  if (::recv(client, header, sizeof header, MSG_WAITALL) != sizeof header) return 0;
  std::vector<std::byte> body(header[3]);
  return ::recv(client, body.data(), body.size(), MSG_WAITALL) < 0 ? 0 : header[2];
}

void GreetAndStart(int client) {
  SendFrame(client, HelloFrame());
  SendFrame(client, MessageWriter(MessageType::kInitDone, ReadQuestion(client)).Finish());
}

std::string ServedError(const std::string& address, const BrainOptions& options = {}) {
  BrainProcess brain(address, options);
  const auto begun = brain.Init(Classic(Aux()));
  const std::string error = std::holds_alternative<BrainError>(begun)
                                ? ErrorIn(begun)
                                : ErrorIn(brain.Step(Classic(Sensor())));
  EXPECT_FALSE(brain.is_running());
  return error;
}

std::string RejectionOf(const std::string& address) {
  try {
    BrainProcess{address};
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

class ServedBrain : public BrainProcessTest {};

TEST_F(ServedBrain, AnswersOverEitherSocket) {
  for (const std::string& path : {std::string(), (root_ / "socket").string()}) {
    OneClientServer server(path, [&](int client) {
      GreetAndStart(client);
      MessageWriter motor(MessageType::kMotor, ReadQuestion(client));
      const std::vector<double> velocities(14, 0.25);
      motor.AddDoubles("jointVelocities", std::vector<std::uint32_t>{2, 7}, velocities);
      motor.AddDoubles("gripperVelocities", std::vector<std::uint32_t>{2, 1},
                       std::vector<double>(2));
      SendFrame(client, motor.Finish());
      EXPECT_NE(ReadQuestion(client), 0u);  // BYE
      EXPECT_EQ(ReadQuestion(client), 0u);
    });
    {
      BrainProcess brain(server.address());
      Started(brain);
      const StepReply reply = Stepped(brain);
      EXPECT_TRUE(brain.is_running());
      EXPECT_EQ(reply.motors.front().arms[1].velocities[6], 0.25);
    }
  }
}

TEST_F(ServedBrain, SaysWhyAConnectionFailed) {
  EXPECT_EQ(ServedError("unix:" + (root_ / "nobody").string()),
            "unix:" + (root_ / "nobody").string() +
                ": cannot connect to the brain: No such file or directory, expected a program that "
                "serves one there");
  std::string closed;
  {
    OneClientServer server("", [](int) {});
    closed = server.address();
    EXPECT_EQ(ServedError(closed),
              closed + ": the connection to the brain was lost during the start: end of file");
  }
  EXPECT_EQ(ServedError(closed),
            closed +
                ": cannot connect to the brain: Connection refused, expected a "
                "program that serves one there");
  EXPECT_NE(ServedError("tcp://no-such-host.invalid:80")
                .find("the host 'no-such-host.invalid' is unknown"),
            std::string::npos);
}

TEST_F(ServedBrain, IsLostWithACause) {
  {
    OneClientServer server("", [](int client) {
      GreetAndStart(client);
      ReadQuestion(client);
      // Closes with a reset.
      const linger now{.l_onoff = 1, .l_linger = 0};
      ::setsockopt(client, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    });
    EXPECT_EQ(
        ServedError(server.address()),
        server.address() +
            ": the connection to the brain was lost during the callback: Connection reset by peer");
  }
  OneClientServer server(
      "", [](int client) { SendFrame(client, std::vector<std::byte>(64, std::byte{'x'})); });
  EXPECT_NE(
      ServedError(server.address()).find("the brain sent an invalid message during the start"),
      std::string::npos);
}

TEST_F(ServedBrain, IsDisconnectedWhenItIsLate) {
  {
    OneClientServer server("", [](int client) { ReadQuestion(client); });  // says nothing
    EXPECT_EQ(ServedError(server.address(), {.start_seconds = 0.3}),
              server.address() + ": the start took longer than 0.3 s and was disconnected");
  }
  OneClientServer server("", [](int client) {
    GreetAndStart(client);
    while (ReadQuestion(client) != 0) continue;
  });
  EXPECT_EQ(ServedError(server.address(), {.callback_seconds = 0.3}),
            server.address() + ": the callback took longer than 0.3 s and was disconnected");
}

TEST_F(ServedBrain, StopsWaitingWhenItIsCancelled) {
  OneClientServer server("", [](int client) { ReadQuestion(client); });
  EXPECT_EQ(ServedError(server.address(), {.is_cancelled = [] { return true; }}),
            server.address() + ": the brain was stopped during the start");
}

TEST_F(ServedBrain, HasAnAddress) {
  const auto six = ParseServerAddress("tcp://[::1]:8000");
  EXPECT_EQ(six->host + " " + six->port, "::1 8000");
  EXPECT_EQ(ParseServerAddress("unix:a/b:c")->path, "a/b:c");
  EXPECT_FALSE(ParseServerAddress("brains/tcp.py"));
  for (const char* wrong : {"tcp://", "tcp://host", "tcp://host:", "tcp://:80", "tcp://host:0",
                            "tcp://host:65536", "tcp://host:8x", "tcp://::1:80", "tcp://[]:80"}) {
    EXPECT_EQ(RejectionOf(wrong), std::string(wrong) +
                                      ": not an address, expected tcp://HOST:PORT with a port "
                                      "from 1 to 65535");
  }
  EXPECT_EQ(RejectionOf("unix:"),
            "unix:: the path has 0 letters, expected unix:PATH with 1 to 107");
}

}  // namespace
}  // namespace smile::brain

#include "brain_client/simulator_connection.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>
#include <vector>

#include "brain_client/brain.h"
#include "brain_client/message_outline.h"
#include "wire/test/wire_verbs.h"

namespace smile::brain_client {
namespace {

using wire::ElementType;
using wire::MessageType;
using wire::MessageWriter;

/// Plays the simulator of a brain.
class SimulatorConnectionTest : public testing::Test {
 protected:
  SimulatorConnectionTest() {
    std::string name = (std::filesystem::temp_directory_path() / "brain-client-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    Address().copy(address.sun_path, sizeof address.sun_path - 1);
    listener_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
  }
  ~SimulatorConnectionTest() override {
    HangUp();
    ::close(listener_);
    std::filesystem::remove_all(folder_);
  }

  std::string Address() const { return (folder_ / "socket").string(); }
  void Accept() { socket_ = ::accept(listener_, nullptr, nullptr); }
  void HangUp() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  /// From a thread of its own where it is too much for the socket.
  void Say(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return;
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }

  /// A short message.
  wire::Message Receive() const {
    std::array<std::byte, 4096> bytes;
    const ssize_t count = ::read(socket_, bytes.data(), bytes.size());
    return wire::Decoded(
        std::span(bytes).first(static_cast<std::size_t>(std::max<ssize_t>(0, count))));
  }

  std::filesystem::path folder_;
  int listener_ = -1, socket_ = -1;
};

std::vector<std::byte> Step(std::uint32_t sequence) {
  MessageWriter writer(MessageType::kStep, sequence);
  writer.AddScalar("simTime", sequence);
  return writer.Finish();
}

TEST_F(SimulatorConnectionTest, GreetingFollowsTheProtocol) {
  SimulatorConnection connection(Address());
  Accept();
  connection.Greet({.client = "lua", .language = "5.4", .takes_rows = true});
  const wire::Message hello = Receive();
  EXPECT_EQ(hello.type, MessageType::kHello);
  EXPECT_EQ(hello.Find("version")->Numbers(), std::vector<double>{wire::kProtocolVersion});
  EXPECT_EQ(hello.TextOf("client"), "lua");
  EXPECT_EQ(hello.TextOf("language"), "5.4");
  EXPECT_EQ(hello.Find("guard")->Numbers(), std::vector{0.0});
  EXPECT_EQ(hello.Find("rows")->Numbers(), std::vector{1.0});
}

TEST_F(SimulatorConnectionTest, ReceivesMessagesAndTheEnd) {
  SimulatorConnection connection(Address());
  Accept();
  EXPECT_FALSE(connection.HasArrivals(0));
  Say(Step(1));
  Say(Step(2));
  EXPECT_TRUE(connection.HasArrivals(1000));
  EXPECT_EQ(connection.Receive()->sequence, 1u);
  EXPECT_TRUE(connection.HasArrivals(0)) << "what came together with the first one";
  EXPECT_EQ(connection.Receive()->sequence, 2u);
  EXPECT_FALSE(connection.HasArrivals(0));
  std::vector<std::byte> half = Step(3);
  half.resize(half.size() / 2);
  Say(half);
  HangUp();
  EXPECT_TRUE(connection.HasArrivals(1000));
  EXPECT_FALSE(connection.Receive()) << "half a message is no message";
  EXPECT_THROW(connection.Send(Step(4)), SimulatorGone);
}

TEST_F(SimulatorConnectionTest, LeavesPicturesWhereTheyWereReceived) {
  MessageWriter writer(MessageType::kStep, 7);
  const auto pixels = writer.AddSpace("rgb", ElementType::kByte, true, std::array{480u, 640u, 3u});
  for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = std::byte(k % 251);
  const std::vector<std::byte> frame = writer.Finish();

  std::vector<std::byte> room;
  SimulatorConnection connection(Address(), {.make_room = [&room](std::size_t size) {
                                   room.resize(size);
                                   return std::span(room);
                                 }});
  Accept();
  std::thread simulator([&] { Say(frame); });
  const auto message = connection.Receive();
  simulator.join();
  ASSERT_TRUE(message);
  EXPECT_TRUE(std::ranges::equal(room, std::span(frame).subspan(wire::kHeaderBytes)));
  const std::span<const std::byte> data = message->arrays.at(0).data;
  EXPECT_EQ(data.data() + data.size(), room.data() + room.size());
}

TEST_F(SimulatorConnectionTest, RefusesInvalidMessagesBeforeAllocatingMemory) {
  bool has_made_room = false;
  SimulatorConnection connection(Address(), {.make_room = [&](std::size_t) {
                                   has_made_room = true;
                                   return std::span<std::byte>();
                                 }});
  Accept();
  std::vector<std::byte> frame = Step(1);
  std::fill_n(frame.begin() + 12, 4, std::byte{0xff});
  Say(frame);
  try {
    connection.Receive();
    ADD_FAILURE() << "a message of 4 GiB";
  } catch (const ProtocolError& error) {
    EXPECT_STREQ(error.what(), "a message of 4294967295 bytes, expected at most 67108864");
  }
  EXPECT_FALSE(has_made_room);
}

TEST_F(SimulatorConnectionTest, ASignalEndsAWait) {
  struct sigaction quiet = {}, before = {};
  quiet.sa_handler = [](int) {};
  ::sigaction(SIGALRM, &quiet, &before);
  SimulatorConnection connection(
      Address(), {.make_room = {}, .on_signal = [] { throw std::domain_error("Ctrl-C"); }});
  Accept();
  // Again and again: the first may come before there is anything to interrupt.
  const itimerval often{{0, 10'000}, {0, 10'000}}, never{};
  ::setitimer(ITIMER_REAL, &often, nullptr);
  EXPECT_THROW(connection.Receive(), std::domain_error);
  ::setitimer(ITIMER_REAL, &never, nullptr);
  ::sigaction(SIGALRM, &before, nullptr);
  Say(Step(5));
  EXPECT_EQ(connection.Receive()->sequence, 5u);
}

TEST(SimulatorConnection, NamesTheAddressThatItCannotConnectTo) {
  try {
    SimulatorConnection connection("/nowhere/socket");
    ADD_FAILURE() << "connected";
  } catch (const std::system_error& error) {
    EXPECT_STREQ(error.what(), "/nowhere/socket: No such file or directory");
  }
  EXPECT_THROW(SimulatorConnection(std::string(200, 'x')), std::system_error);
}

/// Watches whenever there is something to be watched, then turns its head and sends chunks.
class Watcher : public Brain {
  void Init(Aux& aux) override {
    aux.watch = aux.Has("demonstration");
    aux.image_seconds = 2;
    aux.cameras = {"left_hand"};
  }
  void Step(const Sensor& sensor, Motor& motor, Aux& aux) override {
    aux.cameras.clear();
    aux.notes = {"saw: nothing", "saw: a block"};
    aux.note_cameras = {"", "left_hand"};
    if (sensor.Number("demoCue") != 0) return;
    motor.head_velocity = 0.5;
    motor.joint_velocities = Eigen::MatrixXd::Ones(2, 7 * 3);
    motor.gripper_velocities = Eigen::VectorXd::Ones(2 * 3);
    motor.ticks = 4;
  }
};

TEST_F(SimulatorConnectionTest, ABrainInCppSendsItsSettingsAndAnswers) {
  ::setenv("SMILE_BRAIN_ADDRESS", Address().c_str(), 1);
  Watcher brain;
  int result = -1;
  std::thread thread([&] { result = brain_client::Run(brain); });
  Accept();
  EXPECT_EQ(Receive().type, MessageType::kHello);
  MessageWriter init(MessageType::kInit, 1);
  init.AddScalar("numLimbs", 2);
  init.AddScalar("numJoints", 7);
  init.AddText("demonstration", "out/demo");
  Say(init.Finish());
  const wire::Message wishes = Receive();
  EXPECT_EQ(wishes.type, MessageType::kInitDone);
  EXPECT_EQ(wishes.Find("watch")->Numbers(), std::vector{1.0});
  EXPECT_EQ(wishes.Find("imageSeconds")->Numbers(), std::vector{2.0});
  for (const bool is_shown : {true, false}) {
    MessageWriter step(MessageType::kStep, 2);
    step.AddLogical("demoCue", is_shown);
    Say(step.Finish());
    const wire::Message motor = Receive();
    EXPECT_EQ(motor.type, MessageType::kMotor);
    EXPECT_EQ(motor.Find("headVelocity") == nullptr, is_shown);
    EXPECT_EQ(motor.Find("ticks") == nullptr, is_shown);
    EXPECT_EQ(motor.TextOf("noteCameras"), "\nleft_hand\n");
    EXPECT_EQ(motor.Find("cameras") != nullptr, is_shown) << "only the first step changes them";
    using Dims = std::vector<std::uint32_t>;
    EXPECT_EQ(motor.Find("jointVelocities")->dims, is_shown ? Dims({2, 7}) : Dims({2, 7, 3}));
    EXPECT_EQ(motor.Find("gripperVelocities")->dims, is_shown ? Dims({2, 1}) : Dims({2, 3}));
  }
  HangUp();
  thread.join();
  EXPECT_EQ(result, 0);
  ::unsetenv("SMILE_BRAIN_ADDRESS");
}

/// Turns each joint by its angle.
class Mirror : public Brain {
 public:
  void Init(Aux& aux) override { aux.arms.at(1).init_joints = aux.arms[1].max_joints; }
  void Step(const Sensor& sensor, Motor& motor, Aux&) override {
    for (std::size_t k = 0; k < 2; ++k) motor.arms.at(k).velocities = sensor.arms.at(k).joints;
    if (sensor.arms[0].gripper) motor.arms[0].gripper_velocity[0] = *sensor.arms[0].gripper;
    if (sensor.arms[1].gripper) throw std::runtime_error("the second arm has no gripper");
    if (sensor.Number("simTime") > 0) (void)sensor.Matrix("jointAngles");
  }
};

TEST_F(SimulatorConnectionTest, ABrainInCppDrivesAnyArms) {
  ::setenv("SMILE_BRAIN_ADDRESS", Address().c_str(), 1);
  Mirror brain;
  std::thread thread([&] { brain_client::Run(brain); });
  Accept();
  Receive();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::array row_of_three{1u, 3u}, row_of_two{1u, 2u};
  MessageWriter init(MessageType::kInit, 1);
  init.AddText("armNames", "rail\narm");
  init.AddText("armJointNames", "slide\na\nb");
  init.AddDoubles("armJointCounts", row_of_two, std::array{1.0, 2.0});
  for (const char* name : {"armMinJoints", "armMaxJoints", "armMaxVelocities"}) {
    init.AddDoubles(name, row_of_three, std::array{1.0, 2.0, 3.0});
  }
  init.AddDoubles("armGrippers", std::array{2u, 2u}, std::array{0.0, 1.0, kNone, kNone});
  init.AddDoubles("armToolPoses", std::array{4u, 4u, 2u}, std::array<double, 32>{});
  Say(init.Finish());
  const wire::Message settings = Receive();
  EXPECT_EQ(settings.Find("armJoints")->Numbers(), (std::vector{0.0, 2.0, 3.0}));
  EXPECT_EQ(settings.Find("armsAtJoints")->Numbers(), (std::vector{0.0, 1.0}));
  for (const double time : {0.0, 1.0}) {
    MessageWriter step(MessageType::kStep, 2);
    step.AddScalar("simTime", time);
    step.AddDoubles("armJoints", row_of_three, std::array{0.1, 0.2, 0.3});
    step.AddDoubles("armVelocities", row_of_three, std::array<double, 3>{});
    step.AddDoubles("armGrippers", row_of_two, std::array{0.5, kNone});
    step.AddDoubles("armEndEffectors", std::array{4u, 4u, 2u}, std::array<double, 32>{});
    step.AddText("armHeldObjects", "\n");
    Say(step.Finish());
    const wire::Message motor = Receive();
    if (time > 0) {
      EXPECT_TRUE(motor.TextOf("message").ends_with(
          "; it is for two arms of seven joints, use sensor.arms[k].joints"))
          << motor.TextOf("message");
    } else {
      EXPECT_EQ(motor.Find("armVelocities")->Numbers(), (std::vector{0.1, 0.2, 0.3}));
      EXPECT_EQ(motor.Find("armGripperVelocities")->Numbers(), (std::vector{0.5, 0.0}));
      EXPECT_EQ(motor.Find("jointVelocities"), nullptr);
    }
  }
  HangUp();
  thread.join();
  ::unsetenv("SMILE_BRAIN_ADDRESS");
}

TEST(MessageOutline, ChangesWithAllButNumbers) {
  MessageOutline outline;
  const auto changes = [&outline](double time, const char* held, std::uint32_t columns,
                                  const char* name) {
    MessageWriter writer(MessageType::kStep, 1);
    writer.AddScalar("simTime", time);
    writer.AddText("heldObject", held);
    writer.AddSpace(name, ElementType::kDouble, false, std::array{2u, columns});
    const std::vector<std::byte> frame = writer.Finish();
    const auto body = std::span(frame).subspan(wire::kHeaderBytes);
    const auto view = wire::DecodeBody(
        {.type = MessageType::kStep, .body_bytes = static_cast<std::uint32_t>(body.size())}, body);
    return outline.Changes(std::get<wire::MessageView>(view));
  };
  EXPECT_TRUE(changes(1, "a", 7, "jointAngles"));
  EXPECT_FALSE(changes(2, "a", 7, "jointAngles"));
  EXPECT_TRUE(changes(2, "b", 7, "jointAngles"));
  EXPECT_TRUE(changes(2, "b", 6, "jointAngles"));
  EXPECT_TRUE(changes(2, "b", 6, "jointAngels"));
  EXPECT_FALSE(changes(3, "b", 6, "jointAngels"));
}

}  // namespace
}  // namespace smile::brain_client

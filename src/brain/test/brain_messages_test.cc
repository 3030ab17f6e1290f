#include "brain/brain_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "classic_arms.h"
#include "wire/test/wire_verbs.h"

namespace smile::brain {
namespace {

using wire::Decoded;
using wire::kTwoBySeven;

constexpr std::array kTwoByOne{2u, 1u};

/// A motor message that is right, for tests to spoil.
class MotorMessage {
 public:
  explicit MotorMessage(MessageType type = MessageType::kMotor) : writer_(type, 1) {}

  /// The brain requested these cameras in init.
  MotorMessage& Requested(std::vector<std::string> cameras) {
    cameras_ = std::move(cameras);
    return *this;
  }
  MotorMessage& Velocities(std::span<const std::uint32_t> dims, std::span<const double> values) {
    writer_.AddDoubles("jointVelocities", dims, values);
    return *this;
  }
  MotorMessage& Velocities() { return Velocities(kTwoBySeven, std::array<double, 14>{}); }
  MotorMessage& Grippers(std::span<const std::uint32_t> dims, std::span<const double> values) {
    writer_.AddDoubles("gripperVelocities", dims, values);
    return *this;
  }
  MotorMessage& Grippers() { return Grippers(kTwoByOne, std::array{0.5, -0.5}); }
  MotorMessage& Text(std::string_view name, std::string_view text) {
    writer_.AddText(name, text);
    return *this;
  }
  MotorMessage& Numbers(std::string_view name, std::span<const std::uint32_t> dims,
                        std::span<const double> values) {
    writer_.AddDoubles(name, dims, values);
    return *this;
  }
  MotorMessage& Scalar(std::string_view name, double value) {
    writer_.AddScalar(name, value);
    return *this;
  }

  StepReply Reply() { return std::get<StepReply>(Decode()); }
  std::string Error() { return std::get<WireError>(Decode()).message; }

 private:
  std::variant<StepReply, WireError> Decode() {
    return DecodeStepReply(Decoded(writer_.Finish()), ClassicArms(), cameras_);
  }

  MessageWriter writer_;
  std::vector<std::string> cameras_;
};

TEST(DecodeStepReply, ReadsColumnMajorVelocities) {
  std::array<double, 14> velocities{};
  velocities[1] = 2;  // the right arm's first joint
  const StepReply reply = MotorMessage().Velocities(kTwoBySeven, velocities).Grippers().Reply();
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(1, 0), 2);
  EXPECT_EQ(VelocitiesOf(reply.motors.front()).norm(), 2);
  EXPECT_EQ(GrippersOf(reply.motors.front()), Eigen::Vector2d(0.5, -0.5));
  EXPECT_FALSE(reply.motors.front().arms[0].joints);
  EXPECT_FALSE(reply.motors.front().head_velocity);
  EXPECT_FALSE(reply.exit);
}

TEST(DecodeStepReply, AlsoAcceptsGripperVelocitiesAsARow) {
  const std::array dims{1u, 2u};
  const StepReply reply = MotorMessage().Velocities().Grippers(dims, std::array{3.0, 4.0}).Reply();
  EXPECT_EQ(GrippersOf(reply.motors.front()), Eigen::Vector2d(3, 4));
}

TEST(DecodeStepReply, TakesTheHead) {
  EXPECT_EQ(MotorMessage()
                .Velocities()
                .Grippers()
                .Scalar("headVelocity", 1)
                .Reply()
                .motors.front()
                .head_velocity,
            1.0);
}

/// Velocities 0, 1, 2, … of the joints of successive ticks.
std::vector<double> Counted(std::size_t count) {
  std::vector<double> numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = static_cast<double>(k);
  return numbers;
}

TEST(DecodeStepReply, ReadsAChunkTickByTick) {
  const std::array dims{2u, 7u, 3u};
  const std::array gripper_dims{2u, 2u};
  const StepReply reply = MotorMessage()
                              .Velocities(dims, Counted(42))
                              .Grippers(gripper_dims, Counted(4))
                              .Scalar("headVelocity", 0.5)
                              .Reply();
  EXPECT_EQ(reply.ticks, 3);
  ASSERT_EQ(reply.motors.size(), 3u);
  for (int tick = 0; tick < 3; ++tick) {
    const Motor& motor = reply.motors[static_cast<std::size_t>(tick)];
    EXPECT_EQ(VelocitiesOf(motor)(1, 0), 14 * tick + 1);
    EXPECT_EQ(VelocitiesOf(motor)(0, 6), 14 * tick + 12);
    EXPECT_EQ(GrippersOf(motor)[1], tick == 0 ? 1 : 3) << "the last value remains";
    EXPECT_EQ(motor.head_velocity, 0.5);
  }
}

TEST(DecodeStepReply, ReadsAChunkInRowMajorOrder) {
  MessageWriter writer(MessageType::kMotor, 1);
  const std::array dims{2u, 7u, 2u};
  const auto space = writer.AddSpace("jointVelocities", ElementType::kDouble, false, dims, true);
  std::memcpy(space.data(), Counted(28).data(), space.size());
  writer.AddDoubles("gripperVelocities", kTwoByOne, std::array{0.0, 0.0});
  const auto reply = std::get<StepReply>(DecodeStepReply(Decoded(writer.Finish()), ClassicArms()));
  ASSERT_EQ(reply.motors.size(), 2u);
  EXPECT_EQ(VelocitiesOf(reply.motors[1])(0, 0), 1);
  EXPECT_EQ(VelocitiesOf(reply.motors[0])(1, 2), 14 + 4);
}

TEST(DecodeStepReply, TicksHoldACommandOrCutAChunk) {
  const StepReply held = MotorMessage().Velocities().Grippers().Scalar("ticks", 600).Reply();
  EXPECT_EQ(held.ticks, 600);
  EXPECT_EQ(held.motors.size(), 1u);
  const std::array dims{2u, 7u, 3u};
  const StepReply cut =
      MotorMessage().Velocities(dims, Counted(42)).Grippers().Scalar("ticks", 2).Reply();
  EXPECT_EQ(cut.ticks, 2);
  EXPECT_EQ(cut.motors.size(), 2u);
  EXPECT_EQ(MotorMessage().Velocities().Grippers().Reply().ticks, 1);
}

TEST(DecodeStepReply, RefusesChunksOfImpossibleLength) {
  const auto error_of = [](std::uint32_t ticks) {
    const std::array dims{2u, 7u, ticks};
    return MotorMessage().Velocities(dims, Counted(std::size_t{14} * ticks)).Grippers().Error();
  };
  EXPECT_EQ(error_of(0), "motor.jointVelocities is 2x7x0, expected values for 1 to 600 ticks");
  EXPECT_EQ(error_of(601), "motor.jointVelocities is 2x7x601, expected values for 1 to 600 ticks");
  const std::array wrong{7u, 2u, 3u};
  EXPECT_EQ(MotorMessage().Velocities(wrong, Counted(42)).Grippers().Error(),
            "motor.jointVelocities is 7x2x3, expected 2x7");
  const auto error_of_ticks = [](double ticks) {
    return MotorMessage().Velocities().Grippers().Scalar("ticks", ticks).Error();
  };
  EXPECT_EQ(error_of_ticks(0), "motor.ticks is 0, expected a whole number from 1 to 600");
  EXPECT_EQ(error_of_ticks(601), "motor.ticks is 601, expected a whole number from 1 to 600");
  EXPECT_EQ(error_of_ticks(1.5), "motor.ticks is 1.5, expected a whole number from 1 to 600");
  EXPECT_EQ(error_of_ticks(std::numeric_limits<double>::quiet_NaN()),
            "motor.ticks(1,1) is NaN, expected a finite number");
  std::vector<double> numbers = Counted(42);
  numbers[14 + 3] = 1e9;
  EXPECT_EQ(MotorMessage().Velocities(std::array{2u, 7u, 3u}, numbers).Grippers().Error(),
            "motor.jointVelocities(2,2,2) is 1e+09, expected at most 1e+06");
}

TEST(DecodeStepReply, TakesAnotherTimeBetweenPictures) {
  EXPECT_EQ(MotorMessage().Velocities().Grippers().Scalar("imageSeconds", 2).Reply().image_seconds,
            2.0);
  EXPECT_EQ(MotorMessage().Velocities().Grippers().Scalar("imageSeconds", -1).Error(),
            "aux.imageSeconds is -1, expected a number from 0 to 3600");
}

TEST(DecodeStepReply, ChoosesAmongTheRequestedCameras) {
  using Names = std::vector<std::string>;
  const auto naming = [](const char* names) {
    return MotorMessage().Velocities().Grippers().Text("cameras", names);
  };
  const Names hands{"left_hand", "right_hand"};
  EXPECT_EQ(naming("right_hand").Requested(hands).Reply().cameras, Names{"right_hand"});
  EXPECT_EQ(naming("").Reply().cameras, Names());
  EXPECT_EQ(naming("head").Requested(hands).Error(),
            R"(aux.cameras names "head", expected left_hand or right_hand)");
  EXPECT_EQ(naming("head").Error(),
            "aux.cameras names a camera, expected none: init requested none");
}

TEST(DecodeStepReply, NamesTheVariableAndBothShapes) {
  const std::array wrong{7u, 2u};
  EXPECT_EQ(MotorMessage().Velocities(wrong, std::array<double, 14>{}).Grippers().Error(),
            "motor.jointVelocities is 7x2, expected 2x7");
  const std::array scalar{1u, 1u};
  EXPECT_EQ(MotorMessage().Velocities().Grippers(scalar, std::array{1.0}).Error(),
            "motor.gripperVelocities is 1x1, expected 2x1");
  EXPECT_EQ(MotorMessage().Text("jointVelocities", "fast").Grippers().Error(),
            "motor.jointVelocities is text, expected a 2x7 matrix");
}

TEST(DecodeStepReply, RefusesNumbersThatAreNotFinite) {
  std::array<double, 14> velocities{};
  velocities[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(MotorMessage().Velocities(kTwoBySeven, velocities).Grippers().Error(),
            "motor.jointVelocities(2,3) is NaN, expected a finite number");
  const std::array grippers{0.0, -std::numeric_limits<double>::infinity()};
  EXPECT_EQ(MotorMessage().Velocities().Grippers(kTwoByOne, grippers).Error(),
            "motor.gripperVelocities(2,1) is -Inf, expected a finite number");
}

TEST(DecodeStepReply, ReadsAClaimOfTheLastStepOnly) {
  const auto claimed = [](const std::string& text, MessageType type = MessageType::kFinalMotor) {
    MotorMessage message(type);
    message.Velocities().Grippers().Text("claim", text);
    return message;
  };
  EXPECT_EQ(claimed("done").Reply().claim, (Claim{.is_done = true, .reason = ""}));
  EXPECT_EQ(claimed("gave up: Red1: out of reach").Reply().claim,
            (Claim{.is_done = false, .reason = "Red1: out of reach"}));
  EXPECT_EQ(claimed("finished").Error(),
            "aux.claim is \"finished\", expected done or gave up, optionally followed by a "
            "colon and a reason");
  EXPECT_NE(claimed("done", MessageType::kMotor).Error(), "");
}

TEST(DecodeStepReply, ReadsNotesAndTheTopsThatTheyAreAbout) {
  const auto noted = [](const std::string& text, const std::vector<double>& tops = {}) {
    MotorMessage message;
    message.Velocities().Grippers().Text("notes", text);
    if (!tops.empty()) message.Numbers("noteTops", std::array{1u, 9u}, tops);
    return message;
  };
  const sim::NotedTop top{
      .middle = Vector3(1, -2, 3), .length = 4, .width = 0.5, .yaw = 0.1, .is_round = true};
  const StepReply reply =
      noted("action: to the left\nas expected: Red1: there", {2, 1, 1, -2, 3, 4, 0.5, 0.1, 1})
          .Reply();
  EXPECT_EQ(reply.notes, (std::vector<sim::Note>{
                             {.word = "action", .text = "to the left"},
                             {.word = "as expected", .text = "Red1: there", .found = {top}}}));
  EXPECT_EQ(noted("seen: a block").Error(),
            "aux.notes contains \"seen: a block\", expected understood, plan, saw, action, as "
            "expected, hidden or contradicted, a colon and a sentence");
  EXPECT_EQ(noted("saw: it", {2, 0, 0, 0, 0, 1, 1, 0, 0}).Error(),
            "aux.noteTops(1,1) is 2, expected the number of a note, 1 to 1");
  EXPECT_EQ(MotorMessage().Velocities().Grippers().Scalar("noteTops", 1).Error(),
            "aux.noteTops is given without notes");
}

TEST(DecodeStepReply, ReadsOfWhichCameraANoteIs) {
  const std::vector<std::string> cameras{"left_hand", "right_hand"};
  const auto noted = [](const std::string& names) {
    MotorMessage message;
    message.Velocities().Grippers().Text("notes", "saw: it\nsaw: more\nsaw: all");
    message.Text("noteCameras", names);
    return message;
  };
  const std::vector<sim::Note> notes = noted("\nright_hand").Requested(cameras).Reply().notes;
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0].camera, "");
  EXPECT_EQ(notes[1].camera, "right_hand");
  EXPECT_EQ(notes[2].camera, "");
  EXPECT_EQ(noted("head").Requested(cameras).Error(),
            "aux.noteCameras contains \"head\", expected left_hand or right_hand, or nothing for "
            "the eye");
  EXPECT_EQ(noted("head").Error(),
            "aux.noteCameras contains \"head\", expected nothing: init requested no cameras");
  EXPECT_EQ(noted("\n\n\n\n").Error(),
            "aux.noteCameras has more lines than notes, expected at most 3");
  EXPECT_EQ(MotorMessage().Velocities().Grippers().Text("noteCameras", "eye").Error(),
            "aux.noteCameras is given without notes");
}

TEST(DecodeStepReply, RefusesUnknownAndMissingFields) {
  EXPECT_EQ(MotorMessage().Velocities().Grippers().Scalar("jointVelocity", 1).Error(),
            "motor.jointVelocity is unknown, expected jointVelocities, gripperVelocities, "
            "jointAngles, arms, headVelocity or ticks");
  EXPECT_EQ(MotorMessage().Grippers().Error(), "motor.jointVelocities is missing, expected 2x7");
  EXPECT_EQ(MotorMessage().Velocities().Error(),
            "motor.gripperVelocities is missing, expected 2x1");
}

/// A motor message in the general form, for tests to spoil.
class ArmsMessage {
 public:
  ArmsMessage& Array(std::string_view name, std::uint32_t rows, std::uint32_t cols,
                     std::span<const double> values) {
    writer_.AddDoubles(name, std::array{rows, cols}, values);
    return *this;
  }
  ArmsMessage& Still() { return Array("armVelocities", 4, 1, std::array<double, 4>{}).Grippers(); }
  ArmsMessage& Grippers() { return Array("armGripperVelocities", 2, 1, std::array<double, 2>{}); }
  StepReply Reply() { return std::get<StepReply>(Decode()); }
  std::string Error() { return std::get<WireError>(Decode()).message; }

 private:
  std::variant<StepReply, WireError> Decode() {
    return DecodeStepReply(Decoded(writer_.Finish()), RailAndArm());
  }

  MessageWriter writer_{MessageType::kMotor, 1};
};

TEST(DecodeStepReply, ReadsAnyArms) {
  const StepReply reply = ArmsMessage()
                              .Array("armVelocities", 4, 2, Counted(8))
                              .Array("armGripperVelocities", 2, 1, std::array{3.0, 0.0})
                              .Array("armJoints", 4, 1, std::array{0.5, 1.0, 2.0, 3.0})
                              .Array("armsAtJoints", 2, 1, std::array{1.0, 0.0})
                              .Reply();
  ASSERT_EQ(reply.motors.size(), 2u);
  const std::vector<ArmMotor>& arms = reply.motors[1].arms;
  ASSERT_EQ(arms.size(), 2u);
  EXPECT_EQ(arms[0].velocities, std::vector{4.0});
  EXPECT_EQ(arms[1].velocities, (std::vector{5.0, 6.0, 7.0}));
  EXPECT_EQ(arms[0].gripper_velocity, 3);
  EXPECT_EQ(arms[0].joints, std::vector{0.5});
  EXPECT_EQ(arms[1].joints, std::nullopt);
}

TEST(DecodeStepReply, NamesTheArmOfAMistake) {
  const std::array nan{0.0, 0.0, 0.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(ArmsMessage().Array("armVelocities", 4, 1, nan).Grippers().Error(),
            "motor.arms(2).velocities(3) is NaN, expected a finite number");
  EXPECT_EQ(ArmsMessage()
                .Array("armVelocities", 4, 2, std::array{0.0, 0.0, 0.0, 0.0, 0.0, 1e9, 0.0, 0.0})
                .Grippers()
                .Error(),
            "motor.arms(2).velocities(1,2) is 1e+09, expected at most 1e+06");
  EXPECT_EQ(ArmsMessage()
                .Array("armVelocities", 4, 1, Counted(4))
                .Array("armGripperVelocities", 2, 1, std::array{0.0, 1.0})
                .Error(),
            "motor.arms(2).gripperVelocity is set, but the arm \"arm\" has no gripper");
  EXPECT_EQ(ArmsMessage().Array("armVelocities", 5, 1, Counted(5)).Grippers().Error(),
            "motor.armVelocities is 5x1, expected 4x1");
  EXPECT_EQ(ArmsMessage().Grippers().Error(),
            "motor.arms is missing, expected an element for each arm");
  EXPECT_EQ(ArmsMessage().Still().Array("armsAtJoints", 2, 1, std::array{1.0, 1.0}).Error(),
            "motor.armJoints and armsAtJoints belong together, found one of them");
}

TEST(DecodeStepReply, NamesWhatReplacesAClassicVariable) {
  EXPECT_EQ(ArmsMessage().Array("jointVelocities", 2, 7, Counted(14)).Error(),
            "motor.jointVelocities is for two arms of seven joints, but this robot has rail (1 "
            "joint), arm (3 joints): use motor.arms(k).velocities");
  EXPECT_EQ(ArmsMessage().Still().Array("velocities", 1, 1, Counted(1)).Error(),
            "motor.velocities is unknown, expected arms, headVelocity or ticks");
  MessageWriter both(MessageType::kMotor, 1);
  both.AddDoubles("jointVelocities", kTwoBySeven, std::array<double, 14>{});
  both.AddDoubles("armVelocities", std::array{14u, 1u}, std::array<double, 14>{});
  EXPECT_EQ(std::get<WireError>(DecodeStepReply(Decoded(both.Finish()), ClassicArms())).message,
            "motor.jointVelocities and motor.arms are both set, expected one of them");
}

TEST(DecodeInitReply, TakesThePosturesOfSomeArms) {
  MessageWriter writer(MessageType::kInitDone, 1);
  writer.AddDoubles("armJoints", std::array{4u, 1u}, std::array{0.0, 1.0, 2.0, 3.0});
  writer.AddDoubles("armsAtJoints", std::array{2u, 1u}, std::array{0.0, 1.0});
  const auto reply =
      std::get<InitReply>(DecodeInitReply(Decoded(writer.Finish()), {.arms = RailAndArm()}));
  ASSERT_EQ(reply.init_joints.size(), 2u);
  EXPECT_EQ(reply.init_joints[0], std::nullopt);
  EXPECT_EQ(reply.init_joints[1], (std::vector{1.0, 2.0, 3.0}));
  MessageWriter classic(MessageType::kInitDone, 1);
  classic.AddDoubles("initJointAngles", kTwoBySeven, std::array<double, 14>{});
  EXPECT_EQ(std::get<WireError>(DecodeInitReply(Decoded(classic.Finish()), {.arms = RailAndArm()}))
                .message,
            "aux.initJointAngles is for two arms of seven joints, but this robot has rail (1 "
            "joint), arm (3 joints): use aux.arms(k).initJoints");
}

TEST(DecodeInitReply, TakesMarkersAndAngles) {
  MessageWriter writer(MessageType::kInitDone, 1);
  writer.AddDoubles("initJointAngles", kTwoBySeven, std::array<double, 14>{1, 2});
  writer.AddDoubles("drawMarkers", std::array{2u, 3u}, std::array<double, 6>{1, 2, 3, 4, 5, 6});
  const auto reply = std::get<InitReply>(DecodeInitReply(Decoded(writer.Finish()), Classic(Aux())));
  EXPECT_EQ(JointsOf(reply)(1, 0), 2);
  EXPECT_EQ(reply.draw_markers.row(1), Eigen::RowVector3d(2, 4, 6));
}

TEST(DecodeInitReply, TakesAnEmptyMatrixAsNoMarkers) {
  MessageWriter writer(MessageType::kInitDone, 1);
  writer.AddDoubles("drawMarkers", std::array{0u, 0u}, {});
  const auto reply = std::get<InitReply>(DecodeInitReply(Decoded(writer.Finish()), Classic(Aux())));
  EXPECT_EQ(reply.draw_markers.rows(), 0);
}

TEST(DecodeInitReply, RefusesMarkersThatAreNotPoints) {
  MessageWriter writer(MessageType::kInitDone, 1);
  writer.AddDoubles("drawMarkers", std::array{1u, 4u}, std::array<double, 4>{});
  const auto reply = DecodeInitReply(Decoded(writer.Finish()), Classic(Aux()));
  EXPECT_EQ(std::get<WireError>(reply).message, "aux.drawMarkers is 1x4, expected Nx3");
}

/// The auxiliary data of a program with an eye and two more cameras.
Aux AuxWithCameras() {
  Aux aux{.camera = CameraDescription{.width_px = 640, .height_px = 480}};
  aux.camera_names = {"eye", "head", "overhead"};
  return aux;
}

/// What an init script wished of pictures.
class WishMessage {
 public:
  WishMessage& Text(std::string_view name, std::string_view text) {
    writer_.AddText(name, text);
    return *this;
  }
  WishMessage& Seconds(double seconds) {
    writer_.AddScalar("imageSeconds", seconds);
    return *this;
  }
  WishMessage& Watch(bool watch) {
    writer_.AddLogical("watch", watch);
    return *this;
  }
  PictureWishes Wishes() { return Reply(AuxWithCameras()).pictures; }
  InitReply Reply(const Aux& aux) { return std::get<InitReply>(Decode(aux)); }
  std::string Error(const Aux& aux = AuxWithCameras()) {
    return std::get<WireError>(Decode(aux)).message;
  }

 private:
  std::variant<InitReply, WireError> Decode(const Aux& aux) {
    return DecodeInitReply(Decoded(writer_.Finish()), aux);
  }

  MessageWriter writer_{MessageType::kInitDone, 1};
};

TEST(DecodeInitReply, TakesWishesForPictures) {
  EXPECT_EQ(WishMessage().Wishes(), PictureWishes()) << "the eye's colors";
  EXPECT_EQ(WishMessage()
                .Text("channels", "depth,segmentation")
                .Text("cameras", "overhead\nhead\n")
                .Seconds(0.5)
                .Wishes(),
            (PictureWishes{.channels = {.rgb = false, .depth = true, .id = true},
                           .cameras = {"overhead", "head"},
                           .image_seconds = 0.5}));
  EXPECT_EQ(WishMessage().Text("channels", "").Wishes().channels, sim::Channels{.rgb = false});
}

TEST(DecodeInitReply, RefusesWishesThatCannotBe) {
  EXPECT_EQ(
      WishMessage().Text("cameras", "overhed").Error(),
      "aux.cameras names \"overhed\", expected eye, head or overhead; did you mean \"overhead\"?");
  EXPECT_EQ(WishMessage().Text("cameras", "head head").Error(),
            "aux.cameras names \"head\" twice, expected it once");
  EXPECT_EQ(WishMessage().Text("channels", "rgb,color").Error(),
            "aux.channels names \"color\", expected rgb, depth or segmentation");
  EXPECT_EQ(WishMessage().Seconds(-1).Error(),
            "aux.imageSeconds is -1, expected a number from 0 to 3600");
  MessageWriter numbers(MessageType::kInitDone, 1);
  numbers.AddScalar("channels", 3);
  EXPECT_EQ(std::get<WireError>(DecodeInitReply(Decoded(numbers.Finish()), {})).message,
            "aux.channels is 1x1 numbers, expected names");
  Aux large = AuxWithCameras();
  large.camera->width_px = large.camera->height_px = 2000;
  EXPECT_EQ(WishMessage().Text("channels", "rgb,depth").Text("cameras", "head").Error(large),
            "aux.channels and cameras require 83 MiB per image time, expected at most 52; request "
            "smaller or fewer pictures");
}

TEST(DecodeInitReply, AcceptsARequestToWatchOnlyWithADemonstration) {
  const Aux with_demonstration{.demonstration = "out/demo"};
  EXPECT_TRUE(WishMessage().Watch(true).Reply(with_demonstration).watch);
  EXPECT_FALSE(WishMessage().Reply(with_demonstration).watch);
  EXPECT_FALSE(WishMessage().Watch(false).Reply({}).watch);
  EXPECT_EQ(WishMessage().Watch(true).Error(), "aux.watch is true, but no demonstration is given");
  EXPECT_EQ(WishMessage().Text("watch", "yes").Error(with_demonstration),
            "aux.watch is text, expected a 1x1 matrix");
}

TEST(DecodeStepReply, TakesMarkersThatChanged) {
  MessageWriter writer(MessageType::kMotor, 1);
  writer.AddDoubles("jointVelocities", kTwoBySeven, std::array<double, 14>{});
  writer.AddDoubles("gripperVelocities", kTwoByOne, std::array{0.0, 0.0});
  writer.AddDoubles("drawMarkers", std::array{1u, 3u}, std::array{1.0, 2.0, 3.0});
  const auto reply = std::get<StepReply>(DecodeStepReply(Decoded(writer.Finish()), ClassicArms()));
  ASSERT_TRUE(reply.draw_markers);
  EXPECT_EQ(reply.draw_markers->row(0), Eigen::RowVector3d(1, 2, 3));
}

TEST(DecodeError, MakesTextFitForATerminal) {
  MessageWriter writer(MessageType::kError, 1);
  writer.AddText("message", "red \x1b[31m\nalert");
  writer.AddText("file", "a.m");
  writer.AddScalar("line", 1e300);
  const BrainError error = DecodeError(Decoded(writer.Finish()));
  EXPECT_EQ(ToString(error), "a.m: red ?[31m alert");
}

TEST(EncodeSensor, TurnsRowsOfPixelsIntoPlanesOfColumns) {
  Image image{
      .width_px = 2, .height_px = 1, .color = {10, 20, 30, 40, 50, 60}, .depth = {}, .ids = {}};
  const Message message = Decoded(EncodeSensor(1, {.pictures = {{.image = image}}}));
  const NamedArray* array = message.Find("rgbVision");
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(ShapeText(array->dims), "1x2x3");
  EXPECT_TRUE(array->is_fraction);
  const std::array<int, 6> expected{10, 40, 20, 50, 30, 60};
  for (int k = 0; k < 6; ++k) EXPECT_EQ(std::to_integer<int>(array->data[k]), expected[k]);
}

TEST(EncodeSensor, LeavesRowsAsTheyAreForWhoTakesThem) {
  Image image{.width_px = 2, .height_px = 1, .color = {10, 20, 30, 40, 50, 60}, .depth = {3, 4}};
  const Message message =
      Decoded(EncodeSensor(1, Classic(Sensor{.pictures = {{.image = image}}}), PixelOrder::kRows));
  const NamedArray* color = message.Find("rgbVision");
  ASSERT_NE(color, nullptr);
  EXPECT_TRUE(color->is_row_major);
  EXPECT_EQ(ShapeText(color->dims), "1x2x3");
  EXPECT_TRUE(std::ranges::equal(color->data, std::as_bytes(std::span(image.color))));
  EXPECT_TRUE(message.Find("depthVision")->is_row_major);
  EXPECT_EQ(message.Find("depthVision")->Numbers(), (std::vector{3.0, 4.0}));
  EXPECT_FALSE(message.Find("jointAngles")->is_row_major);
}

TEST(EncodeSensor, AlsoTransposesPicturesLargerThanATile) {
  Image image{.width_px = 130, .height_px = 70};
  for (int k = 0; k < 130 * 70; ++k) {
    for (const int color : {0, 1, 2}) image.color.push_back(std::uint8_t(k * 7 + color * 50));
    image.depth.push_back(static_cast<float>(k));
  }
  const Message message = Decoded(EncodeSensor(1, {.pictures = {{.image = image}}}));
  const auto depths = *message.Find("depthVision")->Numbers();
  const auto& planes = message.Find("rgbVision")->data;
  for (int row = 0; row < 70; ++row) {
    for (int column = 0; column < 130; ++column) {
      const int from = row * 130 + column, to = column * 70 + row;
      ASSERT_EQ(depths[to], from);
      for (int color = 0; color < 3; ++color) {
        ASSERT_EQ(planes[color * 130 * 70 + to], std::byte{image.color[3 * from + color]});
      }
    }
  }
}

TEST(DecodeStepReply, ReadsRowMajorVelocities) {
  MessageWriter writer(MessageType::kMotor, 1);
  const auto space =
      writer.AddSpace("jointVelocities", ElementType::kDouble, false, kTwoBySeven, true);
  const double second = 2;
  std::memcpy(&space[sizeof second], &second, sizeof second);
  writer.AddDoubles("gripperVelocities", kTwoByOne, std::array{0.0, 0.0});
  const auto reply = std::get<StepReply>(DecodeStepReply(Decoded(writer.Finish()), ClassicArms()));
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(0, 1), 2) << "the left arm's second joint";
}

TEST(EncodeSensor, SendsAnImageOnlyIfOneWasTaken) {
  EXPECT_EQ(Decoded(EncodeSensor(1, {})).Find("rgbVision"), nullptr);
}

TEST(EncodeSensor, RefusesAnImageThatDoesNotFitItsSize) {
  Image image{.width_px = 2, .height_px = 2, .color = {1, 2, 3}, .depth = {}, .ids = {}};
  EXPECT_THROW(EncodeSensor(1, {.pictures = {{.image = image}}}), std::invalid_argument);
}

TEST(EncodeSensor, NamesTheChannelsOfEachCamera) {
  Image image{.width_px = 2, .height_px = 2, .depth = {1, 2, 3, 4}, .ids = {0, 1, 2, 1}};
  Sensor sensor = Classic(Sensor{.segment_names = {"table", "a"}});
  sensor.pictures = {{.image = image}, {.camera = {.fx = 7}, .image = image, .name = "left_hand"}};
  const Message message = Decoded(EncodeSensor(1, sensor));
  EXPECT_EQ(message.Find("depthVision")->Numbers(), (std::vector{1.0, 3.0, 2.0, 4.0}));
  EXPECT_EQ(message.Find("segmentVision")->Numbers(), (std::vector{0.0, 2.0, 1.0, 1.0}));
  EXPECT_EQ(message.TextOf("segmentNames"), "table\na");
  EXPECT_EQ(ShapeText(message.Find("cameraPose")->dims), "4x4");
  EXPECT_EQ(message.Find("rgbVision"), nullptr);
  for (const char* field : {"depth", "segments", "pose", "intrinsics"}) {
    EXPECT_NE(message.Find("cameras_left_hand_" + std::string(field)), nullptr) << field;
  }
}

TEST(EncodeSensor, ReportsHeldObjects) {
  Sensor sensor = Classic(Sensor());
  sensor.arms[1].held_object = "cube";
  const Message message = Decoded(EncodeSensor(1, sensor));
  EXPECT_EQ(message.Find("isHolding")->Numbers(), (std::vector{0.0, 1.0}));
  EXPECT_EQ(message.TextOf("heldObject"), "\ncube");
}

TEST(EncodeAux, DescribesTheCamera) {
  const CameraDescription camera{
      .width_px = 640, .height_px = 480, .fx = 400, .fy = 401, .cx = 320, .cy = 240};
  const Message message =
      Decoded(EncodeAux(1, Classic(Aux{.camera = camera, .demonstration = "out/demo"}), "wave/"));
  EXPECT_EQ(message.Find("path")->Text(), "wave/");
  EXPECT_EQ(message.Find("demonstration")->Text(), "out/demo");
  EXPECT_EQ(message.Find("numJoints")->Numbers(), std::vector{7.0});
  EXPECT_EQ(message.Find("cameraSize")->Numbers(), (std::vector{480.0, 640.0}));
  EXPECT_EQ(message.Find("cameraIntrinsics")->Numbers(),
            (std::vector{400.0, 0.0, 0.0, 0.0, 401.0, 0.0, 320.0, 240.0, 1.0}));
  EXPECT_EQ(ShapeText(message.Find("cameraPose")->dims), "4x4");
}

TEST(EncodeAux, DescribesAnyArms) {
  const Message message = Decoded(EncodeAux(1, {.arms = RailAndArm()}, "wave/"));
  EXPECT_EQ(message.TextOf("armNames"), "rail\narm");
  EXPECT_EQ(message.TextOf("armJointNames"), "slide\na\nb\nc");
  EXPECT_EQ(message.Find("armJointCounts")->Numbers(), (std::vector{1.0, 3.0}));
  EXPECT_EQ(message.Find("armMinJoints")->Numbers(), (std::vector{-1.0, -1.0, -2.0, -3.0}));
  const auto grippers = *message.Find("armGrippers")->Numbers();
  EXPECT_EQ(grippers[1], 2);
  EXPECT_TRUE(std::isnan(grippers[2]));
  EXPECT_EQ((*message.Find("armToolPoses")->Numbers())[16 + 14], 0.7);
  EXPECT_EQ(message.Find("numLimbs"), nullptr);
  EXPECT_EQ(Decoded(EncodeAux(1, Classic(Aux{.sends_arms = false}), "")).Find("armNames"), nullptr);
}

TEST(EncodeSensor, ReportsAnyArms) {
  Sensor sensor;
  sensor.arms = RailAndArmSensed();
  const Message message = Decoded(EncodeSensor(1, sensor));
  EXPECT_EQ(message.Find("armJoints")->Numbers(), (std::vector{1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(ShapeText(message.Find("armEndEffectors")->dims), "4x4x2");
  EXPECT_EQ(message.TextOf("armHeldObjects"), "cube\n");
  EXPECT_EQ((*message.Find("armGrippers")->Numbers())[0], 0.5);
  for (const char* classic : {"jointAngles", "gripperOpening", "endEffPos", "heldObject"}) {
    EXPECT_EQ(message.Find(classic), nullptr) << classic;
  }
}

TEST(EncodeAux, HasRoomForTheLargestRobot) {
  ArmDescription arm{.name = std::string(40, 'n'),
                     .joint_names = std::vector(16, std::string(60, 'j'))};
  arm.min_joints = arm.max_joints = arm.max_velocities = std::vector<double>(16);
  const std::vector<ArmDescription> arms(16, arm);
  const Message init = Decoded(EncodeAux(1, {.arms = arms}, "wave/"));
  EXPECT_EQ(ShapeText(init.Find("armMinJoints")->dims), "1x256");
  MessageWriter writer(MessageType::kMotor, 1);
  writer.AddDoubles("armVelocities", std::array{256u, 600u}, Counted(256 * 600));
  writer.AddDoubles("armGripperVelocities", std::array{16u, 1u}, std::array<double, 16>{});
  const auto reply = std::get<StepReply>(DecodeStepReply(Decoded(writer.Finish()), arms));
  ASSERT_EQ(reply.motors.size(), 600u);
  EXPECT_EQ(reply.motors[599].arms[15].velocities[15], 256 * 600 - 1);
}

TEST(EncodeAux, ReportsAttention) {
  const Message message =
      Decoded(EncodeAux(1, {.attention = {{"a", {"color", "size"}}, {"b", {"shape"}}}}, "wave/"));
  EXPECT_EQ(message.Find("attention")->Text(), "a,color,size\nb,shape");
  EXPECT_THROW(EncodeAux(1, {.attention = {{"a,b", {"color"}}}}, "wave/"), std::invalid_argument);
}

TEST(EncodeAux, ReportsThePlan) {
  const TaskPlan plan{.subtasks = {{"puts a", {"a", "tool"}, 1, 2, true}, {"presses", {}, 3, 3}},
                      .order = {{0, 1}},
                      .sufficient = {0},
                      .goals = {"a"}};
  const Message message = Decoded(EncodeAux(1, {.plan = plan}, "wave/"));
  EXPECT_EQ(message.TextOf("planWords"), "puts a\npresses");
  EXPECT_EQ(message.TextOf("planObjects"), "a,tool\n");
  EXPECT_EQ(message.Find("planSegments")->Numbers(), (std::vector{1.0, 3.0, 2.0, 3.0}));
  EXPECT_EQ(message.Find("planNecessary")->Numbers(), (std::vector{1.0, 0.0}));
  EXPECT_EQ(message.Find("planOrder")->Numbers(), (std::vector{1.0, 2.0}));
  EXPECT_EQ(message.Find("planSufficient")->Numbers(), std::vector{1.0});
  EXPECT_EQ(message.TextOf("planGoals"), "a");
  EXPECT_EQ(Decoded(EncodeAux(1, {}, "wave/")).Find("planWords"), nullptr);
  TaskPlan ambiguous = plan;
  ambiguous.subtasks[0].objects = {"a,b"};
  EXPECT_THROW(EncodeAux(1, {.plan = ambiguous}, "wave/"), std::invalid_argument);
}

}  // namespace
}  // namespace smile::brain

#include "recording/demo_info.h"

#include <filesystem>
#include <fstream>

#include "base/diagnostic.h"
#include "base/json.h"
#include "image/png.h"
#include "recorder/test/painted_eye.h"
#include "recorder/test/recording_fixture.h"

namespace smile::recording {
namespace {

class DemoInfoTest : public recorder::RecordingFixture {
 protected:
  static DemoInfo Everything() {
    DemoInfo info{
        .program = "smile 0",
        .scene = "pair",
        .title = "A title",
        .notes = "and notes",
        .origin = Origin::kEdited,
        .start = {.line = 2, .tick = 30},
        .has_symbols = false,
        .robot = RobotInfo{.name = "arm",
                           .gap = -0.1,
                           .height = 0.2,
                           .urdf = "robot/arm.urdf",
                           .gripper = "electric"},
        .eye = CameraView{.intrinsics = CameraIntrinsics::FromVerticalFieldOfView(8, 6, 1),
                          .X_WC = RigidTransform(Vector3(0, -1, 1))},
        .eye_camera = sim::kHeadCamera,
        .demonstrator = DemonstratorAppearance::kForearm,
        .corrects = Correction{.recording = "take", .seconds = 1.5}};
    info.robot->body.grasps_by_friction = true;
    return info;
  }
  DemoInfo Read(const std::string& text) const {
    WriteFile(root_ / "demo.json", text);
    return ReadDemoInfo(root_ / "demo.json");
  }
  /// Finding, without the path, if this text replaces the value at a place.
  std::string ComplaintAbout(const std::string& place, const std::string& value) const {
    Json json = Json::parse(ToJsonText(Everything()));
    json[Json::json_pointer(place)] = "HERE";
    std::string text = ToText(json, 2);
    text.replace(text.find("\"HERE\""), 6, value);
    return ComplaintOf(text);
  }
  std::string ComplaintOf(const std::string& text) const {
    try {
      Read(text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr((root_ / "demo.json: ").string().size());
    }
    return "";
  }
};

TEST_F(DemoInfoTest, RoundTrips) {
  EXPECT_EQ(Read(ToJsonText(Everything())), Everything());
  DemoInfo plain;
  plain.program = "smile 0";
  EXPECT_EQ(Read(ToJsonText(plain)), plain);
}

TEST_F(DemoInfoTest, RecordingsWithoutAPhysicsVersionAreOfTheFirst) {
  Json json = Json::parse(ToJsonText(Everything()));
  EXPECT_EQ(json.at("physics"), scene::kPhysicsVersion);
  json.erase("physics");
  EXPECT_EQ(Read(ToText(json, 2)).physics_version, 1);
}

TEST_F(DemoInfoTest, ComplaintsNameThePlaceWhatWasFoundAndWhatWasExpected) {
  const std::pair<const char*, std::pair<const char*, const char*>> complaints[] = {
      {"/format", {"4", "<format>: found 4, expected 1 to 3 (made by smile 0)"}},
      {"/format", {"\"3\"", "<format>: found string, expected a whole number from 0 to 1000000"}},
      {"/scene", {"[]", "<scene>: found array, expected a string"}},
      {"/meters_per_unit", {"0", "<meters_per_unit>: found 0, expected 1e-09 to 1e+09"}},
      {"/ticks_per_second", {"30", "<ticks_per_second>: found 30, expected 60 to 60"}},
      {"/physics", {"7", "<physics>: found 7, expected a whole number from 1 to 6"}},
      {"/origin", {"\"made\"", "<origin>: found \"made\", expected recorded, edited or imported"}},
      {"/start/line",
       {"-1", "<start/line>: found -1, expected a whole number from 0 to 1000000000"}},
      {"/start/tick",
       {"1.5", "<start/tick>: found 1.5, expected a whole number from 0 to 160704000"}},
      {"/has_symbols", {"1", "<has_symbols>: found number, expected true or false"}},
      {"/robot", {"7", "<robot>: found number, expected an object"}},
      {"/robot/gap_m", {"101", "<robot/gap_m>: found 101, expected -100 to 100"}},
      {"/robot/urdf",
       {"\"robot/..\"", "<robot/urdf>: found \"robot/..\", expected a file in robot/"}},
      {"/robot/gripper", {"null", "<robot/gripper>: found null, expected a string"}},
      {"/robot/kinematic",
       {"true", "<robot>: found both kinematic and friction_grasp, expected one at most"}},
      {"/eye/width_px", {"0", "<eye/width_px>: found 0, expected a whole number from 1 to 8192"}},
      {"/eye/fy", {"-5", "<eye/fy>: found -5, expected 0.001 to 1e+09"}},
      {"/eye/cx", {"9", "<eye/cx>: found 9, expected 0 to 8"}},
      {"/eye/position_m", {"[1,2]", "<eye/position_m>: length is 2, expected 3"}},
      {"/eye/rotation_wxyz", {"[0,0,0,0]", "<eye/rotation_wxyz>: its length is 0, expected 1"}},
      {"/eye/camera", {"\"left_hand\"", "<eye/camera>: found \"left_hand\", expected eye or head"}},
      {"/demonstrator",
       {"\"ghosts\"",
        "<demonstrator>: demonstrator is \"ghosts\", expected invisible, ghost or forearm"}},
      {"/eye", {"null", "<demonstrator>: found in a recording without pictures"}},
      {"/corrects/recording",
       {"\"../take\"", "<corrects/recording>: found \"../take\", expected a name"}},
      {"/corrects/seconds", {"-1", "<corrects/seconds>: found -1, expected 0 to 2678400"}},
      {"/robot", {"null", "<eye/camera>: found head and no robot, expected eye"}},
      {"/tilte",
       {"\"\"",
        "unknown member \"tilte\", expected format, program, scene, title, notes, "
        "meters_per_unit, ticks_per_second, physics, origin, start, frames_per_second, "
        "has_symbols, robot, "
        "eye, demonstrator or corrects; did you mean \"title\"?"}},
      {"/eye/fov",
       {"1",
        "<eye>: unknown member \"fov\", expected width_px, height_px, fx, fy, cx, cy, position_m, "
        "rotation_wxyz or camera"}},
  };
  for (const auto& [place, text] : complaints) {
    EXPECT_EQ(ComplaintAbout(place, text.first), text.second) << place;
  }
  EXPECT_EQ(ComplaintOf("{}"), "has no member \"format\"");
  EXPECT_EQ(ComplaintOf("{"), "this is not JSON");
  EXPECT_EQ(ComplaintOf(R"({"format":3,"format":1})"), "the key \"format\" appears twice");
}

TEST_F(DemoInfoTest, TheEyeIsThatOfThePictures) {
  recorder::PaintedEye eye;
  const auto demo = Record(R"({"do":"wait","seconds":0.1})", /*with_robot=*/false, &eye);
  EXPECT_NO_THROW(OpenRecording(demo));
  WritePng(demo / "0" / "0.png",
           {.width_px = 6, .height_px = 8, .color = std::vector<std::uint8_t>(144)});
  try {
    OpenRecording(demo);
    FAIL() << "an eye of another size was taken";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), (demo / "demo.json").string() +
                                ": <eye>: is of 8x6 pixels, expected 6x8 as " +
                                (demo / "0" / "0.png").string());
  }
  std::ofstream(demo / "0" / "0.png") << "no picture";
  EXPECT_THROW(OpenRecording(demo), InputError);
  // Pictures may be thrown away.
  std::filesystem::remove(demo / "0" / "0.png");
  EXPECT_NO_THROW(OpenRecording(demo));
}

}  // namespace
}  // namespace smile::recording

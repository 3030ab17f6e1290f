#include "classic/classic_recorder.h"

#include <algorithm>
#include <cstdio>

#include "classic/classic_text.h"
#include "image/png.h"
#include "recorder/recording_controller.h"
#include "recorder/test/painted_eye.h"
#include "recorder/test/recording_fixture.h"
#include "recording/attention.h"

namespace smile::classic {
namespace {

class ClassicRecorderTest : public recorder::RecordingFixture {};

TEST_F(ClassicRecorderTest, SegmentZeroDescribesTheSceneInItsOrder) {
  const auto demo = Record();
  const auto lines = Lines(demo / "0.txt");
  ASSERT_GE(lines.size(), 4u);
  EXPECT_EQ(lines[0], "0,create,a,shape,block,color,red");
  EXPECT_EQ(lines[1], "0,create,b,shape,block,label,tall\\, blue");
  EXPECT_EQ(lines[2], "0,move,a,0.0,-2.0,0.5,0.0,-0.0,0.0");
  EXPECT_EQ(lines[3], "0,move,b,3.0,-2.0,0.5,0.0,-0.0,30.0");
}

TEST_F(ClassicRecorderTest, EveryActionOpensASegmentWithItselfAsFirstLine) {
  const auto demo = Record();
  EXPECT_EQ(Lines(demo / "1.txt")[0].substr(2), "grasp,LeftHand,a");
  EXPECT_NE(Lines(demo / "2.txt")[0].find(",release,LeftHand"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(demo / "3.txt"));
  // The release segment ends with the exact pose of rest.
  std::string last;
  for (const std::string& line : Lines(demo / "2.txt")) {
    if (line.find(",move,a,") != std::string::npos) last = line;
  }
  double x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(last.c_str(), "%*d,move,a,%lf,%lf,%lf", &x, &y, &z), 3) << last;
  EXPECT_LT((Vector3(x, y, z) - Vector3(3, -2, 1.5)).norm(), 0.01);
}

TEST_F(ClassicRecorderTest, OnlyFramesInWhichSomethingMovedHaveAPicture) {
  recorder::PaintedEye eye;
  const auto demo = Record(kStackAOnB, false, &eye);
  const auto index = Lines(demo / "frames.csv");
  EXPECT_EQ(index[0], "frame,tick,image");
  int pictures = 0;
  for (std::size_t i = 1; i < index.size(); ++i) {
    const std::string frame = std::to_string(i - 1);
    EXPECT_EQ(index[i].substr(0, frame.size() + 1), frame + ",");
    EXPECT_NE(index[i].find("," + std::to_string((i - 1) * 15) + ","), std::string::npos);
    const std::string image = index[i].substr(index[i].rfind(',') + 1);
    if (image.empty()) continue;
    ++pictures;
    EXPECT_EQ(ReadPng(demo / image).color[0], pictures) << image;
  }
  EXPECT_EQ(pictures, eye.num_pictures());
  EXPECT_GT(pictures, 4);
  EXPECT_LT(pictures, static_cast<int>(index.size()) - 4);
}

TEST_F(ClassicRecorderTest, AMotionBetweenTwoFramesHasALine) {
  // Frames every 4 s: it sleeps at 4 s, goes a unit to the left, and sleeps again at 8 s.
  const auto demo = Record(R"({"do":"wait","seconds":4.2}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[-1,-2,0.5]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":5})",
                           false, nullptr, kScene, {.frames_per_second = 0.25});
  const std::string text = ReadFile(demo / "2.txt", 1 << 20);
  EXPECT_NE(text.find(",move,a,"), std::string::npos) << text;
}

TEST_F(ClassicRecorderTest, NamesWhatPressedAControlAndBeginsNoSegmentWithIt) {
  constexpr const char* kSwitch =
      R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <composite id="Panel" location="(0,-2,0.5)" mass="2"><block location="(0,0,0)" xspan="3" yspan="2" zspan="1"/>
    <toggleSwitch id="Power" location="(0,0,0.5)" xspan="2" yspan="1.2" zspan="0.35" angle="16"/></composite>
  <block id="Weight" location="(0.6,-2,2.4)" xspan="0.6" yspan="0.6" zspan="0.6"/>
</tabletop>)xml";
  const auto demo = Record(R"({"do":"wait","seconds":1})", false, nullptr, kSwitch);
  const auto lines = Lines(demo / "0.txt");
  const auto press = std::ranges::find_if(
      lines, [](const std::string& line) { return line.ends_with(",press,Power,Weight"); });
  ASSERT_LT(press, lines.end() - 1);
  EXPECT_TRUE((press + 1)->ends_with(",changeControlState,Power,1")) << *(press + 1);
  EXPECT_FALSE(std::filesystem::exists(demo / "1.txt"));
}

constexpr const char* kThrowAway = R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"attend","properties":["color","size"]}
{"do":"wait","seconds":0.3}
{"hand":"left","do":"move_to","position":[-12,-2,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":2})";

TEST_F(ClassicRecorderTest, AttentionAndFallsAreWritten) {
  const auto demo = Record(kThrowAway);
  EXPECT_EQ(Lines(demo / "1.txt")[1], "1,attend,LeftHand,a,color,size");
  // One last move, then it is gone.
  const auto lines = Lines(demo / "2.txt");
  ASSERT_GE(lines.size(), 3u);
  const auto is_delete = [](const std::string& line) {
    return line.find(",delete,a") != std::string::npos;
  };
  EXPECT_TRUE(is_delete(lines.back())) << lines.back();
  EXPECT_NE(lines[lines.size() - 2].find(",move,a,"), std::string::npos);
  EXPECT_EQ(std::ranges::count_if(lines, is_delete), 1);
  EXPECT_EQ(recording::AttentionOf(recording::OpenRecording(demo)),
            (std::map<std::string, std::vector<std::string>>{{"a", {"color", "size"}}}));
}

TEST_F(ClassicRecorderTest, BeginsWithWhatMattersAndWithoutWhatFell) {
  auto simulation = MakeSimulation(false);
  recorder::RecordingController controller(simulation.get(), {.root = root_});
  sim::ScriptPlayer player(sim::ParseScript(kThrowAway, "script", 0.1));
  for (player.Advance(simulation.get()); !player.is_finished(); player.Advance(simulation.get())) {
    simulation->Tick();
  }
  ASSERT_FALSE(simulation->Apply(sim::Grasp{.hand = sim::HandName::kRight, .object = "b"}));
  ASSERT_FALSE(
      simulation->Apply(sim::Attend{.hand = sim::HandName::kRight, .properties = {"label"}}));
  ASSERT_FALSE(simulation->Apply(sim::StartRecording{.name = "late"}));
  for (int i = 0; i < 30; ++i) simulation->Tick();
  const auto lines = Lines(root_ / "late" / "0.txt");
  ASSERT_GE(lines.size(), 4u);
  EXPECT_EQ(lines[0], "0,create,b,shape,block,label,tall\\, blue");
  EXPECT_EQ(lines[1], "0,attend,AnyHand,a,color,size");
  EXPECT_EQ(lines[2], "0,attend,AnyHand,b,label");
  EXPECT_EQ(lines[3], "0,grasp,RightHand,b");
  EXPECT_EQ(recording::AttentionOf(recording::OpenRecording(root_ / "late")).size(), 2u);
}

TEST(ClassicNumber, IsTheOriginalsShortestSinglePrecision) {
  EXPECT_EQ(ClassicNumber(2), "2.0");
  EXPECT_EQ(ClassicNumber(-0.0), "-0.0");
  EXPECT_EQ(ClassicNumber(0.50038415), "0.50038415");
  EXPECT_EQ(ClassicNumber(3.4144908e-4), "3.4144908E-4");
  EXPECT_EQ(ClassicNumber(1e7), "1.0E7");
  EXPECT_EQ(ClassicNumber(1234567), "1234567.0");
  EXPECT_EQ(ClassicNumber(0.001), "0.001");
}

}  // namespace
}  // namespace smile::classic

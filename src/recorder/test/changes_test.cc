// Recording of changes without motion, of the end of a recording, and of a robot that holds a
// fastened object.

#include "painted_eye.h"
#include "recording/trace_reader.h"
#include "recording_fixture.h"
#include "replay/replay.h"

namespace smile::recorder {
namespace {

// All objects are fixed or at rest; the screw forces the lamp on, contrary to the switch.
constexpr const char* kPanelAndScrew =
    R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <composite id="panel" location="(0,3,0.2)" mass="0">
    <block xspan="4" yspan="2" zspan="0.4" location="(0,0,0)"/>
    <toggleSwitch id="power" location="(-1,0,0.2)"><downstream id="light"/></toggleSwitch>
    <indicatorLights id="light" location="(0,0,0.2)">
      <state descriptionName="off"/><state descriptionName="on"><light id="0"/></state>
    </indicatorLights>
    <indicatorLights id="alarm" location="(1,0,0.2)">
      <state descriptionName="calm"/><state descriptionName="red"><light id="0"/></state>
    </indicatorLights>
  </composite>
  <composite id="nut" location="(-4,0,0.25)" mass="0">
    <ring radiusOuter="0.6" radiusInner="0.3" zspan="0.5" location="(0,0,0)"/>
    <hostBondPoint id="hole" type="m8" downstreamOverride="alarm">
      <tightness location="(0,0,0.8)" downstreamState="1"/>
    </hostBondPoint>
  </composite>
  <composite id="screw" location="(-4,0,3)">
    <block xspan="0.2" yspan="0.2" zspan="1" location="(0,0,0)"/>
    <guestBondPoint id="tip" type="m8" location="(0,0,-0.5)" initBondHostId="hole" initBondTightness="1"/>
  </composite>
  <block id="still" location="(4,0,0.5)" mass="0"/>
</tabletop>)xml";

constexpr const char* kTriggerAndDestroy = R"({"do":"wait","seconds":3.1}
{"hand":"left","do":"trigger","control":"power"}
{"do":"wait","seconds":1}
{"hand":"left","do":"grasp","object":"screw"}
{"do":"wait","seconds":1}
{"hand":"left","do":"destroy"}
{"do":"wait","seconds":1})";

class ChangesTest : public RecordingFixture {
 protected:
  std::filesystem::path RecordChanges(sim::Eye* eye = nullptr) {
    return Record(kTriggerAndDestroy, false, eye, kPanelAndScrew);
  }
  /// Frame numbers of all pictures.
  static std::vector<std::string> PicturesOf(const std::filesystem::path& demo) {
    std::vector<std::string> pictures;
    for (const std::string& line : Lines(demo / "frames.csv")) {
      const std::string image = line.substr(line.rfind(',') + 1);
      if (!image.empty() && image != "image") pictures.push_back(image);
    }
    return pictures;
  }
};

TEST_F(ChangesTest, AFrameHasAPictureWhenOnlyAControlChangedOrSomethingIsGone) {
  PaintedEye eye;
  const auto pictures = PicturesOf(RecordChanges(&eye));
  // The start; the screw falls asleep meanwhile. Frame 13 follows upon 3.1 s, 21 upon 5.1 s.
  ASSERT_GE(pictures.size(), 3u);
  EXPECT_EQ(pictures.front(), "0/0.png");
  EXPECT_EQ(pictures[pictures.size() - 2], "1/13.png");
  EXPECT_EQ(pictures.back(), "3/21.png");
}

TEST_F(ChangesTest, ABondThatEndsByADestroyHasNoLineOfItsOwn) {
  const auto demo = RecordChanges();
  EXPECT_EQ(Lines(demo / "1.txt"),
            (std::vector<std::string>{"13,trigger,LeftHand,power", "13,changeControlState,power,1",
                                      "13,changeControlState,light,on"}));
  EXPECT_EQ(Lines(demo / "3.txt"),
            (std::vector<std::string>{"21,destroy,LeftHand", "21,delete,screw",
                                      "21,changeControlState,alarm,calm"}));
  EXPECT_FALSE(std::filesystem::exists(demo / "4.txt"));
}

TEST_F(ChangesTest, TheTraceOfADestroyedObjectEndsWithTheCommand) {
  const recording::Recording recording = recording::OpenRecording(RecordChanges());
  const std::uint64_t destroyed = recording.commands.back().tick;
  recording::TraceReader trace(recording);
  ASSERT_EQ(trace.object_names()[2], "screw");
  std::uint64_t ticks = 0;
  while (const auto moment = trace.Next()) {
    ++ticks;
    const bool is_before = moment->tick <= destroyed;
    ASSERT_EQ(moment->objects[2].is_present, is_before) << moment->tick;
    ASSERT_EQ(moment->bonds[0].guest.has_value(), is_before) << moment->tick;
    ASSERT_EQ(moment->controls[2].override_state, is_before ? 1 : -1) << moment->tick;
    ASSERT_TRUE(moment->objects[3].is_present);
    ASSERT_EQ(moment->objects[3].position, Vector3(0.4, 0, 0.05)) << "that after it stays";
  }
  EXPECT_GT(ticks, destroyed + 50);
}

// Between the left fingers, as the robot stands at the start, a nut on a pillar holds a peg.
constexpr const char* kNutInGripper =
    R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="pillar" mass="0" xspan="0.6" yspan="0.6" zspan="2.18" location="(-2.077,-4.858,1.09)"/>
  <composite id="nut" location="(-2.077,-4.858,2.69)">
    <block location="(0,0,0)"/>
    <hostBondPoint id="hole" type="peg" location="(-0.5,0,0)"><tightness location="(-0.01,0,0)"/></hostBondPoint>
  </composite>
  <composite id="peg" location="(0,0,1)" mass="0.1">
    <block xspan="0.3" yspan="0.3" zspan="0.3" location="(0,0,0)"/>
    <guestBondPoint id="end" type="peg" location="(0.15,0,0)" initBondHostId="hole" initBondTightness="1"/>
  </composite>
  <block id="panel" mass="0" location="(6,4,0.5)"/>
</tabletop>)xml";

TEST_F(ChangesTest, ARobotThatCarriesWhatIsFastenedReplaysIdentically) {
  const recording::Recording recording = recording::OpenRecording(Record(
      R"({"do":"joint_velocities","grippers":[-1,0]}
{"do":"wait","seconds":1.5}
{"do":"joint_velocities","left":[0.3,-0.4,0,0.6,0,0,0.3]}
{"do":"wait","seconds":0.7}
{"do":"joint_velocities","left":[0,0,0,0,0,0,0]}
{"hand":"right","do":"loosen","object":"peg"}
{"do":"wait","seconds":0.5}
{"do":"joint_velocities","grippers":[1,0]}
{"do":"wait","seconds":0.3})",
      /*with_robot=*/true, nullptr, kNutInGripper));
  const replay::ReplayReport report = replay::Replay(recording);
  EXPECT_EQ(report.first_difference, std::nullopt);
  EXPECT_EQ(report.hash, final_hash_);

  // There was motion to replay: both moved with the arm, and the peg fell.
  recording::TraceReader trace(recording);
  const std::uint64_t gripped = recording.commands[1].tick, loosened = recording.commands[3].tick;
  recording::TraceTick before, after, last;
  while (const auto moment = trace.Next()) {
    if (moment->tick == gripped) before = *moment;
    if (moment->tick == loosened) after = *moment;
    last = *moment;
  }
  const auto in_nut = [](const recording::TraceTick& moment) -> Vector3 {
    return moment.objects[1].pose_in_world().inverse() * moment.objects[2].position;
  };
  EXPECT_GT((after.objects[1].position - before.objects[1].position).norm(), 0.05);
  EXPECT_LT((in_nut(after) - in_nut(before)).norm(), 0.002);
  EXPECT_EQ(after.bonds[0].tightness, 1);
  EXPECT_EQ(last.bonds[0].tightness, 0);
  EXPECT_LT(last.objects[2].position.z(), after.objects[2].position.z() - 0.05);
}

}  // namespace
}  // namespace smile::recorder

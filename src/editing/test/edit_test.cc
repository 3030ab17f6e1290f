#include "editing/edit.h"

#include <limits>

#include "base/diagnostic.h"
#include "editing/overlay.h"
#include "editing/re_simulation.h"
#include "recorder/test/painted_eye.h"
#include "recorder/test/recording_fixture.h"
#include "replay/replay.h"

namespace smile::editing {
namespace {

using sim::HandName;

class EditTest : public recorder::RecordingFixture {
 protected:
  /// Segments of 60, 120 and 30 ticks: nothing, a grasp with moves at 20 and 100 and a pause in
  /// between, a release.
  static recording::Demonstration Short() {
    recording::Demonstration made{.num_recorded = 3, .meters_per_unit = 0.1};
    made.segments = {
        {.number = 0, .duration = 60},
        {.number = 1,
         .commands = {{1, 0, sim::Grasp{.object = "a"}},
                      {2, 20, sim::MoveTo{.speed = 0.2}},
                      {3, 100, sim::MoveTo()}},
         .pauses = {{40, 100}},
         .duration = 120},
        {.number = 2, .commands = {{4, 0, sim::Release()}}, .pauses = {{6, 30}}, .duration = 30}};
    return made;
  }

  /// Segments of 60, 40, 20 and 30 ticks: the left hand takes a, moves it, moves it again after the
  /// right hand has taken b, and releases it.
  static recording::Demonstration OfTwoHands() {
    constexpr HandName kLeft = HandName::kLeft, kRight = HandName::kRight;
    recording::Demonstration made{.num_recorded = 4, .meters_per_unit = 0.1};
    made.segments = {
        {.number = 0, .duration = 60},
        {.number = 1,
         .commands = {{1, 0, sim::Grasp{kLeft, "a"}}, {2, 20, sim::MoveTo{.hand = kLeft}}},
         .duration = 40},
        {.number = 2,
         .commands = {{3, 0, sim::Grasp{kRight, "b"}}, {4, 10, sim::MoveTo{.hand = kLeft}}},
         .duration = 20},
        {.number = 3, .commands = {{5, 0, sim::Release{kLeft}}}, .duration = 30}};
    return made;
  }

  static std::vector<int> Numbers(const recording::Demonstration& demonstration) {
    std::vector<int> numbers;
    for (const recording::EditableSegment& segment : demonstration.segments)
      numbers.push_back(segment.number);
    return numbers;
  }
  static std::vector<std::uint64_t> Offsets(const recording::EditableSegment& segment) {
    std::vector<std::uint64_t> offsets;
    for (const recording::SegmentCommand& command : segment.commands)
      offsets.push_back(command.offset);
    return offsets;
  }
  static std::string Complaint(const Edit& edit, recording::Demonstration made = Short()) {
    try {
      (void)Edited(std::move(made), edit);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  EditReport ReSimulated(const recording::Recording& recording, const std::vector<Edit>& edits,
                         sim::Eye* eye = nullptr) {
    recording::Demonstration edited = recording::DemonstrationOf(recording);
    for (const Edit& edit : edits) edited = Edited(std::move(edited), edit);
    return ReSimulate(recording, edited, EditOutput{root_ / "edited", eye});
  }
};

TEST_F(EditTest, DropAndMoveCallSegmentsByTheirRecordedNumbers) {
  EXPECT_EQ(Numbers(Edited(Short(), Drop{1, 1})), (std::vector{0, 2}));
  EXPECT_EQ(Numbers(Edited(Edited(Short(), Drop{0, 0}), Drop{2, 2})), (std::vector{1}));
  EXPECT_EQ(Numbers(Edited(Short(), Move{2, 1})), (std::vector{0, 2, 1}));
  EXPECT_EQ(Numbers(Edited(Edited(Short(), Drop{0, 0}), Move{1, 2})), (std::vector{2, 1}));
}

TEST_F(EditTest, TheScheduleFollowsTheSegments) {
  const auto schedule = Edited(Short(), Move{2, 1}).Schedule();
  ASSERT_EQ(schedule.size(), 4u);
  EXPECT_EQ(schedule[0].line, 4u);
  EXPECT_EQ(schedule[0].tick, 60u);
  EXPECT_EQ(schedule[3].line, 3u);
  EXPECT_EQ(schedule[3].tick, 190u);
}

TEST_F(EditTest, TrimKeepsTheActionAndAPart) {
  const recording::EditableSegment trimmed = Edited(Short(), Trim{1, 0.5, 10}).segments[1];
  EXPECT_EQ(Offsets(trimmed), (std::vector<std::uint64_t>{0, 70}));
  EXPECT_EQ(trimmed.duration, 90u);
  EXPECT_EQ(trimmed.pauses, (std::vector<recording::TickSpan>{{10, 70}}));
  EXPECT_EQ(Offsets(Edited(Short(), Trim{1, 0, 0.5}).segments[1]),
            (std::vector<std::uint64_t>{0, 20}));
}

TEST_F(EditTest, MaxPauseShortensPausesOnly) {
  const recording::Demonstration edited = Edited(Short(), MaxPause{0.25});
  EXPECT_EQ(Offsets(edited.segments[1]), (std::vector<std::uint64_t>{0, 20, 55}));
  EXPECT_EQ(edited.segments[1].duration, 75u);
  EXPECT_EQ(edited.segments[2].duration, 21u);
  EXPECT_EQ(Edited(edited, MaxPause{0.25}).segments, edited.segments);
  EXPECT_EQ(Edited(Short(), MaxPause{1}).segments, Short().segments);
}

TEST_F(EditTest, RetimeSpreadsTheCommands) {
  const recording::Demonstration edited = Edited(Short(), Retime{1, 1});
  EXPECT_EQ(Offsets(edited.segments[1]), (std::vector<std::uint64_t>{0, 10, 50}));
  EXPECT_EQ(edited.duration(), 150u);
  // What takes no time has nothing to spread.
  EXPECT_EQ(Edited(Edited(edited, Retime{1, 0}), Retime{1, 2}).segments[1].duration, 120u);
}

TEST_F(EditTest, SpeedIsAlsoThatOfTheHand) {
  const recording::Demonstration edited = Edited(Short(), Speed{2});
  EXPECT_EQ(edited.duration(), 105u);
  EXPECT_EQ(Offsets(edited.segments[1]), (std::vector<std::uint64_t>{0, 10, 50}));
  EXPECT_EQ(std::get<sim::MoveTo>(edited.segments[1].commands[1].command).speed, 0.4);
  EXPECT_EQ(std::get<sim::MoveTo>(edited.segments[1].commands[2].command).speed, std::nullopt);
  // Twice as fast, the pause is as long as it may be.
  EXPECT_EQ(Edited(edited, MaxPause{0.5}).segments[1], edited.segments[1]);
}

TEST_F(EditTest, ReportsWhatWasFoundAndExpected) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Complaint(Drop{3, 3}), "segment is 3, expected 0 to 2");
  EXPECT_EQ(Complaint(Drop{-1, 1}), "segment is -1, expected 0 to 2");
  EXPECT_EQ(Complaint(Drop{1, std::numeric_limits<int>::max()}),
            "last segment is 2147483647, expected 1 to 2");
  EXPECT_EQ(Complaint(Move{0, 1}), "segment is 0, expected 1 to 2");
  EXPECT_EQ(Complaint(Move{1, 3}), "place is 3, expected 1 to 2");
  EXPECT_EQ(Complaint(Trim{1, 3, 4}),
            "the range to keep is from 3 to 4 s, expected a part of the segment's 2 s");
  EXPECT_EQ(Complaint(MaxPause{kNan}), "time is NaN s, expected 0 to 86400");
  EXPECT_EQ(Complaint(Retime{1, 1e300}), "time is 1e+300 s, expected 0 to 86400");
  EXPECT_EQ(Complaint(Retime{1, 86400}),
            "the demonstration would last 86401.5 s, expected at most 86400");
  EXPECT_EQ(Complaint(Speed{0}), "factor is 0, expected 0.01 to 100");
  EXPECT_EQ(Complaint(Speed{kNan}), "factor is NaN, expected 0.01 to 100");
  EXPECT_THROW(Edited(Edited(Short(), Drop{1, 1}), Trim{1, 0, 1}), std::invalid_argument);
}

TEST_F(EditTest, SpeedIsAlsoThatOfTheRobot) {
  recording::Demonstration robot = Short();
  robot.segments[0].commands = {
      {1, 0, sim::TakePose{.name = "ready", .speed = 0.3}},
      {2, 10, sim::FollowTrajectory{{{"head_pan"}, {{0, {0}, {0.1}}, {4, {1}, {0.2}}}}}},
      {3, 20,
       sim::JointVelocities{
           .arms = {{"left", {0.5}}}, .grippers = {{"left", 0.1}, {"right", -0.1}}, .head = 0.2}},
      {4, 30, sim::TurnJoint{.joint = "left_s0", .velocity = 0.3}}};
  const recording::EditableSegment twice = Edited(robot, Speed{2}).segments[0];
  EXPECT_EQ(std::get<sim::TakePose>(twice.commands[0].command).speed, 0.6);
  EXPECT_EQ(std::get<sim::FollowTrajectory>(twice.commands[1].command).trajectory.points,
            (std::vector<motion::TrajectoryPoint>{{0, {0}, {0.2}}, {2, {1}, {0.4}}}));
  EXPECT_EQ(
      std::get<sim::JointVelocities>(twice.commands[2].command),
      (sim::JointVelocities{
          .arms = {{"left", {1.0}}}, .grippers = {{"left", 0.2}, {"right", -0.2}}, .head = 0.4}));
  EXPECT_EQ(std::get<sim::TurnJoint>(twice.commands[3].command).velocity, 0.6);
  const recording::EditableSegment fastest = Edited(robot, Speed{10}).segments[0];
  EXPECT_EQ(std::get<sim::TakePose>(fastest.commands[0].command).speed, 1);
}

TEST_F(EditTest, AHandsSpeedStaysOneThatCanBeRead) {
  recording::Demonstration slow = Short();
  std::get<sim::MoveTo>(slow.segments[1].commands[1].command).speed = 1e-6;
  EXPECT_THROW(Edited(slow, Speed{0.01}), std::invalid_argument);
}

TEST_F(EditTest, CutsAtActionsAndFindsPauses) {
  const recording::Recording recording =
      recording::OpenRecording(Record(R"({"do":"wait","seconds":1}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","until":"arrived"}
{"do":"wait","seconds":2}
{"hand":"left","do":"release"}
{"do":"wait","seconds":3})"));
  const recording::Demonstration demonstration = recording::DemonstrationOf(recording);
  ASSERT_EQ(Numbers(demonstration), (std::vector{0, 1, 2}));
  const auto& segments = demonstration.segments;
  EXPECT_EQ(segments[0].pauses, (std::vector<recording::TickSpan>{{0, 60}}));
  // The hand comes to rest, and waits.
  ASSERT_EQ(segments[1].pauses.size(), 1u);
  EXPECT_EQ(segments[1].pauses[0].end, segments[1].duration);
  EXPECT_NEAR(static_cast<double>(segments[1].pauses[0].length()), 120, 3);
  // The block falls, and lies.
  ASSERT_EQ(segments[2].pauses.size(), 1u);
  EXPECT_GT(segments[2].pauses[0].begin, 10u);
  EXPECT_GT(segments[2].pauses[0].length(), 60u);
  EXPECT_EQ(demonstration.duration(), demonstration.recorded_end.tick);
}

TEST_F(EditTest, CommandsThatAreRefusedAreSkippedAndReported) {
  recorder::PaintedEye eye;
  const auto demo = Record(kStackAOnB, false, nullptr, kScene,
                           {.frames_per_second = 12, .title = "stack", .notes = "a on b"});
  const recording::Recording recording = recording::OpenRecording(demo);
  const std::string log = ReadFile(demo / "commands.jsonl", 1 << 20);
  const EditReport report = ReSimulated(recording, {Drop{1, 1}}, &eye);
  EXPECT_EQ(report.skipped, (std::vector<SkippedCommand>{{5, "the left hand holds nothing"}}));
  ASSERT_EQ(report.displaced.size(), 1u);
  EXPECT_EQ(report.displaced[0].id, "a");
  EXPECT_NEAR(report.displaced[0].gap.distance, std::hypot(0.3, 0.1), 0.002);
  EXPECT_LT(report.ticks_after, report.ticks_before);

  const recording::Recording edited = recording::OpenRecording(root_ / "edited");
  EXPECT_EQ(edited.info.origin, recording::Origin::kEdited);
  EXPECT_EQ(edited.info.title, "stack");
  EXPECT_EQ(edited.info.notes, "a on b");
  EXPECT_EQ(edited.info.frames_per_second, 12);
  EXPECT_EQ(edited.commands.size(), 0u);
  EXPECT_GT(eye.num_pictures(), 0);
  EXPECT_EQ(replay::Replay(edited).ticks(), report.ticks_after);
  EXPECT_EQ(ReadFile(demo / "commands.jsonl", 1 << 20), log);
  EXPECT_THROW(ReSimulated(recording, {}), InputError) << "edited is there already";
}

// All of it in the last tick, which the trace does not show.
TEST_F(EditTest, ReportsStatesAndRestoredObjects) {
  constexpr const char* kPanel =
      R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <composite id="panel" location="(0,3,0.2)">
    <block xspan="4" yspan="2" zspan="0.4" location="(0,0,0)"/>
    <toggleSwitch id="power" location="(-1,0,0.2)" numStates="2"/>
  </composite>
  <composite id="nut" location="(-4,0,0.25)">
    <ring radiusOuter="0.6" radiusInner="0.3" zspan="0.5" location="(0,0,0)"/>
    <hostBondPoint id="hole" type="m8"><tightness location="(0,0,0.8)"/></hostBondPoint>
  </composite>
  <composite id="screw" location="(-4,0,3)">
    <block xspan="0.2" yspan="0.2" zspan="1" location="(0,0,0)"/>
    <guestBondPoint id="tip" type="m8" location="(0,0,-0.5)" initBondHostId="hole" initBondTightness="1"/>
  </composite>
  <block id="a" location="(0,-2,0.5)"/>
</tabletop>)xml";
  const recording::Recording recording =
      recording::OpenRecording(Record(R"({"hand":"left","do":"trigger","control":"power"}
{"hand":"left","do":"loosen","object":"screw"}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"destroy"})",
                                      false, nullptr, kPanel));
  const EditReport report = ReSimulated(recording, {Drop{1, 4}});
  EXPECT_EQ(report.controls, (std::vector<ChangedState>{{"power", "1", "0"}}));
  EXPECT_EQ(report.host_points, (std::vector<ChangedState>{{"hole", "0", "1"}}));
  EXPECT_EQ(report.there_again, std::vector<std::string>{"a"});
  EXPECT_FALSE(report.ends_the_same());
}

TEST_F(EditTest, ARobotsCommandsAreEditedLikeOthers) {
  const recording::Recording recording =
      recording::OpenRecording(Record(R"({"do":"joint_velocities","head":0.3}
{"do":"wait","seconds":1}
{"do":"joint_velocities","head":0}
{"do":"wait","seconds":2})",
                                      /*with_robot=*/true));
  const recording::EditableSegment segment = recording::DemonstrationOf(recording).segments.at(0);
  ASSERT_EQ(segment.pauses.size(), 1u);
  const std::uint64_t stopped = segment.pauses[0].begin;  // the head brakes first
  EXPECT_NEAR(static_cast<double>(stopped), 60, 10);
  EXPECT_EQ(ReSimulated(recording, {MaxPause{0.5}}).ticks_after, stopped + 30);
  const recording::Recording edited = recording::OpenRecording(root_ / "edited");
  EXPECT_EQ(edited.commands.at(1).tick, 60u);
  EXPECT_EQ(replay::Replay(edited).first_difference, std::nullopt);
}

TEST_F(EditTest, ImportedRecordingsHaveNothingToEdit) {
  recording::Recording recording = recording::OpenRecording(Record());
  recording.info.origin = recording::Origin::kImported;
  EXPECT_THROW(recording::DemonstrationOf(recording), InputError);
}

TEST_F(EditTest, NamesTheLineThatIsBehindTheEnd) {
  recording::Recording recording = recording::OpenRecording(Record());
  recording.commands.push_back({6, 99999, sim::Release{.hand = HandName::kLeft}});
  try {
    (void)recording::DemonstrationOf(recording);
    ADD_FAILURE() << "took a command behind the end";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("commands.jsonl:6: \"tick\" is 99999, expected 0 to"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(EditTest, ShiftMovesWhatOneHandDoesWhileOthersStay) {
  const recording::Demonstration made = OfTwoHands();
  const auto later = Edited(made, Shift{1, 3, 0.5});
  EXPECT_EQ(later.duration(), 150u);
  EXPECT_EQ(Numbers(later), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(later.segments[1].duration, 10u);
  EXPECT_EQ(Offsets(later.segments[2]), (std::vector<std::uint64_t>{0, 10, 40}));
  EXPECT_EQ(Numbers(Edited(made, Shift{2, 2, -1})), (std::vector<int>{0, 2, 1, 3}));
  EXPECT_EQ(Complaint(Shift{1, 1, 0.5}, made),
            "it is shifted by 0.5 s, expected -1 to 0.16 s: between what the left hand does before "
            "and after");
  EXPECT_EQ(Complaint(Shift{0, 0, 0.5}, made), "segment 0 is not the action of a hand");
}

TEST_F(EditTest, StretchSpreadsWhatOneHandDoesWhileOthersStay) {
  const recording::Demonstration made = OfTwoHands();
  const auto longer = Edited(made, Stretch{1, 3, 1.5});
  EXPECT_EQ(longer.duration(), 150u);
  EXPECT_EQ(Numbers(longer), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(Offsets(longer.segments[1]), (std::vector<std::uint64_t>{0, 30}));
  EXPECT_EQ(longer.segments[1].duration, 40u) << "the right hand acts when it did";
  EXPECT_EQ(Offsets(longer.segments[2]), (std::vector<std::uint64_t>{0, 35}));
  EXPECT_EQ(longer.segments[2].duration, 50u);
  // Short enough, it is over before the right hand begins.
  EXPECT_EQ(Numbers(Edited(made, Stretch{1, 3, 0.5})), (std::vector<int>{0, 1, 3, 2}));
  EXPECT_EQ(Edited(made, Stretch{1, 3, 3}).duration(), 240u);
  EXPECT_EQ(
      Complaint(Stretch{1, 1, 1.5}, made),
      "it takes 1.5 times as long, expected at most 1.2: up to what the left hand does after");
  EXPECT_EQ(Complaint(Stretch{0, 1, 1.5}, made), "segment 0 is not the action of a hand");
  EXPECT_EQ(Complaint(Stretch{1, 3, 0}, made), "factor is 0, expected 0.01 to 100");
  EXPECT_EQ(Complaint(Stretch{2, 1, 1}, made), "last segment is 1, expected 2 to 3");
}

TEST_F(EditTest, AnotherDemonstrationActsAtTheSameTime) {
  const auto turn = DemonstrationOf(recording::OpenRecording(Record(
      R"({"do":"face","mood":"done"}
{"hand":"left","do":"grasp","object":"b"}
{"hand":"left","do":"rotate","angles":[0,0,40]}
{"do":"wait","seconds":0.5}
{"hand":"left","do":"release"}
{"do":"wait","seconds":0.5})",
      true)));
  std::filesystem::rename(root_ / "demo", root_ / "turn");
  const recording::Recording stack = recording::OpenRecording(Record());
  const std::size_t num_lines = stack.log.lines().size();
  const recording::Demonstration first = DemonstrationOf(stack);

  const auto both =
      Overlaid(first, {.demonstration = turn, .begin = 20, .hand = HandName::kRight}, num_lines);
  EXPECT_EQ(both.duration(), first.duration());
  EXPECT_EQ(both.segments.size(), 5u);  // the start and two actions of each hand
  const EditReport report = ReSimulate(stack, both, EditOutput{root_ / "both"});
  EXPECT_EQ(report.skipped.size(), 0u);
  // The left hand stacks a on b, which the right one has turned meanwhile.
  ASSERT_EQ(report.displaced.size(), 1u);
  EXPECT_EQ(report.displaced[0].id, "b");
  EXPECT_NEAR(report.displaced[0].gap.degrees(), 40, 1);
  EXPECT_EQ(replay::Replay(recording::OpenRecording(root_ / "both")).first_difference,
            std::nullopt);

  // One hand cannot hold both; the refused line is one of the other log.
  const auto one_hand = Overlaid(first, {.demonstration = turn, .begin = 20}, num_lines);
  const EditReport refused = ReSimulate(stack, one_hand, std::nullopt);
  ASSERT_FALSE(refused.skipped.empty());
  EXPECT_EQ(refused.skipped[0].line, 2u);
  EXPECT_TRUE(refused.skipped[0].is_of_overlay);
}

TEST_F(EditTest, ReportsConflictsOfHandsAndKeepsThemWithTheRecording) {
  const recording::Recording take = recording::OpenRecording(Record(
      R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","seconds":1}
{"hand":"left","do":"release"}
{"do":"wait","seconds":1}
{"hand":"right","do":"grasp","object":"a"}
{"hand":"right","do":"move_to","position":[2,-2,3]}
{"do":"wait","seconds":1})"));
  // Later by a little, it is taken where it was; earlier, it is taken from the other hand, or not
  // where it was.
  EXPECT_TRUE(ReSimulated(take, {Shift{3, 3, 0.5}}).conflicts.empty());
  std::filesystem::remove_all(root_ / "edited");
  const auto early = ReSimulated(take, {Shift{3, 3, -1.25}}).conflicts;
  ASSERT_EQ(early.size(), 2u);
  EXPECT_EQ(early[0].hand, HandName::kRight);
  EXPECT_NEAR(early[0].seconds, 0.75, 0.02);
  EXPECT_EQ(early[0].reason, "takes a from the left hand, which holds it now");
  EXPECT_EQ(early[1].hand, HandName::kLeft);
  EXPECT_EQ(early[1].reason, "the left hand holds nothing");
  EXPECT_EQ(recording::ReadConflicts(root_ / "edited"), early);
  std::filesystem::remove_all(root_ / "edited");
  const auto falling = ReSimulated(take, {Shift{3, 3, -0.95}}).conflicts;
  ASSERT_EQ(falling.size(), 1u);
  EXPECT_NE(falling[0].reason.find(" degrees from where it was taken"), std::string::npos)
      << falling[0].reason;
}

}  // namespace
}  // namespace smile::editing

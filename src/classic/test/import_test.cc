#include <fstream>
#include <random>

#include "base/diagnostic.h"
#include "classic/import_classic.h"
#include "damage.h"
#include "math/angles.h"
#include "recorder/test/painted_eye.h"
#include "recorder/test/recording_fixture.h"
#include "recording/beginning.h"
#include "recording/recording_history.h"
#include "recording/trace_reader.h"
#include "replay/replay.h"
#include "sim/test/everything_scene.h"

namespace smile::classic {
namespace {

/// How far an object may be from its last line: what it went in less than a line's worth.
constexpr double kUnwritten = 0.0317 * 0.1;  // [m]
constexpr double kUnwrittenAngle = DegreesToRadians(1.5);

class ImportTest : public recorder::RecordingFixture {
 protected:
  /// What the original would have left of a recording.
  std::filesystem::path Strip(const std::filesystem::path& demo) const {
    const auto classic = root_ / "classic";
    std::filesystem::create_directories(classic);
    for (const auto& entry : std::filesystem::directory_iterator(demo)) {
      const std::string name = entry.path().filename().string();
      if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) continue;
      std::filesystem::copy(entry.path(), classic / name, std::filesystem::copy_options::recursive);
    }
    return classic;
  }

  std::filesystem::path WriteTexts(const std::vector<std::string>& texts) const {
    const auto classic = root_ / "classic";
    std::filesystem::remove_all(classic);
    std::filesystem::create_directories(classic);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      std::ofstream(classic / (std::to_string(i) + ".txt")) << texts[i];
    }
    return classic;
  }

  recording::Recording Import(const std::filesystem::path& classic, ImportOptions options = {}) {
    report_ = ImportClassic(classic, root_ / "imported", options);
    return recording::OpenRecording(root_ / "imported");
  }

  static scene::SceneSpec SceneFrom(const char* xml) {
    return *scene_xml::ReadSceneText(xml, "scene.xml").scene;
  }

  static std::vector<recording::TraceTick> Moments(const recording::Recording& recording) {
    recording::TraceReader trace(recording);
    std::vector<recording::TraceTick> moments;
    while (auto moment = trace.Next()) moments.push_back(std::move(*moment));
    EXPECT_FALSE(trace.is_cut());
    return moments;
  }

  /// What begins segments, in order.
  static std::vector<sim::Event> ActionsIn(const std::vector<recording::TraceTick>& moments) {
    std::vector<sim::Event> actions;
    for (const recording::TraceTick& moment : moments) {
      for (const sim::Event& event : moment.events) {
        if (BeginsAction(event)) actions.push_back(event);
      }
    }
    return actions;
  }

  static void ExpectNear(const recording::TracePose& imported, const recording::TracePose& recorded,
                         const std::string& what) {
    ASSERT_EQ(imported.is_present, recorded.is_present) << what;
    if (!recorded.is_present) return;
    EXPECT_LT((imported.position - recorded.position).norm(), kUnwritten) << what;
    const Quaternion a = imported.pose_in_world().quaternion();
    EXPECT_LT(a.angularDistance(recorded.pose_in_world().quaternion()), kUnwrittenAngle) << what;
  }

  /// Every frame is as it was.
  static void ExpectSameFrames(const std::vector<recording::TraceTick>& imported,
                               const std::vector<recording::TraceTick>& recorded) {
    ASSERT_LE(imported.size(), recorded.size());
    ASSERT_EQ(imported.size() % 15, 1u);
    for (std::size_t tick = 0; tick < imported.size(); tick += 15) {
      ASSERT_EQ(imported[tick].tick, tick);
      for (std::size_t i = 0; i < imported[tick].objects.size(); ++i) {
        ExpectNear(imported[tick].objects[i], recorded[tick].objects[i],
                   "object " + std::to_string(i) + " at tick " + std::to_string(tick));
      }
      EXPECT_EQ(imported[tick].controls, recorded[tick].controls) << tick;
      EXPECT_EQ(imported[tick].bonds, recorded[tick].bonds) << tick;
    }
  }

  ImportReport report_;
};

TEST_F(ImportTest, ItsHistoryIsThatOfTheRecording) {
  const auto words = [](const recording::Recording& recording) {
    std::vector<std::string> of_steps;
    for (const recording::Segment& step : recording::HistoryOf(recording))
      of_steps.push_back(recording::WordsOf(step));
    return of_steps;
  };
  const auto demo = Record();
  const std::vector<std::string> recorded = words(recording::OpenRecording(demo));
  ASSERT_GT(recorded.size(), 2u);
  ImportOptions options;
  options.scene = SceneFrom(kScene);
  const recording::Recording imported = Import(Strip(demo), options);
  EXPECT_EQ(words(imported), recorded);
  const std::vector<recording::Segment> steps = recording::HistoryOf(imported);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].parent, i - 1);
    EXPECT_EQ(steps[i].begin.tick, steps[i - 1].end.tick);
  }
  EXPECT_EQ(steps.back().end.tick, Moments(imported).back().tick);
}

TEST_F(ImportTest, TakesThePlaceOfOneThatWasKilled) {
  const auto classic = WriteTexts({"0,create,a,shape,block\n0,move,a,0,0,0.5,0,0,0\n"});
  { const recording::BeginningMark killed(root_ / "imported"); }
  std::ofstream(root_ / "imported/scene.xml") << "<tabl";
  EXPECT_EQ(Import(classic).scene().objects.size(), 1u);
  EXPECT_FALSE(recording::IsAbandoned(root_ / "imported"));
  EXPECT_THROW(ImportClassic(classic, root_ / "imported", {}), InputError);
}

TEST_F(ImportTest, EveryFrameIsKeptAndNoneIsAdded) {
  const auto demo = Record();
  const auto recorded = Moments(recording::OpenRecording(demo));
  for (const bool has_scene : {true, false}) {
    ImportOptions options;
    if (has_scene) options.scene = SceneFrom(kScene);
    const auto imported = Moments(Import(Strip(demo), options));
    ExpectSameFrames(imported, recorded);
    for (std::size_t tick = 1; tick < imported.size(); ++tick) {
      if (tick % 15 != 0) {
        EXPECT_EQ(imported[tick].objects, imported[tick - 1].objects) << tick;
      }
    }
    // The pose of rest has a line of its own.
    const Vector3 error =
        imported.back().objects[0].position - recorded[imported.size() - 1].objects[0].position;
    EXPECT_LT(error.norm(), 1e-6);
    std::filesystem::remove_all(root_ / "imported");
    std::filesystem::remove_all(root_ / "classic");
  }
}

TEST_F(ImportTest, MakesARecordingOfItsOwnKind) {
  recorder::PaintedEye eye;
  const auto demo = Record(kStackAOnB, false, &eye);
  const auto classic = Strip(demo);
  const recording::Recording imported = Import(classic, {.title = "Stack", .notes = "from 2015"});
  EXPECT_EQ(imported.info.origin, recording::Origin::kImported);
  EXPECT_EQ(imported.info.title + imported.info.notes, "Stackfrom 2015");
  EXPECT_EQ(imported.info.scene, "classic");
  EXPECT_EQ(imported.info.robot, std::nullopt);
  EXPECT_EQ(imported.info.eye->intrinsics.width_px, eye.spec().width_px);
  EXPECT_TRUE(imported.cuts.empty());
  EXPECT_TRUE(imported.log.lines().empty());
  EXPECT_THROW(replay::Replay(imported), InputError);
  EXPECT_EQ(report_.frames * 15 - 14, Moments(imported).size());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(classic)) {
    if (!entry.is_regular_file()) continue;
    const auto name = std::filesystem::relative(entry.path(), classic);
    EXPECT_EQ(ReadFile(entry.path(), 1 << 20), ReadFile(imported.directory / name, 1 << 20));
  }
  // As the recorder wrote it, up to the last frame that has a line.
  const auto index = Lines(imported.directory / "frames.csv");
  const auto recorded = Lines(demo / "frames.csv");
  ASSERT_EQ(index.size(), report_.frames + 1);
  EXPECT_TRUE(std::equal(index.begin(), index.end(), recorded.begin()));
}

constexpr const char* kWorkbench =
    R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <composite id="panel" location="(0,3,0.21)">
    <block xspan="4" yspan="2" zspan="0.4" location="(0,0,0)"/>
    <toggleSwitch id="power" location="(-1,0,0.2)" numStates="3" leftPressed="false"><downstream id="lamps"/></toggleSwitch>
    <indicatorLights id="lamps" location="(0,0,0.2)"><downstream id="dial"/>
      <state descriptionName="off"/><state descriptionName="on"><light id="0"/></state>
    </indicatorLights>
    <customControl id="dial" name="knob" location="(1,0,0.2)">
      <state descriptionName="low"><block id="cap" pointable="true" zspan="0.2" location="(0,0,0.1)" nextStateWhenTriggered="1"/></state>
      <state descriptionName="high"><block zspan="0.6" location="(0,0,0.3)" nextStateWhenTriggered="0"/></state>
    </customControl>
  </composite>
  <composite id="nut" location="(-4,0,0.25)">
    <ring radiusOuter="0.6" radiusInner="0.3" zspan="0.5" location="(0,0,0)"/>
    <hostBondPoint id="hole" type="m8">
      <tightness location="(0,0,0.8)"/><tightness location="(0,0,0.5)" rotation="(0,0,45)"/>
    </hostBondPoint>
  </composite>
  <composite id="screw" location="(-4,0,3)">
    <block xspan="0.2" yspan="0.2" zspan="1" location="(0,0,0)"/>
    <guestBondPoint id="tip" type="m8" location="(0,0,-0.5)" initBondHostId="hole" initBondTightness="1"/>
  </composite>
  <block id="spare" location="(5,0,0.5)"/>
</tabletop>)xml";

constexpr const char* kShift = R"({"do":"wait","seconds":0.5}
{"hand":"left","do":"trigger","control":"power"}
{"do":"wait","seconds":0.7}
{"hand":"left","do":"trigger","control":"dial"}
{"hand":"right","do":"point","part":"cap"}
{"hand":"right","do":"fasten","object":"screw"}
{"do":"wait","seconds":0.6}
{"hand":"right","do":"loosen","object":"screw"}
{"do":"wait","seconds":0.6}
{"hand":"right","do":"loosen","object":"screw"}
{"hand":"left","do":"grasp","object":"spare"}
{"do":"wait","seconds":0.6}
{"hand":"left","do":"destroy"}
{"hand":"right","do":"grasp","object":"screw"}
{"hand":"right","do":"move_to","position":[-4,0,3]}
{"do":"wait","seconds":1})";

TEST_F(ImportTest, ControlsAndBondsAreAsTheyWere) {
  const auto demo = Record(kShift, false, nullptr, kWorkbench);
  const auto recorded = Moments(recording::OpenRecording(demo));
  const auto imported = Moments(Import(Strip(demo), {.scene = SceneFrom(kWorkbench)}));
  ExpectSameFrames(imported, recorded);
  const auto actions = ActionsIn(imported);
  const auto expected = ActionsIn(recorded);
  ASSERT_EQ(actions.size(), 9u);
  ASSERT_EQ(expected.size(), actions.size());
  for (std::size_t i = 0; i < actions.size(); ++i) {
    EXPECT_EQ(actions[i].kind, expected[i].kind) << i;
    EXPECT_EQ(actions[i].hand, expected[i].hand) << i;
    EXPECT_EQ(actions[i].object + actions[i].part + actions[i].control + actions[i].state,
              expected[i].object + expected[i].part + expected[i].control + expected[i].state)
        << i;
    EXPECT_EQ(actions[i].host, expected[i].host) << i;
    EXPECT_EQ(actions[i].guest, expected[i].guest) << i;
    EXPECT_EQ(actions[i].tightness, expected[i].tightness) << i;
  }
  EXPECT_TRUE(report_.remarks.empty());
}

TEST_F(ImportTest, PlaceholdersReportWhatTheyCannotShow) {
  const recording::Recording imported = Import(Strip(Record(kShift, false, nullptr, kWorkbench)));
  EXPECT_EQ(
      report_.remarks,
      (std::vector<std::string>{
          "without its scene, every object is shown as a block; name the scene with --scene",
          "blocks have no controls: the states of 3 appear in the texts only",
          "blocks have no bond points: 3 fasten and loosen actions appear in the texts only"}));
  EXPECT_EQ(ActionsIn(Moments(imported)).size(), 6u);
}

TEST_F(ImportTest, PlaceholdersMayHaveOtherIds) {
  const recording::Recording imported = Import(
      WriteTexts({"0,create,rope-start\n"
                  "0,create,rope-end\n"
                  "0,move,rope-end,1,0,1,0,0,0\n",
                  "1,grasp,LeftHand,rope-end\n", "1,pointTo,RightHand,rope-end,rope-end\n"}));
  EXPECT_EQ(report_.remarks.at(1),
            "not all ids are valid in scene files: 2 are changed, for example rope-start is now "
            "rope_start");
  for (const sim::Event& action : ActionsIn(Moments(imported))) {
    EXPECT_EQ(action.object, "rope_end");
    EXPECT_EQ(action.part, action.kind == sim::EventKind::kPointed ? "rope_end" : "");
  }
}

TEST_F(ImportTest, EventsBeforeAFrameAreReportedBeforeIt) {
  const recording::Recording imported =
      Import(WriteTexts({"0,create,a\n"
                         "0,grasp,LeftHand,a\n"
                         "0,move,a,0,0,1,0,0,0\n"
                         "2,move,a,0,0,2,0,0,0\n",
                         "3,release,LeftHand\n"
                         "3,move,a,0,0,1,0,0,0\n"}));
  recording::TraceReader trace(imported);
  ASSERT_EQ(trace.events_before_start().size(), 1u);
  EXPECT_EQ(trace.events_before_start()[0].object, "a");
  const auto moments = Moments(imported);
  ASSERT_EQ(moments.size(), 46u);
  for (const recording::TraceTick& moment : moments) {
    EXPECT_EQ(moment.events.size(), moment.tick == 44 ? 1u : 0u) << moment.tick;
    EXPECT_NEAR(moment.objects[0].position.z(), moment.tick / 15 == 2 ? 0.2 : 0.1, 1e-12);
  }
  EXPECT_EQ(moments[44].events[0].object, "a");
}

TEST_F(ImportTest, ThingsAreThereFromTheirFirstPoseUntilTheyAreDeleted) {
  const recording::Recording imported =
      Import(WriteTexts({"0,create,early\n"
                         "0,move,early,0,0,1,30,90,50\n"
                         "1,create,late\n"
                         "2,move,late,1,0,1,0,0,0\n",
                         "3,grasp,AnyHand,late\n",
                         "4,delete,late\n"
                         "4,destroy,AnyHand\n"
                         "5,create,late\n"
                         "6,move,late,2,0,1,0,0,0\n"}));
  std::string late;
  const auto moments = Moments(imported);
  for (std::size_t tick = 0; tick < moments.size(); tick += 15) {
    EXPECT_TRUE(moments[tick].objects[0].is_present);
    late += moments[tick].objects[1].is_present ? '+' : '-';
  }
  EXPECT_EQ(late, "--++--+");
  EXPECT_EQ(moments[59].events.at(0).object, "late");
  const Matrix3 R_WB = moments[0].objects[0].pose_in_world().rotation();
  EXPECT_TRUE(R_WB.isApprox(RotationFromFixedAxes({0, 90, 20}), 1e-9));
}

TEST_F(ImportTest, TheSceneMustHaveWhatTheRecordingIsAbout) {
  const auto answer = [this](const std::vector<std::string>& texts) -> std::string {
    const auto classic = WriteTexts(texts);
    try {
      Import(classic, {.scene = SceneFrom(kWorkbench)});
    } catch (const InputError& error) {
      EXPECT_FALSE(std::filesystem::exists(root_ / "imported"));
      return std::string(error.what()).substr(classic.string().size());
    }
    return "";
  };
  EXPECT_EQ(answer({"0,create,cup\n0,create,nut\n0,create,jug\n"}),
            ": contains objects that the scene \"scene\" does not have: cup, jug");
  const std::string start = "0,create,panel\n";
  EXPECT_EQ(answer({start + "0,initializeControl,knob,knob,panel,1\n"}),
            "/0.txt:2: the scene has no control \"knob\"");
  EXPECT_EQ(answer({start + "0,initializeControl,lamps,indicatorLights,panel,red\n"}),
            "/0.txt:2: found state \"red\", which lamps does not have");
  EXPECT_EQ(answer({start + "0,initializeControl,lamps,toggleSwitch,panel,0\n"}),
            "/0.txt:2: \"lamps\" is recorded as \"toggleSwitch\", in the scene it is "
            "\"indicatorLights\"");
  EXPECT_EQ(answer({start, "1,fasten,AnyHand,ear,panel,tip,panel,1\n"}),
            "/1.txt:1: the scene has no host point \"ear\"");
  EXPECT_EQ(answer({start, "1,fasten,AnyHand,hole,panel,tip,panel,3\n"}),
            "/1.txt:1: found tightness 3, expected at most 2 of \"hole\"");
  // The original wrote numbers of custom controls; what is not mentioned is not there.
  EXPECT_EQ(answer({start + "0,initializeControl,dial,low,panel,1\n0,move,panel,0,0,0,0,0,0\n"}),
            "");
  const auto moments = Moments(recording::OpenRecording(root_ / "imported"));
  EXPECT_EQ(moments[0].controls[2].state, 1);
  EXPECT_TRUE(moments[0].objects[0].is_present);
  EXPECT_FALSE(moments[0].objects[1].is_present);
}

TEST_F(ImportTest, DamagedTextsAreRefusedOrMakeASoundRecording) {
  const auto classic = Strip(Record(kShift, false, nullptr, kWorkbench));
  const scene::SceneSpec scene = SceneFrom(kWorkbench);
  std::mt19937 random(1);
  int num_imported = 0;
  for (int round = 0; round < 30; ++round) {
    const auto path = classic / (std::to_string(random() % 10) + ".txt");
    const std::string sound = ReadFile(path, 1 << 20);
    std::string text = sound;
    for (unsigned i = 0; i <= random() % 2; ++i) Damage(&text, &random);
    WriteFile(path, text);
    try {
      EXPECT_GT(Moments(Import(classic, {.scene = scene})).size(), 1u);
      ++num_imported;
      std::filesystem::remove_all(root_ / "imported");
    } catch (const InputError&) {
      EXPECT_FALSE(std::filesystem::exists(root_ / "imported"));
    }
    WriteFile(path, sound);
  }
  EXPECT_GT(num_imported, 5);
  EXPECT_LT(num_imported, 25);
}

TEST_F(ImportTest, NeverOverwrites) {
  const auto classic = WriteTexts({"0,create,a\n"});
  Import(classic);
  EXPECT_THROW(Import(classic), InputError);
}

TEST(WithRecordedState, IsTheInverseOfRecordedState) {
  const model::Model model(sim::EverythingScene::Make());
  const std::vector<model::ControlState>& states = model.initial_state().controls;
  ASSERT_GE(model.controls().size(), 3u);
  for (model::ControlIndex i : model.controls()) {
    const model::Control& control = model.control(i);
    const int num_states = scene::NumStatesOf(*control.part);
    for (int state = 0; state < num_states; ++state) {
      for (int position : {0, 1}) {
        const std::string recorded = RecordedState(control, {.state = state, .position = position});
        const auto found = WithRecordedState(control, states[i], recorded);
        ASSERT_TRUE(found) << control.id() << " " << recorded;
        EXPECT_EQ(RecordedState(control, *found), recorded);
      }
    }
    EXPECT_FALSE(WithRecordedState(control, states[i], "no such state"));
    EXPECT_FALSE(WithRecordedState(control, states[i], std::to_string(num_states + 1)));
  }
}

}  // namespace
}  // namespace smile::classic

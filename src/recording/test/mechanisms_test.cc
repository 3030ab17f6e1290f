// Controls, bonds, sliders, chains and destroyed things in a recording.

#include <cstring>

#include "recorder/test/recording_fixture.h"
#include "recording/internal_trace_format.h"
#include "recording/trace_reader.h"
#include "replay/replay.h"

namespace smile::recording {
namespace {

constexpr const char* kWorkshop =
    R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <composite id="panel" location="(0,3,0.21)">
    <block xspan="4" yspan="2" zspan="0.4" location="(0,0,0)"/>
    <toggleSwitch id="power" location="(-1,0,0.2)" numStates="3"><downstream id="lamps"/></toggleSwitch>
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
  <sliderJoint location="(4,0,0.5)" max="2" init="1">
    <block id="case" xspan="3" location="(0,0,0)"/>
    <block id="drawer" xspan="2" yspan="0.8" zspan="0.8" location="(0,0,0)"/>
  </sliderJoint>
  <chain id="rope" start="(-3,-4,5)" end="(3,-4,5)" linkCount="7"/>
</tabletop>)xml";

constexpr const char* kWork = R"({"do":"wait","seconds":0.5}
{"hand":"left","do":"trigger","control":"power"}
{"do":"wait","seconds":0.2}
{"hand":"left","do":"trigger","control":"dial"}
{"hand":"right","do":"point","part":"panel"}
{"hand":"right","do":"fasten","object":"screw"}
{"do":"wait","seconds":0.2}
{"hand":"right","do":"loosen","object":"screw"}
{"hand":"right","do":"loosen","object":"screw"}
{"hand":"left","do":"grasp","object":"rope-link3"}
{"do":"wait","seconds":0.2}
{"hand":"left","do":"destroy"}
{"do":"wait","seconds":1})";

class MechanismsRecordingTest : public recorder::RecordingFixture {
 protected:
  std::filesystem::path RecordWork() { return Record(kWork, false, nullptr, kWorkshop); }

  /// Without its frame number.
  static std::string FirstLine(const std::filesystem::path& path) {
    const std::string line = Lines(path).at(0);
    return line.substr(line.find(',') + 1);
  }
  static bool HasLine(const std::filesystem::path& path, const std::string& fields) {
    return ReadFile(path, 1 << 20).find("," + fields + "\n") != std::string::npos;
  }
};

TEST_F(MechanismsRecordingTest, ReplaysIdentically) {
  const replay::ReplayReport report = replay::Replay(OpenRecording(RecordWork()));
  EXPECT_EQ(report.first_difference, std::nullopt);
  EXPECT_EQ(report.hash, final_hash_);
}

/// A trace of today as version 2 had it: without events, counts, face expressions and what is
/// awake, else the same.
std::string AsVersion2(std::string trace, const TraceReader& reader, const TraceTick& shape) {
  const auto number_at = [&trace](std::uint64_t place) {
    std::uint32_t number = 0;
    std::memcpy(&number, &trace[place], sizeof number);
    return number;
  };
  std::uint64_t place = kTraceMagic.size() + 3 * sizeof(std::uint32_t);
  for (const auto* names : {&reader.object_names(), &reader.joint_names()}) {
    for (const std::string& name : *names) place += sizeof(std::uint32_t) + name.size();
  }
  trace[kTraceMagic.size()] = 2;
  std::string old = trace.substr(0, place);
  while (place < trace.size()) {
    const auto flags = static_cast<std::uint8_t>(trace[place + kRecordHead - 1]);
    if ((flags & kCountsChanged) != 0) trace.erase(place + kRecordHead, kCountsRecord);
    const std::uint32_t count = number_at(place + kRecordHead);
    std::uint64_t size = kRecordHead + 4;
    if (flags == kIsEvent) {
      place += size + count;
      continue;
    }
    for (std::uint32_t i = 0; i < count; ++i, size += kMovedObject) {
      trace[place + size + 4] &= static_cast<char>(kIsPresent);
    }
    if ((flags & kJointsChanged) != 0) size += 8 * shape.joints.size();
    if ((flags & kControlsChanged) != 0) size += kControlRecord * shape.controls.size();
    if ((flags & kBondsChanged) != 0) size += kBondRecord * shape.bonds.size();
    trace[place + kRecordHead - 1] &= static_cast<char>(~(kFaceExpressionChanged | kCountsChanged));
    old += trace.substr(place, size);
    if ((flags & kFaceExpressionChanged) != 0) size += kFaceExpressionRecord;
    place += size;
  }
  return old;
}

TEST_F(MechanismsRecordingTest, ReplaysFromFilesAsTheyUsedToBe) {
  const auto demo = RecordWork();
  {
    const std::string trace = ReadFile(demo / "trace.bin", 1 << 26);
    const Recording recording = OpenRecording(demo);
    const std::string old = AsVersion2(trace, TraceReader(recording), *LastMoment(recording));
    ASSERT_LT(old.size(), trace.size());
    WriteFile(demo / "trace.bin", old);
  }
  Json info = Json::parse(ReadFile(demo / "demo.json", 1 << 20));
  info["format"] = 1;
  for (const char* key : {"origin", "start", "has_symbols"}) info.erase(key);
  WriteFile(demo / "demo.json", info.dump());

  const replay::ReplayReport report = replay::Replay(OpenRecording(demo));
  EXPECT_EQ(report.first_difference, std::nullopt);
  EXPECT_EQ(report.hash, final_hash_);
}

TEST_F(MechanismsRecordingTest, ReportsWhatEndsDifferently) {
  const auto demo = RecordWork();
  std::string commands = ReadFile(demo / "commands.jsonl", 1 << 20);
  // Another knob is turned: the switch stays as it was.
  const std::string words = "\"control\":\"power\"";
  commands.replace(commands.find(words), words.size(), "\"control\":\"dial\"");
  WriteFile(demo / "commands.jsonl", commands);
  std::vector<std::string> otherwise;
  for (const replay::Difference& difference :
       replay::Replay(OpenRecording(demo)).state_differences) {
    otherwise.push_back(difference.object + "." + difference.quantity);
  }
  EXPECT_EQ(otherwise, (std::vector<std::string>{"power.state", "lamps.state"}));
}

TEST_F(MechanismsRecordingTest, WritesEveryActionAndControlToTheClassicView) {
  const auto demo = RecordWork();
  EXPECT_TRUE(HasLine(demo / "0.txt", "initializeControl,power,toggleSwitch,panel,0"));
  EXPECT_TRUE(HasLine(demo / "0.txt", "initializeControl,lamps,indicatorLights,panel,off"));
  EXPECT_TRUE(HasLine(demo / "0.txt", "initializeControl,dial,knob,panel,low"));
  EXPECT_TRUE(HasLine(demo / "0.txt",
                      "create,rope-link3,shape,chain-link,xspan,0.1,yspan,1,zspan,0.1,color,gray"));
  EXPECT_EQ(FirstLine(demo / "1.txt"), "trigger,LeftHand,power");
  EXPECT_TRUE(HasLine(demo / "1.txt", "changeControlState,power,1"));
  EXPECT_TRUE(HasLine(demo / "1.txt", "changeControlState,lamps,on"));
  EXPECT_TRUE(HasLine(demo / "1.txt", "changeControlState,dial,high"));
  EXPECT_EQ(FirstLine(demo / "2.txt"), "trigger,LeftHand,dial");
  EXPECT_EQ(FirstLine(demo / "3.txt"), "pointTo,RightHand,panel,panel");
  EXPECT_EQ(FirstLine(demo / "4.txt"), "fasten,RightHand,hole,nut,tip,screw,2");
  EXPECT_EQ(FirstLine(demo / "6.txt"), "loosen,RightHand,hole,nut,tip,screw,0");
  EXPECT_EQ(FirstLine(demo / "8.txt"), "destroy,LeftHand");
  EXPECT_TRUE(HasLine(demo / "8.txt", "delete,rope-link3"));
  EXPECT_FALSE(HasLine(demo / "8.txt", "move,rope-link3"));
}

TEST_F(MechanismsRecordingTest, TheTraceShowsControlsBondsAndWhatIsGone) {
  TraceReader trace(OpenRecording(RecordWork()));
  TraceTick first = *trace.Next(), last = first;
  int max_tightness = 0;
  while (auto moment = trace.Next()) {
    last = *moment;
    max_tightness = std::max(max_tightness, last.bonds.at(0).tightness);
  }
  EXPECT_EQ(first.controls.at(0).state, 0);
  EXPECT_EQ(last.controls.at(0).state, 1);
  EXPECT_EQ(first.bonds.at(0).tightness, 1);
  EXPECT_EQ(max_tightness, 2);
  EXPECT_EQ(last.bonds.at(0).guest, std::nullopt);
  std::vector<std::string> gone;
  for (std::size_t i = 0; i < last.objects.size(); ++i) {
    if (!last.objects[i].is_present) gone.push_back(trace.object_names()[i]);
  }
  EXPECT_EQ(gone, std::vector<std::string>{"rope-link3"});
}

}  // namespace
}  // namespace smile::recording

#include "task/demonstrated_structure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "recorder/test/recording_fixture.h"
#include "recording/recording.h"
#include "recording/recording_history.h"
#include "structure_maker.h"
#include "task/comparison.h"
#include "task/effects.h"
#include "task/failure_reason.h"
#include "task/structure_json.h"

namespace smile::task {
namespace {

using Ids = std::vector<std::string>;
using sim::EventKind;

class StructureTest : public recorder::RecordingFixture {
 protected:
  /// Of a scene and a script that we ship.
  recording::Recording Play(const std::string& scene) {
    return Play(scene, ReadFile(DataFile("examples/scenes/" + scene + ".jsonl"), 1 << 20));
  }
  recording::Recording Play(const std::string& scene, const std::string& script) {
    const std::filesystem::path folder = root_ / (scene + std::to_string(num_played_++));
    sim::Simulation simulation(scene_xml::LoadScene(DataFile("scenes/" + scene + ".xml")));
    recorder::Recorder recorder(folder, {}, nullptr, simulation);
    simulation.AddListener(&recorder);
    EpisodeObserver observer(&simulation);
    sim::ScriptPlayer player(sim::ParseScript(script, scene, 0.1));
    for (player.Advance(&simulation); !player.is_finished(); player.Advance(&simulation)) {
      simulation.Tick();
    }
    observed_ = observer.episode();
    return recording::OpenRecording(folder);
  }

  std::string TextOf(const Structure& structure) {
    std::string text;
    for (const std::string& line : WordsOf(structure, 0.1)) text += line + "\n";
    return text;
  }

  Episode observed_;
  int num_played_ = 0;
};

TEST_F(StructureTest, ContainsMovedObjectsAndTheirSupports) {
  const Structure structure = StructureOf(recording::OpenRecording(Record()));
  EXPECT_EQ(structure.order, Ids{"a"});
  EXPECT_EQ(structure.relations, (std::vector<Relation>{{"a", Relation::Kind::kOn, "b"},
                                                        {"b", Relation::Kind::kOn, ""}}));
  EXPECT_TRUE(structure.effects.empty());
  EXPECT_EQ(TextOf(structure), "1. a on b\nas it was: b on the table\n");
  EXPECT_FALSE(structure.is_fixed());
}

/// Returns a script in which a hand carries an object, high above all others.
std::string Carrying(const std::string& object, double from_x, double from_y, double to_x,
                     double to_y, double to_z) {
  std::string script = R"({"hand":"left","do":"grasp","object":")" + object + "\"}\n";
  for (const Vector3& at :
       {Vector3(from_x, from_y, 3), Vector3(to_x, to_y, 3), Vector3(to_x, to_y, to_z)}) {
    script += R"({"hand":"left","do":"move_to","position":[)" + std::to_string(at.x()) + "," +
              std::to_string(at.y()) + "," + std::to_string(at.z()) +
              "]}\n{\"do\":\"wait\",\"until\":\"arrived\"}\n";
  }
  return script + R"({"hand":"left","do":"release"}
{"do":"wait","until":"still"}
)";
}

TEST_F(StructureTest, WhatStayedAndCarriesOthersMayStandAnywhere) {
  const std::string script = Carrying("a", 0, -2, -3, 2, 0.71) + Carrying("b", 3, -2, 3, 2, 0.71);
  const Structure structure = StructureOf(recording::OpenRecording(
      Record(script.c_str(), false, nullptr,
             R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
<block id="a" location="(0, -2, 0.5)"/>
<block id="b" location="(3, -2, 0.5)"/>
<block id="p" location="(-3, 2, 0.1)" xspan="2" yspan="2" zspan="0.2"/>
<block id="q" location="(3, 2, 0.1)" xspan="2" yspan="2" zspan="0.2"/></tabletop>)xml")));
  EXPECT_EQ(structure.foundations, (Ids{"p", "q"}));
  EXPECT_EQ(TextOf(structure),
            "1. a on p\n2. b on q\nas it was: p on the table\nas it was: q on the table\n"
            "p may stand anywhere, with what it carries\n"
            "q may stand anywhere, with what it carries\n");
}

TEST_F(StructureTest, PlacementsAgreeWithTheHistory) {
  // A ring has no floor, so that what lies in it lies on the table, too.
  const recording::Recording demo = recording::OpenRecording(
      Record(Carrying("a", 0, 0, 4, 0, 0.6).c_str(), false, nullptr,
             R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="a" location="(0, 0, 0.5)"/>
  <ring id="ring" location="(4, 0, 0.5)" radiusOuter="1.5" radiusInner="1" zspan="1"/>
</tabletop>)xml"));
  const Structure structure = StructureOf(demo);
  EXPECT_EQ(structure.relations.front(), (Relation{"a", Relation::Kind::kIn, "ring"}));
  const std::vector<recording::Segment> history = recording::HistoryOf(demo);
  EXPECT_EQ(WordsOf(*history.back().summary), "left hand puts a into ring");
}

constexpr const char* kPush = R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[2,-2,0.5]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","until":"still"})";

// A push, an exchange or "beside" leaves a structure that stood from the start, freely placed.
TEST_F(StructureTest, IsAnchoredToTheTableIfItStoodFromTheStart) {
  const Structure structure = StructureOf(recording::OpenRecording(
      Record(kPush, false, nullptr, R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
<block id="a" location="(-2, -2, 0.5)"/></tabletop>)xml")));
  EXPECT_EQ(structure.anchor, Anchor::kTable);
  EXPECT_EQ(TextOf(structure), "1. a on the table\nwhat matters is the place on the table\n");
  EXPECT_EQ(ToJson(structure, 0.1)["anchor"], "");
}

TEST_F(StructureTest, IsAnchoredToTheNearestObjectThatStayed) {
  const Structure structure = StructureOf(recording::OpenRecording(
      Record(kPush, false, nullptr, R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
<block id="a" location="(-2, -2, 0.5)"/>
<block id="far" location="(8, 3, 0.5)"/>
<block id="near" location="(4, -2, 0.5)"/></tabletop>)xml")));
  EXPECT_EQ(structure.landmark, "near");
  EXPECT_EQ(TextOf(structure),
            "1. a on the table\nas it was: near on the table\n"
            "what matters is the place relative to near\n");
}

TEST_F(StructureTest, WhatARingWasPutAroundBelongsToTheTask) {
  const Structure structure = StructureOf(recording::OpenRecording(
      Record(R"({"hand":"left","do":"grasp","object":"ring"}
{"hand":"left","do":"move_to","position":[-4,0,5]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[2,0,5]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[2,0,0.5]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","until":"still"})",
             false, nullptr, R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
<ring id="ring" location="(-4, 0, 0.25)" radiusOuter="1" radiusInner="0.8" zspan="0.5"/>
<block id="post" location="(2, 0, 1.5)" xspan="0.5" yspan="0.5" zspan="3" mass="0"/>
<block id="other" location="(-2, 3, 0.5)" mass="0"/></tabletop>)xml")));
  EXPECT_EQ(structure.around, (std::vector<Surrounding>{{"ring", "post"}}));
  EXPECT_EQ(TextOf(structure),
            "1. ring on the table\nas it was: post on the table, fixed\n"
            "what matters is that ring is around post\n");
  EXPECT_EQ(ToJson(structure, 0.1)["around"], Json({{{"object", "ring"}, {"inner", "post"}}}));
}

TEST_F(StructureTest, ReportsAttention) {
  const Structure structure = StructureOf(recording::OpenRecording(Record(
      R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"attend","properties":["color","size"]}
{"hand":"left","do":"release"})")));
  EXPECT_EQ(structure.attention, (Attention{{"a", {"color", "size"}}}));
  EXPECT_EQ(TextOf(structure), "as it was: a on the table\nof a matters its color and size\n");
}

TEST_F(StructureTest, ReportsFallenObjects) {
  const Structure structure = StructureOf(recording::OpenRecording(Record(
      R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[-9.7,0,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[-14,0,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","until":"still"}
{"hand":"left","do":"grasp","object":"b"}
{"hand":"left","do":"release"})")));
  EXPECT_EQ(structure.fallen, Ids{"a"});
  EXPECT_EQ(TextOf(structure), "as it was: b on the table\nachieved: a removed from the table\n");
  EXPECT_EQ(ToJson(structure, 0.1)["fallen"], Json({"a"}));
}

TEST_F(StructureTest, IsEmptyWithoutActions) {
  const auto demo = Record(R"({"do":"wait","seconds":0.1})");
  EXPECT_THROW(StructureOf(recording::OpenRecording(demo)), InputError);
}

TEST_F(StructureTest, ReportsEffectsOfMechanisms) {
  EXPECT_EQ(TextOf(StructureOf(Play("lidbox"))),
            "1. Cherry on the table\n"
            "2. ChestLid on Chest\n"
            "as it was: Chest on the table\n"
            "achieved: ChestLid slid from 2.2 to 0 units\n"
            "achieved: Cherry taken out of Chest\n");
  EXPECT_EQ(TextOf(StructureOf(Play("controls"))),
            "achieved: Signal from halt to drive\n"
            "achieved: Lamp from dark to blue\n");
  EXPECT_EQ(TextOf(StructureOf(Play("trapdoor"))),
            "1. HopperLid\n"
            "as it was: Hopper, fixed\n"
            "achieved: HopperLid slid from 0 to 4 units\n"
            "achieved: Rust taken out of Hopper\n"
            "achieved: Sky taken out of Hopper\n"
            "achieved: Moss taken out of Hopper\n");
  const Structure screws = StructureOf(Play("screws"));
  ASSERT_EQ(screws.effects.size(), 2u);
  EXPECT_EQ(WordsOf(screws.effects[0], 0.1), "BrassScrewTip fastened to NutHole, stage 3");
}

// What is dropped beyond the table's edge or destroyed needs to go, and has no place.
TEST_F(StructureTest, RemovedObjectsAreAnEffect) {
  const recording::Recording demo = recording::OpenRecording(Record(
      R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"destroy"}
{"do":"wait","seconds":0.1})"));
  const Structure structure = StructureOf(demo);
  EXPECT_EQ(structure.effects, std::vector<Effect>{DestroyedEffect{"a"}});
  EXPECT_EQ(TextOf(structure), "achieved: a removed from the table\n");
  EXPECT_EQ(ToJson(structure, 0.1)["effects"][0], Json({{"kind", "destroyed"}, {"object", "a"}}));
  Episode episode = EpisodeOf(demo);
  EXPECT_TRUE(CompareWith(structure, episode).is_achieved());
  EXPECT_EQ(CompareWith(structure, AtBegin(episode)).score, 0);
  // A robot cannot destroy it, but take it from the table.
  episode.end.objects[0] = TracePoseAt(RigidTransform(Vector3(-1.4, 0, -0.7)));
  episode.end.objects[0].is_present = true;
  EXPECT_TRUE(CompareWith(structure, episode).is_achieved());
}

TEST_F(StructureTest, WhatIsTurnedInPlaceOrTiltedIsAnEffect) {
  const auto turned_by = [&](const char* angles, const char* height = "1.01") {
    const std::string script = std::string(R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"rotate","angles":)") +
                               angles + R"(}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[0,-2,)" +
                               height +
                               R"(]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","until":"still"})";
    std::filesystem::remove_all(root_ / "demo");
    return recording::OpenRecording(
        Record(script.c_str(), false, nullptr,
               R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
<block id="a" location="(0, -2, 1)" zspan="2"/></tabletop>)xml"));
  };
  const recording::Recording tilted = turned_by("[90,0,0]", "0.51");
  const Structure lying = StructureOf(tilted);
  EXPECT_EQ(TextOf(lying), "1. a on the table\nachieved: a tilted by 90 degrees\n");
  const Episode episode = EpisodeOf(tilted);
  EXPECT_TRUE(CompareWith(lying, episode).is_achieved());
  EXPECT_EQ(CompareWith(lying, AtBegin(episode)).score, 0);
  const Structure turned = StructureOf(turned_by("[0,0,40]"));
  EXPECT_EQ(TextOf(turned),
            "1. a on the table\nachieved: a turned in place by 40 degrees\n"
            "what matters is the place on the table\n");
  EXPECT_EQ(StructureOf(turned_by("[0,0,10]")).effects, std::vector<Effect>());
}

TEST_F(StructureTest, APressThatLeavesNoTraceIsAnEffect) {
  std::string thrice;
  for (int i = 0; i < 3; ++i) {
    thrice += R"({"hand":"right","do":"trigger","control":"Switch"}
{"do":"wait","seconds":0.5}
)";
  }
  // Three lights: each press leads to the next one.
  const recording::Recording demo = Play("controls", thrice + thrice);
  const Structure structure = StructureOf(demo);
  EXPECT_EQ(TextOf(structure), "achieved: Switch pressed\n");
  const Episode episode = EpisodeOf(demo);
  EXPECT_TRUE(CompareWith(structure, episode).is_achieved());
  EXPECT_EQ(CompareWith(structure, AtBegin(episode)).score, 0);
}

TEST_F(StructureTest, ScrewsThatWereLoosenedAndFastenedAgainMustBeTight) {
  const auto turn = [](const std::string& what) {
    return R"({"hand":"right","do":")" + what +
           R"(","object":"BrassScrew"})"
           "\n"
           R"({"do":"wait","seconds":0.1})"
           "\n";
  };
  const recording::Recording demo = Play("screws", turn("loosen") + turn("fasten"));
  const Structure structure = StructureOf(demo);
  ASSERT_EQ(structure.effects.size(), 1u);
  EXPECT_EQ(WordsOf(structure.effects[0], 0.1), "BrassScrewTip fastened to NutHole, stage 1");
  EXPECT_TRUE(CompareWith(structure, EpisodeOf(demo)).is_achieved());
  EXPECT_FALSE(CompareWith(structure, EpisodeOf(Play("screws", turn("loosen")))).achieved[0]);
}

TEST_F(StructureTest, EqualScrewsMayBeInOneAnothersHoles) {
  const Episode episode = EpisodeOf(Play("cover", R"({"do":"wait","seconds":0.1})"));
  const std::vector<BondEffect> bonds = BondsAt(episode.scene, episode.end);
  ASSERT_EQ(bonds.size(), 4u);
  // Around a housing that looks the same from both sides, each screw is where the opposite one was.
  const std::map<std::string, std::string> opposite{{"ScrewNW", "ScrewSE"},
                                                    {"ScrewSE", "ScrewNW"},
                                                    {"ScrewNE", "ScrewSW"},
                                                    {"ScrewSW", "ScrewNE"}};
  const auto counterpart = [&](const std::string& id) {
    return opposite.contains(id) ? opposite.at(id) : id;
  };
  std::vector<Effect> tight(bonds.begin(), bonds.end()), tighter = tight;
  for (Effect& effect : tighter) ++std::get<BondEffect>(effect).tightness;
  EXPECT_EQ(AreAchieved(tight, episode, counterpart, kTolerance), std::vector<bool>(4, true));
  EXPECT_EQ(AreAchieved(tighter, episode, counterpart, kTolerance), std::vector<bool>(4, false));
}

// The rules of the Tower of Hanoi are what the demonstrator attends: the support of each disc.
TEST_F(StructureTest, AShortcutThroughTheTowerOfHanoiIsNoSuccess) {
  const recording::Recording demo =
      Play("hanoi", ReadFile(DataFile("examples/hanoi.jsonl"), 1 << 20));
  const Structure structure = StructureOf(demo);
  EXPECT_TRUE(CompareWith(structure, EpisodeOf(demo)).is_achieved());
  const auto move = [](const std::string& disc, double from, double to, double z) {
    const std::string at = R"({"hand":"left","do":"move_to","position":[)";
    const std::string arrived =
        "]}\n"
        R"({"do":"wait","until":"arrived"})"
        "\n";
    return R"({"hand":"left","do":"grasp","object":")" + disc + "\"}\n" + at +
           std::to_string(from) + ",1,4" + arrived + at + std::to_string(to) + ",1,4" + arrived +
           at + std::to_string(to) + ",1," + std::to_string(z) + arrived +
           R"({"hand":"left","do":"release"})"
           "\n"
           R"({"do":"wait","until":"still"})"
           "\n";
  };
  // Medium goes onto Small.
  const recording::Recording shortcut =
      Play("hanoi", move("SmallDisc", -3, 0, 0.51) + move("MediumDisc", -3, 0, 1.11) +
                        move("LargeDisc", -3, 3, 0.51) + move("MediumDisc", 0, 3, 1.11) +
                        move("SmallDisc", 0, 3, 1.71));
  const Episode episode = EpisodeOf(shortcut);
  const StructureComparison comparison = CompareWith(structure, episode);
  EXPECT_LT(comparison.mean_error().distance, 0.001) << "all discs are where they should be";
  ASSERT_EQ(comparison.broken_rules.size(), 1u);
  EXPECT_EQ(comparison.broken_rules[0].object, "MediumDisc");
  EXPECT_EQ(comparison.broken_rules[0].other, "SmallDisc");
  const auto reason = FailureReasonOf(structure, episode, comparison, {.status = "exited"});
  ASSERT_TRUE(reason);
  EXPECT_EQ(reason->code, "rule_broken");
  EXPECT_EQ(CompareWith(structure, observed_).broken_rules, comparison.broken_rules);
}

TEST_F(StructureTest, IsAchievedByItselfAndNotByAnIdleRun) {
  for (const char* scene : {"lidbox", "controls", "screws", "panel", "trapdoor", "dock"}) {
    const recording::Recording recording = Play(scene);
    const Structure structure = StructureOf(recording);
    const Episode episode = EpisodeOf(recording);
    const StructureComparison itself = CompareWith(structure, episode);
    EXPECT_EQ(itself.score, 1) << scene;
    EXPECT_LT(itself.mean_error().distance, 1e-9) << scene;
    EXPECT_TRUE(itself.order.is_kept()) << scene;
    EXPECT_EQ(FailureReasonOf(structure, episode, itself, {.status = "exited"}), std::nullopt);
    // The observer sees what the recording contains.
    EXPECT_EQ(CompareWith(structure, observed_).order, itself.order) << scene;

    Episode idle = episode;
    idle.end = episode.begin;
    idle.contacts.clear();
    const StructureComparison nothing = CompareWith(structure, idle);
    EXPECT_FALSE(nothing.is_achieved()) << scene;
    EXPECT_FALSE(std::ranges::all_of(nothing.achieved, std::identity())) << scene;
    const auto reason = FailureReasonOf(structure, idle, nothing, {.status = "exited"});
    ASSERT_TRUE(reason) << scene;
    EXPECT_EQ(reason->code, structure.objects.empty() ? "effect_missing" : "never_taken") << scene;
  }
}

/// Of blocks that begin apart, each in its corner.
Episode ThreeBlocks() {
  const std::vector<scene::ObjectSpec> start = {
      CubeAt("a", {-0.3, 0, 0.05}), CubeAt("b", {0, 0, 0.05}), CubeAt("c", {0.3, 0, 0.05})};
  return EpisodeBetween(start, start);
}

void Note(EventKind kind, const std::string& object, const Vector3& p, Episode* episode,
          const std::string& arm = "left") {
  episode->contacts.push_back({{.kind = kind, .arm = arm, .object = object}, 1, RigidTransform(p)});
}

TEST(Episode, UnmovedAndHeldObjectsAreNotPlaced) {
  Episode episode = ThreeBlocks();
  Note(EventKind::kGripperHolds, "a", {0, 0.3, 0}, &episode);
  Note(EventKind::kGripperReleased, "a", {-0.3, 0, 0.05}, &episode);
  Note(EventKind::kGripperHolds, "b", {0, 0, 0.05}, &episode);
  Note(EventKind::kGripperReleased, "b", {0, 0.004, 0.05}, &episode);
  EXPECT_EQ(PlacementsOf(episode), Ids{"a"});
  Note(EventKind::kGripperHolds, "c", {0.3, 0.3, 0.05}, &episode);
  Note(EventKind::kGripperHolds, "a", {0, 0.9, 0}, &episode, "right");
  EXPECT_EQ(PlacementsOf(episode), Ids{});
}

TEST(Episode, CountsGraspsAndRetries) {
  Episode episode = ThreeBlocks();
  Note(EventKind::kGripperHolds, "a", Vector3(0, 0, 0), &episode);
  Note(EventKind::kGripperHolds, "a", Vector3(0, 0, 0), &episode, "right");  // both arms carry it
  Note(EventKind::kGripperReleased, "a", Vector3(0, 0, 0), &episode);
  Note(EventKind::kGripperReleased, "a", Vector3(0, 0, 0), &episode, "right");
  Note(EventKind::kGripperHolds, "b", Vector3(0, 0, 0), &episode);
  EXPECT_EQ(WorkOf(episode), (Work{.grasps = 3, .retries = 0}));
  Note(EventKind::kGripperHolds, "a", Vector3(0, 0, 0), &episode);
  EXPECT_EQ(WorkOf(episode), (Work{.grasps = 4, .retries = 1}));
}

}  // namespace
}  // namespace smile::task

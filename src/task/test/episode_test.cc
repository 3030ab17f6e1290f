#include "task/episode.h"

#include <gtest/gtest.h>

#include <random>

#include "recorder/test/recording_fixture.h"
#include "scene_xml/scene_writer.h"
#include "sim/test/everything_scene.h"
#include "sim/test/random_hands.h"

namespace smile::task {
namespace {

using sim::EventKind, sim::HandName;

class EpisodeObserverTest : public ::testing::Test {
 protected:
  static scene::SceneSpec OneBlock() {
    scene::ObjectSpec block;
    block.whole = {.id = "a",
                   .X_PE = RigidTransform(Vector3(0, 0, 0.05)),
                   .shape = scene::Block{{0.1, 0.1, 0.1}}};
    return {.name = "one", .objects = {block}};
  }
  void Do(const sim::Command& command) { ASSERT_EQ(simulation_.Apply(command), std::nullopt); }
  std::vector<EventKind> Touches() const {
    std::vector<EventKind> kinds;
    for (const ContactEvent& contact : observer_.episode().contacts)
      kinds.push_back(contact.event.kind);
    return kinds;
  }

  sim::Simulation simulation_{OneBlock()};
  EpisodeObserver observer_{&simulation_};
};

TEST_F(EpisodeObserverTest, ARedoBringsBackWhatWasTouched) {
  const std::vector<EventKind> taken{EventKind::kGrasped};
  const std::vector<EventKind> put{EventKind::kGrasped, EventKind::kReleased};
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"});
  simulation_.Tick();
  Do(sim::Release{.hand = HandName::kLeft});
  EXPECT_EQ(Touches(), put);
  Do(sim::Undo());
  EXPECT_EQ(Touches(), taken);
  Do(sim::Undo());
  EXPECT_TRUE(Touches().empty());
  Do(sim::Redo());
  EXPECT_EQ(Touches(), taken);
  Do(sim::Redo());
  EXPECT_EQ(Touches(), put);
}

/// What was undone at the tick at which something else was done leaves the other.
TEST_F(EpisodeObserverTest, AnUndoTakesOnlyItsOwnAction) {
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"});
  Do(sim::Release{.hand = HandName::kLeft});
  Do(sim::Undo());
  EXPECT_EQ(Touches(), std::vector{EventKind::kGrasped});
}

/// The object falls to the floor after the undo; a redo leads back to where it is still held.
TEST_F(EpisodeObserverTest, EventsBetweenUndoAndRedoAreOmitted) {
  Do(sim::Grasp{.hand = HandName::kLeft, .object = "a"});
  Do(sim::MoveTo{.hand = HandName::kLeft, .p_WH = {1.5, 0, 0.3}});
  for (int i = 0; i < 300; ++i) simulation_.Tick();
  Do(sim::Release{.hand = HandName::kLeft});
  Do(sim::Point{.hand = HandName::kRight, .part = "a"});
  Do(sim::Undo());
  for (int i = 0; i < 300; ++i) simulation_.Tick();
  EXPECT_EQ(Touches().back(), EventKind::kFell);
  Do(sim::Redo());
  EXPECT_EQ(Touches(), (std::vector{EventKind::kGrasped, EventKind::kReleased}));
}

class EpisodeProperty : public recorder::RecordingFixture {};

TEST_F(EpisodeProperty, AnObserverReportsWhatTheRecordingShows) {
  const std::string xml = scene_xml::WriteScene(sim::EverythingScene::Make());
  sim::Simulation simulation(*scene_xml::ReadSceneText(xml, "everything.xml").scene);
  recorder::Recorder recorder(root_ / "demo", {}, nullptr, simulation);
  simulation.AddListener(&recorder);
  const EpisodeObserver observer(&simulation);
  sim::RandomHands hands(7, /*changes_objects=*/true);
  std::mt19937 random(7);
  int num_redone = 0;
  for (int i = 0; i < 200; ++i) {
    switch (random() % 8) {
      case 0:
        (void)simulation.Apply(sim::Undo());
        break;
      case 1:
        num_redone += simulation.Apply(sim::Redo()) ? 0 : 1;
        break;
      default:
        (void)simulation.Apply(hands.Next(simulation));
    }
    for (unsigned ticks = random() % 3 * 4; ticks > 0; --ticks) simulation.Tick();
  }
  EXPECT_GT(num_redone, 0);
  const std::vector<ContactEvent> observed = observer.episode().contacts;
  const std::vector<ContactEvent> shown =
      EpisodeOf(recording::OpenRecording(root_ / "demo")).contacts;
  EXPECT_GT(observed.size(), 5u);
  ASSERT_EQ(observed.size(), shown.size());
  for (std::size_t i = 0; i < observed.size(); ++i) {
    EXPECT_EQ(observed[i].event, shown[i].event);
    EXPECT_EQ(observed[i].tick, shown[i].tick);
  }
}

}  // namespace
}  // namespace smile::task

// Whatever is done to whatever was recorded.

#include <map>
#include <random>

#include "editing/edit.h"
#include "editing/re_simulation.h"
#include "recorder/recording_controller.h"
#include "recorder/test/recording_fixture.h"
#include "replay/replay.h"
#include "scene_xml/scene_writer.h"
#include "sim/test/everything_scene.h"
#include "sim/test/random_hands.h"

namespace smile::editing {
namespace {

class EditProperty : public recorder::RecordingFixture,
                     public ::testing::WithParamInterface<unsigned> {
 protected:
  /// Hands that do anything; some of it before the recording begins, some of it undone.
  recording::Recording RecordAtRandom() {
    const std::string xml = scene_xml::WriteScene(sim::EverythingScene::MakeWithTools());
    sim::Simulation simulation(*scene_xml::ReadSceneText(xml, "everything.xml").scene);
    sim::RandomHands hands(GetParam(), /*changes_objects=*/true);
    recorder::RecordingController controller(&simulation, {.recording = {.frames_per_second = 12}});
    for (int i = 0; i < 12; ++i) {
      (void)simulation.Apply(hands.Next(simulation));
      Wait(&simulation);
    }
    controller.StartIn(root_ / "demo", simulation);
    for (int i = 0; i < 40; ++i) {
      const bool undoes = random_() % 8 == 0;
      (void)simulation.Apply(undoes ? sim::Command(sim::Undo()) : hands.Next(simulation));
      Wait(&simulation);
    }
    simulation.Tick();  // what was done last shows in its hash
    final_hash_ = simulation.state_hash();
    return recording::OpenRecording(root_ / "demo");
  }

  /// Mostly of segments that are there, mostly with numbers that make sense.
  Edit AnyEdit(const recording::Demonstration& demonstration) {
    const auto segment = static_cast<int>(random_() % (demonstration.num_recorded + 1));
    const double seconds = std::uniform_real_distribution(-0.1, 1.0)(random_);
    switch (random_() % 8) {
      case 0:
        return Drop{segment, segment + static_cast<int>(random_() % 2)};
      case 1:
        return Move{segment, static_cast<int>(random_() % (demonstration.num_recorded + 1))};
      case 2:
        return Trim{segment, seconds / 4, seconds};
      case 3:
        return MaxPause{seconds / 4};
      case 4:
        return Retime{segment, seconds};
      case 5:
        return Shift{segment, segment + static_cast<int>(random_() % 2), seconds - 0.5};
      case 6:
        return Stretch{segment, segment + static_cast<int>(random_() % 2), 0.2 + 2 * seconds};
      default:
        return Speed{0.6 + seconds};
    }
  }

  static std::map<std::string, std::string> TextsOf(const std::filesystem::path& demo) {
    std::map<std::string, std::string> texts;
    for (const auto& entry : std::filesystem::directory_iterator(demo)) {
      if (entry.path().extension() != ".txt") continue;
      texts[entry.path().filename()] = ReadFile(entry.path(), 1 << 20);
    }
    return texts;
  }

  void Wait(sim::Simulation* simulation) {
    for (unsigned ticks = random_() % 10; ticks > 0; --ticks) simulation->Tick();
  }

  std::mt19937 random_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Seeds, EditProperty, testing::Range(1u, 4u));

TEST_P(EditProperty, WithoutEditsNothingChanges) {
  const recording::Recording recording = RecordAtRandom();
  const EditReport report =
      ReSimulate(recording, recording::DemonstrationOf(recording), EditOutput{root_ / "same"});
  EXPECT_TRUE(report.ends_the_same());
  EXPECT_TRUE(report.skipped.empty());
  EXPECT_EQ(replay::Replay(recording::OpenRecording(root_ / "same")).hash, final_hash_);
  EXPECT_EQ(TextsOf(root_ / "same"), TextsOf(root_ / "demo"));
}

TEST_P(EditProperty, AnyEditGivesARecordingThatReplays) {
  const recording::Recording recording = RecordAtRandom();
  const recording::Demonstration demonstration = recording::DemonstrationOf(recording);
  for (int run = 0; run < 2; ++run) {
    recording::Demonstration edited = demonstration;
    for (int i = 0; i < 8; ++i) {
      try {
        edited = Edited(edited, AnyEdit(edited));
      } catch (const std::invalid_argument&) {  // says why; nothing is changed then
      }
    }
    const auto directory = root_ / ("edited" + std::to_string(run));
    const EditReport report = ReSimulate(recording, edited, EditOutput{directory});
    const recording::Recording result = recording::OpenRecording(directory);
    const replay::ReplayReport replay = replay::Replay(result);
    EXPECT_EQ(replay.first_difference, std::nullopt);
    EXPECT_EQ(replay.ticks(), edited.duration());
    // A hand that takes what another holds lets it go by itself: that is a command more.
    EXPECT_GE(result.commands.size() + report.skipped.size(), edited.Schedule().size());
  }
}

}  // namespace
}  // namespace smile::editing

#include "editing/edit_previews.h"

#include <stdlib.h>

#include <algorithm>
#include <map>

#include "editing/edit_json.h"
#include "recorder/test/painted_eye.h"
#include "recorder/test/recording_fixture.h"
#include "recording/demo_info.h"

namespace smile::editing {
namespace {

/// Keeps what it saw.
class WitnessEye : public recorder::PaintedEye {
 public:
  explicit WitnessEye(std::vector<sim::ViewSample>* seen) : seen_(seen) {}

  const Image& Draw(const scene::VisualModel& model, const sim::ViewSample& sample) override {
    seen_->push_back(sample);
    return PaintedEye::Draw(model, sample);
  }

 private:
  std::vector<sim::ViewSample>* seen_;
};

class EditPreviewsTest : public recorder::RecordingFixture {
 protected:
  EditPreviewsTest() {
    std::filesystem::create_directories(temporary());
    setenv("TMPDIR", temporary().c_str(), 1);
  }
  ~EditPreviewsTest() override { unsetenv("TMPDIR"); }

  std::filesystem::path temporary() const { return root_ / "temporary"; }
  /// Whether a preview is kept on disk.
  bool is_any_kept() const { return !std::filesystem::is_empty(temporary()); }

  /// How often progress was reported: after each tick that was simulated, each picture drawn.
  recording::Progress Count() {
    num_steps_ = 0;
    return [this](double, double) {
      ++num_steps_;
      return true;
    };
  }

  EditReport Preview(const std::vector<Edit>& edits) {
    return previews_.Preview({root_ / "demo", edits}, Count());
  }
  EditReport Save(const std::vector<Edit>& edits, const char* name) {
    seen_.clear();
    return previews_.Save({root_ / "demo", edits}, root_ / name, Count());
  }
  bool IsSimulatedToSave(const std::vector<Edit>& edits) {
    const auto directory = root_ / "saved";
    const std::uint64_t ticks = Save(edits, "saved").ticks_after;
    std::filesystem::remove_all(directory);
    return num_steps_ >= ticks;
  }

  using Files = std::map<std::string, std::string>;
  static Files FilesIn(const std::filesystem::path& directory) {
    Files files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
      files[entry.path().lexically_relative(directory)] =
          entry.is_directory() ? "" : ReadFile(entry.path(), 1 << 24);
    }
    return files;
  }
  /// Names of files that are not in both, or not the same.
  static std::vector<std::string> DifferencesOf(const Files& one, const Files& other) {
    std::vector<std::pair<std::string, std::string>> different;
    std::ranges::set_symmetric_difference(one, other, std::back_inserter(different));
    std::vector<std::string> names;
    for (const auto& [name, bytes] : different) names.push_back(name);
    return names;
  }

  /// Saves without a preview and of one: the same is written and seen, and only what has to be done
  /// is done.
  void ExpectTheSameEitherWay(const std::vector<Edit>& edits) {
    const EditReport simulated = Save(edits, "simulated");
    const std::uint64_t num_ticks = num_steps_;
    const auto seen = seen_;
    EXPECT_GE(num_ticks, simulated.ticks_after);
    const EditReport preview = Preview(edits);
    EXPECT_EQ(num_steps_, num_ticks);
    const EditReport kept = Save(edits, "kept");
    EXPECT_EQ(num_steps_, seen.size()) << "pictures are drawn, no tick is simulated";
    EXPECT_TRUE(seen_ == seen);
    EXPECT_EQ(DifferencesOf(FilesIn(root_ / "kept"), FilesIn(root_ / "simulated")),
              std::vector<std::string>());
    EXPECT_EQ(ToJson(preview), ToJson(simulated));
    EXPECT_EQ(ToJson(kept), ToJson(simulated));
    EXPECT_FALSE(is_any_kept());
  }

  std::vector<sim::ViewSample> seen_;
  std::uint64_t num_steps_ = 0;
  EditPreviews previews_{
      [this](const sim::EyeSpec&) { return std::make_unique<WitnessEye>(&seen_); }};
};

TEST_F(EditPreviewsTest, SavesWhatAPreviewSimulated) {
  recorder::PaintedEye eye;
  Record(kStackAOnB, false, &eye, kScene, {.title = "stack", .notes = "a on b"});
  ExpectTheSameEitherWay({Drop{0, 0}, Speed{2}});
  EXPECT_GT(seen_.size(), 5u);
}

TEST_F(EditPreviewsTest, SavesWhatAPreviewSimulatedWithoutPictures) {
  Record();
  ExpectTheSameEitherWay({MaxPause{0.25}});
}

TEST_F(EditPreviewsTest, SavesWhatAPreviewSimulatedOfARobot) {
  recorder::PaintedEye eye;
  Record(R"({"do":"joint_velocities","head":0.3}
{"do":"wait","seconds":0.5}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","until":"arrived"})",
         /*with_robot=*/true, &eye, kScene, {.has_symbols = false});
  ExpectTheSameEitherWay({Retime{1, 1}});
}

TEST_F(EditPreviewsTest, SimulatesOtherEdits) {
  Record();
  Preview({Drop{1, 1}});
  EXPECT_TRUE(IsSimulatedToSave({Drop{2, 2}}));
  EXPECT_TRUE(IsSimulatedToSave({Drop{1, 1}, Speed{2}}));
  EXPECT_FALSE(IsSimulatedToSave({Drop{1, 1}}));
  EXPECT_TRUE(IsSimulatedToSave({Drop{1, 1}})) << "it was removed when it was saved";
  Preview({Trim{1, 0, 0.5}});
  Preview({Trim{1, 0, 0.25}});
  EXPECT_TRUE(IsSimulatedToSave({Trim{1, 0, 0.5}})) << "only the newest is kept";
  EXPECT_FALSE(IsSimulatedToSave({Trim{1, 0, 0.25}}));
}

TEST_F(EditPreviewsTest, SimulatesWhatChangedSinceItsPreview) {
  const auto demo = Record();
  Preview({Drop{1, 1}});
  recording::Retitle(demo, std::nullopt, "other notes");
  EXPECT_TRUE(IsSimulatedToSave({Drop{1, 1}}));
  Preview({Drop{1, 1}});
  std::filesystem::rename(demo / "scene.xml", root_ / "scene.xml");
  std::filesystem::copy_file(root_ / "scene.xml", demo / "scene.xml");
  EXPECT_TRUE(IsSimulatedToSave({Drop{1, 1}}));
  std::filesystem::remove(demo / "scene.xml");
  std::filesystem::create_symlink(root_ / "scene.xml", demo / "scene.xml");
  Preview({Drop{1, 1}});
  EXPECT_FALSE(is_any_kept()) << "behind a link all may change";
}

TEST_F(EditPreviewsTest, KeepsOneThatIsNotOld) {
  Record();
  Preview({Drop{1, 1}});
  Preview({Drop{2, 2}});
  const auto folders = std::filesystem::directory_iterator(temporary());
  EXPECT_EQ(std::distance(begin(folders), end(folders)), 1);
  previews_.RemoveOlderThan(std::chrono::hours(1));
  EXPECT_TRUE(is_any_kept());
  previews_.RemoveOlderThan({});
  EXPECT_FALSE(is_any_kept());
  EXPECT_TRUE(IsSimulatedToSave({Drop{2, 2}}));
}

TEST_F(EditPreviewsTest, ACanceledPreviewLeavesNoFiles) {
  recorder::PaintedEye eye;
  Record(kStackAOnB, false, &eye);
  const auto stop = [](double, double) { return false; };
  const EditRequest request{root_ / "demo", {Drop{1, 1}}};
  EXPECT_THROW(previews_.Preview(request, stop), std::runtime_error);
  EXPECT_FALSE(is_any_kept());
  EXPECT_THROW(previews_.Save(request, root_ / "saved", stop), std::runtime_error);
  previews_.Preview(request);
  EXPECT_THROW(previews_.Save(request, root_ / "saved", stop), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(root_ / "saved"));
  EXPECT_FALSE(IsSimulatedToSave(request.edits)) << "the preview is there for another try";
}

TEST_F(EditPreviewsTest, ReportsEvenWithoutSpaceForFiles) {
  Record();
  const Json kept = ToJson(Preview({Drop{1, 1}}));
  setenv("TMPDIR", (root_ / "missing").c_str(), 1);
  EXPECT_EQ(ToJson(Preview({Drop{1, 1}})), kept);
  EXPECT_TRUE(IsSimulatedToSave({Drop{1, 1}}));
}

TEST_F(EditPreviewsTest, SimulatesADeletedPreviewAgain) {
  Record();
  Preview({Drop{1, 1}});
  for (const auto& kept : std::filesystem::directory_iterator(temporary())) {
    std::filesystem::remove_all(kept.path());
  }
  EXPECT_TRUE(IsSimulatedToSave({Drop{1, 1}}));
}

}  // namespace
}  // namespace smile::editing

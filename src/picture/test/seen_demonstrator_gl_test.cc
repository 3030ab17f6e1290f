#include "picture/seen_demonstrator.h"

#include <algorithm>
#include <map>

#include "picture/recording_renderer.h"
#include "recorder/test/recording_fixture.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"

namespace smile::picture {
namespace {

using SeenDemonstratorTest = recorder::RecordingFixture;
using enum DemonstratorAppearance;

constexpr Channels kAll{.rgb = true, .depth = true, .id = true};

TEST_F(SeenDemonstratorTest, ChangesPicturesOnlyWhereHandsAre) {
  const recording::Recording recording = recording::OpenRecording(Record());
  const model::Model& model = *recording.model;
  const SeenDemonstrator ghost(recording, kGhost), person(recording, kForearm);
  const RenderRequest request{.camera = "eye", .width_px = 160, .height_px = 120, .channels = kAll};
  RecordingRenderer plain(model, request), with_ghost(model, request, &ghost),
      with_person(model, request, &person);
  std::size_t num_changed = 0, least_seen = 1000, most_seen = 0, num_ghostly = 0;
  recording::TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    if (moment->tick % 15 != 0) continue;
    const Image without = plain.Take(*moment), pale = with_ghost.Take(*moment),
                with = with_person.Take(*moment);
    EXPECT_EQ(pale.ids, without.ids);
    EXPECT_EQ(pale.depth, without.depth);
    std::size_t num_seen = 0;
    for (std::size_t i = 0; i < with.ids.size(); ++i) {
      const auto color = [i](const Image& image) {
        return std::vector<std::uint8_t>(
            image.color.begin() + static_cast<std::ptrdiff_t>(3 * i),
            image.color.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
      };
      const bool is_hand = with.ids[i] == person.object_id(HandSide::kLeft) ||
                           with.ids[i] == person.object_id(HandSide::kRight);
      num_seen += with.ids[i] == 2;  // block a, after background and table
      if (is_hand) {
        ++num_changed;
        num_ghostly += color(pale) != color(without);
        continue;
      }
      ASSERT_EQ(with.ids[i], without.ids[i]);
      ASSERT_EQ(with.depth[i], without.depth[i]);
      ASSERT_EQ(color(with), color(without));
      ASSERT_EQ(color(pale), color(without));
    }
    least_seen = std::min(least_seen, num_seen);
    most_seen = std::max(most_seen, num_seen);
  }
  EXPECT_GT(num_changed, 1000u);
  EXPECT_GT(num_ghostly, 200u);
  EXPECT_LT(num_ghostly, num_changed);  // a ghost has no arms
  // The hand hides much of what it holds.
  EXPECT_GT(most_seen, 60u);
  EXPECT_LT(least_seen, most_seen * 7 / 10);
}

TEST_F(SeenDemonstratorTest, IsReproducibleFromAnyView) {
  const recording::Recording recording = recording::OpenRecording(Record());
  const model::Model& model = *recording.model;
  const auto moment = recording::MomentAt(recording, 60);
  ASSERT_TRUE(moment);
  for (const DemonstratorAppearance appearance : {kGhost, kForearm}) {
    const SeenDemonstrator one(recording, appearance), other(recording, appearance);
    for (const char* camera : {"eye", "nice"}) {
      const RenderRequest request{.camera = camera, .width_px = 160, .height_px = 120};
      const Image without_demonstrator = RecordingRenderer(model, request).Take(*moment);
      const Image first = RecordingRenderer(model, request, &one).Take(*moment);
      EXPECT_EQ(first.color, RecordingRenderer(model, request, &other).Take(*moment).color);
      EXPECT_NE(first.color, without_demonstrator.color);
    }
  }
}

}  // namespace
}  // namespace smile::picture

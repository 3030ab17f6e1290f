#include "layout/presets.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/solid.h"

namespace smile::layout {
namespace {

scene::Bounds BoundsOfAll(const scene::SceneSpec& scene) {
  scene::Bounds bounds;
  for (const scene::ObjectSpec& object : scene.objects) {
    bounds.Add(scene::BoundsOf(scene::SolidsOf(object.whole), object.pose_in_world()));
  }
  return bounds;
}

TEST(Presets, StandOnFreePlacesOfTheTable) {
  PlacementContext context;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const Preset& preset : Presets()) {
      const auto made = MakePreset(preset.name, context, seed);
      ASSERT_TRUE(made.has_value()) << preset.name;
      const scene::Bounds bounds = BoundsOfAll(*made);
      EXPECT_NEAR(bounds.low.z(), 0, 1e-9) << preset.name;
      EXPECT_LT(bounds.high.x(), context.table.x_span / 2);
      EXPECT_FALSE(made->objects.front().descriptions.empty());
      EXPECT_EQ(MakePreset(preset.name, context, seed), made) << "same seed, same place";
      EXPECT_NE(MakePreset(preset.name, context, seed + 9), made);
    }
    const auto stack = MakePreset("stack_3", context, seed);
    context.taken.push_back(BoundsOfAll(*stack));
    for (const scene::ObjectSpec& object : stack->objects) {
      EXPECT_TRUE(context.ids.insert(object.id()).second) << object.id() << " is new";
    }
    const auto next = MakePreset("stack_3", context, seed);
    ASSERT_TRUE(next.has_value());
    EXPECT_FALSE(BoundsOfAll(*next).Meets(context.taken.back()));
  }
}

TEST(Presets, StandAtAGivenPlace) {
  const Vector3 p_WQ(0.3, -0.2, 0.15);
  for (const Preset& preset : Presets()) {
    const scene::Bounds bounds = BoundsOfAll(MakePreset(preset.name, {}, 1, p_WQ));
    EXPECT_NEAR(bounds.low.z(), p_WQ.z(), 1e-9) << preset.name;
    const Vector3 middle = (bounds.low + bounds.high) / 2;
    EXPECT_LT((middle - p_WQ).head<2>().norm(), 1e-9) << preset.name;
  }
}

TEST(Presets, ReportMissingSpaceAndUnknownPresets) {
  PlacementContext full;
  full.taken = {{.low = {-2, -2, 0}, .high = {2, 2, 1}}};
  EXPECT_EQ(MakePreset("ball", full, 1), std::nullopt);
  try {
    (void)MakePreset("bell", {}, 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"ball\"?"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace smile::layout

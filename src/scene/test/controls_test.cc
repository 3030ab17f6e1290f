#include <gtest/gtest.h>

#include "math/angles.h"
#include "scene/controls_of.h"
#include "scene/visual_model.h"

namespace smile::scene {
namespace {

constexpr double kPlaceTolerance = 1e-15;  // [m]

Part PanelWithAllControls() {
  const Part one{.id = "one", .shape = Block{}}, two{.id = "two", .shape = Box{}};
  const CustomControl dial{
      .name = "dial",
      .initial_state = 1,
      .states = {{"", {one}}, {"both", {one, {.id = "pair", .shape = Composite{{two, one}}}}}},
      .downstream = {"lamps"}};
  const IndicatorLights lamps{
      .num_lights = 3,
      .states = {{"off", {}}, {"two", {{0, Color{1, 0, 0}}, {2, Color{0, 1, 0}}}}}};
  const Part inner{.X_PE = RigidTransform(Vector3(0, 0, 1)),
                   .shape = Composite{{{.id = "dial", .shape = dial}, {.shape = Sphere{}}}}};
  return {.shape = Composite{{{.id = "switch", .shape = ToggleSwitch{.num_states = 4}},
                              inner,
                              {.id = "lamps", .shape = lamps}}}};
}

TEST(Controls, AreCountedInTheOrderOfTheFile) {
  const Part panel = PanelWithAllControls();
  const std::vector<const Part*> controls = ControlsOf(panel);
  ASSERT_EQ(controls.size(), 3u);
  const auto kinds = [&](int i) { return KindOf(*controls[i]); };
  EXPECT_EQ(kinds(0) + " " + kinds(1) + " " + kinds(2), "toggleSwitch dial indicatorLights");
  EXPECT_EQ(NumStatesOf(*controls[0]), 4);
  EXPECT_EQ(NumStatesOf(*controls[1]), 2);
  EXPECT_EQ(InitialStateOf(*controls[1]), 1);
  EXPECT_EQ(DownstreamOf(*controls[1]), std::vector<std::string>{"lamps"});
  EXPECT_THROW(NumStatesOf(panel), std::logic_error);
}

TEST(Controls, CollideAsTheyAreDrawn) {
  const std::vector<Solid> solids = SolidsOf(PanelWithAllControls());
  // The switch's two buttons; of the dial a block, or a block, a box and a block; sphere, lamps.
  EXPECT_EQ(SolidsWith({0, 0, 0}, solids).size(), 2u + 1 + 1 + 3);
  EXPECT_EQ(SolidsWith({1, 1, 1}, solids).size(), 2u + 7 + 1 + 3);
  EXPECT_EQ(solids.size(), NumSolidsOf(PanelWithAllControls()));
  EXPECT_EQ(solids.back().part_id, "lamps");
}

TEST(Visuals, NameTheInnermostPartWithAnId) {
  std::string parts;
  for (const Visual& visual : VisualsOf(PanelWithAllControls())) {
    if (!parts.ends_with(visual.part_id + " ")) parts += visual.part_id + " ";
  }
  // The switch and the dial have two variants each. The sphere has no id, nor has what is around
  // it.
  EXPECT_EQ(parts, "switch one two one lamps ");
}

TEST(Controls, ShowOnlyTheLightsThatAreOnAndThoseGlow) {
  int num_lights_in[2] = {0, 0};
  for (const Visual& visual : VisualsOf(PanelWithAllControls())) {
    EXPECT_EQ(visual.glows, visual.choice == 2) << "of choice " << visual.choice;
    if (visual.choice == 2) ++num_lights_in[visual.variant];
  }
  EXPECT_EQ(num_lights_in[0], 0);
  EXPECT_EQ(num_lights_in[1], 2);
}

TEST(Visuals, NameTheButtonOfASwitch) {
  std::string buttons;
  for (const Visual& visual : VisualsOf(PanelWithAllControls())) {
    EXPECT_EQ(visual.button.has_value(), visual.part_id == "switch");
    if (visual.button) buttons += ButtonId(visual.part_id, *visual.button) + " ";
  }
  EXPECT_EQ(buttons, "switch-b1 switch-b2 switch-b1 switch-b2 ") << "in each of the two positions";
}

TEST(Solids, AreAsManyAsTheyAreSaidToBe) {
  for (const Shape& shape :
       std::vector<Shape>{Block{}, Box{}, Sphere{}, Frustum{}, Ring{}, Ring{.sides = 200},
                          Ring{.radius_inner = 0}, Composite{{{.shape = Box{}}, {.shape = Ring{}}}},
                          Composite{}, ToggleSwitch{}, IndicatorLights{.num_lights = 7}}) {
    const Part part{.shape = shape};
    EXPECT_EQ(NumSolidsOf(part), SolidsOf(part).size());
  }
}

TEST(ToggleSwitch, HasOneButtonFlatAndOneRaised) {
  const double angle = DegreesToRadians(20);
  const ToggleSwitch toggle{.size = {0.17, 0.1, 0.05}, .angle = angle};
  const std::vector<Solid> solids = SolidsOf(Part{.id = "S", .shape = toggle});
  ASSERT_EQ(solids.size(), 4u);
  const double w = 0.17 / (1 + std::cos(angle)), h = 0.05;
  const double x = (w * std::cos(angle) - h * std::sin(angle)) / 2;
  const double z = (h * std::cos(angle) + w * std::sin(angle)) / 2;
  const auto expect = [&](int i, Button button, int position, const Vector3& p, double turned) {
    EXPECT_EQ(solids[i].part_id, "S");
    EXPECT_EQ(solids[i].button, button);
    EXPECT_EQ(solids[i].variant, position);
    EXPECT_LT((std::get<Block>(solids[i].shape).size - Vector3(w, 0.1, h)).norm(), kPlaceTolerance);
    EXPECT_LT((solids[i].X_BS.translation() - p).norm(), kPlaceTolerance);
    EXPECT_LT((solids[i].X_BS.rotation() - RotationFromFixedAxes({0, RadiansToDegrees(turned), 0}))
                  .norm(),
              1e-12);
  };
  expect(0, Button::kLeft, 0, {-w / 2, 0, h / 2}, 0);
  expect(1, Button::kRight, 0, {x, 0, z}, -angle);
  expect(2, Button::kLeft, 1, {-x, 0, z}, angle);
  expect(3, Button::kRight, 1, {w / 2, 0, h / 2}, 0);
}

TEST(IndicatorLights, StandInARowFromTheLeft) {
  const IndicatorLights lights{
      .light_radius = 0.07, .light_height = 0.002, .num_lights = 3, .x_span = 0.45};
  const std::vector<Solid> solids = SolidsOf(Part{.shape = lights});
  ASSERT_EQ(solids.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(std::get<Cylinder>(solids[i].shape).radius, 0.07);
    const Vector3 p(-0.225 + 0.07 + i * 0.31 / 2, 0, 0.001);
    EXPECT_LT((solids[i].X_BS.translation() - p).norm(), kPlaceTolerance);
    EXPECT_EQ(solids[i].X_BS.rotation().col(1), Vector3::UnitZ()) << "a cylinder's axis is y";
  }
  const std::vector<Solid> one = SolidsOf(Part{.shape = IndicatorLights{.num_lights = 1}});
  EXPECT_EQ(one.at(0).X_BS.translation(), Vector3(0, 0, 0.00025));
}

}  // namespace
}  // namespace smile::scene

#include "model/model.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/files.h"
#include "math/angles.h"
#include "model/eye.h"

namespace smile::model {
namespace {

static_assert(!std::is_convertible_v<std::size_t, ObjectIndex>, "made on purpose only");
static_assert(!std::is_constructible_v<ControlIndex, ObjectIndex>, "never taken for each other");
static_assert(std::is_convertible_v<ObjectIndex, std::size_t>, "indexes a list");
static_assert(!std::is_copy_constructible_v<Model> && !std::is_move_constructible_v<Model>);

scene::ObjectSpec ObjectWith(const std::string& id, scene::Shape shape, const Vector3& p_WB,
                             double mass = 1) {
  return {.whole = {.id = id, .X_PE = RigidTransform(p_WB), .shape = std::move(shape)},
          .mass = mass};
}

/// A lamp on a panel beside a switch that drives it.
scene::ObjectSpec Panel() {
  scene::IndicatorLights lamp{.initial_state = 1};
  lamp.states = {{.name = "off", .lights = {}}, {.name = "on", .lights = {{0, {0, 1, 0}}}}};
  scene::Composite panel;
  panel.parts = {{.id = "board", .X_PE = {}, .shape = scene::Block{}},
                 {.id = "power", .X_PE = {}, .shape = scene::ToggleSwitch{.downstream = {"lamp"}}},
                 {.id = "lamp", .X_PE = {}, .shape = lamp}};
  return ObjectWith("panel", panel, {0, 0.3, 0.05});
}

/// A hole whose first stage is 10 cm above it, and turned; it sets a lamp and locks another hole.
scene::ObjectSpec Nut() {
  scene::Composite nut;
  nut.parts = {{.X_PE = {}, .shape = scene::Ring{}}};
  nut.hosts = {{.id = "hole",
                .type = "m8",
                .X_PH = {},
                .downstream = "lamp",
                .downstream_lock = "spare_hole",
                .stages = {{.X_HS = {RotationFromFixedAxes({0, 0, 90}), Vector3(0, 0, 0.1)},
                            .locks_downstream = true}}},
               {.id = "spare_hole", .type = "m8", .X_PH = {}, .stages = {{.X_HS = {}}}}};
  return ObjectWith("nut", nut, {0.5, 0, 0.05}, /*mass=*/0);
}

scene::ObjectSpec Screw(const std::string& host) {
  scene::Composite screw;
  screw.parts = {{.X_PE = {}, .shape = scene::Block{}}};
  screw.guests = {{.id = "tip",
                   .type = "m8",
                   .X_PG = RigidTransform(Vector3(0, 0, -0.05)),
                   .initial_host = host,
                   .initial_tightness = host.empty() ? 0 : 1}};
  return ObjectWith("screw", screw, {0, 0, 0.05});
}

scene::SceneSpec Workbench(const std::string& host = "") {
  return {.name = "workbench",
          .objects = {ObjectWith("block", scene::Block{}, {-0.5, 0, 0.05}), Panel(), Nut(),
                      Screw(host)}};
}

RobotPlacement Baxter() { return {.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))}; }

TEST(Model, FindsWhatHasANameAndWhatItBelongsTo) {
  const Model model(Workbench());
  EXPECT_EQ(model.objects().size(), 4u);
  EXPECT_EQ(model.id(*model.FindObject("nut")), "nut");
  EXPECT_EQ(model.FindObject("hole"), std::nullopt);
  const ControlIndex lamp = *model.FindControl("lamp");
  EXPECT_EQ(model.control(lamp).object, model.FindObject("panel"));
  EXPECT_EQ(model.control(*model.FindControl("power")).downstream, std::vector{lamp});
  EXPECT_TRUE(model.controls_of(*model.FindObject("panel")).contains(lamp));
  EXPECT_EQ(model.controls_of(*model.FindObject("nut")).size(), 0u);
  const Host& hole = model.host(*model.FindHost("hole"));
  EXPECT_EQ(hole.object, model.FindObject("nut"));
  EXPECT_EQ(hole.downstream, lamp);
  EXPECT_EQ(hole.downstream_override, std::nullopt);
  EXPECT_EQ(hole.downstream_lock, model.FindHost("spare_hole"));
  EXPECT_EQ(model.guest(*model.FindGuest("tip")).object, model.FindObject("screw"));
}

TEST(Model, LaysOutFramesAsItsVisualsHaveThem) {
  const Model model(Workbench(), Baxter());
  const scene::VisualModel& visual_model = model.visual_model();
  for (const scene::Visual& visual : visual_model.visuals) {
    const FrameIndex frame(static_cast<std::size_t>(visual.frame));
    const std::string& name = visual_model.object_names[visual.object_id];
    if (const auto object = model.object_of(frame)) {
      EXPECT_EQ(name, model.id(*object));
      EXPECT_EQ(model.frame_of(*object), frame);
    } else {
      EXPECT_EQ(name, model.robot_frames().contains(frame) ? "robot" : "table");
    }
  }
  const std::size_t num_links = model.robot()->links.size();
  EXPECT_EQ(model.robot_frames().size(), 1 + num_links);
  EXPECT_EQ(static_cast<std::size_t>(visual_model.num_frames),
            std::size_t{model.frame_of(LinkIndex(num_links - 1))} + 1);
  EXPECT_EQ(model.frame_of(robot::Frame{.link = -1}), *model.robot_frames().begin());
  EXPECT_EQ(Model(Workbench()).robot_frames().size(), 0u);
}

TEST(Model, LaysOutChoicesAsItsVisualsHaveThem) {
  const Model model(Workbench(), Baxter());
  for (const scene::Visual& visual : model.visual_model().visuals) {
    if (visual.choice < 0) continue;
    const ChoiceIndex choice(static_cast<std::size_t>(visual.choice));
    const auto object = model.object_of(FrameIndex(static_cast<std::size_t>(visual.frame)));
    if (visual.part_id == "lamp") {
      EXPECT_EQ(choice, model.choice_of(*model.FindControl("lamp")));
    } else if (visual.part_id == "power") {
      EXPECT_EQ(choice, model.choice_of(*model.FindControl("power")));
    } else if (object) {
      EXPECT_EQ(choice, model.presence_of(*object)) << visual.part_id;
    } else {
      EXPECT_EQ(visual.choice, model.visual_model().num_choices - 1)
          << "the robot's face expression";
    }
  }
}

TEST(Model, ShowsAMomentWithoutPhysics) {
  const Model model(Workbench(), Baxter());
  SceneState state = model.initial_state();
  const ObjectIndex panel = *model.FindObject("panel"), block = *model.FindObject("block");
  state.X_WB[block] = RigidTransform(Vector3(1, 2, 3));
  state.controls[*model.FindControl("lamp")].state = 1;
  const auto& q = model.robot()->q_start;
  const scene::VisualState shown = model.VisualStateOf(state, q, robot::FaceExpression::kWorking);
  EXPECT_EQ(shown.poses.size(), static_cast<std::size_t>(model.visual_model().num_frames));
  EXPECT_EQ(shown.variants.size(), static_cast<std::size_t>(model.visual_model().num_choices));
  EXPECT_EQ(shown.poses[model.frame_of(block)], *state.X_WB[block]);
  EXPECT_EQ(shown.poses[*model.robot_frames().begin()], model.robot_base_pose());
  EXPECT_EQ(shown.variants[model.presence_of(panel)], 0);
  EXPECT_EQ(shown.variants[model.choice_of(*model.FindControl("lamp"))], 1);
  state.X_WB[panel].reset();
  const scene::VisualState without = model.VisualStateOf(state, q, robot::FaceExpression::kWorking);
  EXPECT_EQ(without.variants[model.presence_of(panel)], -1);
  EXPECT_EQ(without.variants[model.choice_of(*model.FindControl("lamp"))], -1);
}

TEST(Model, BeginsWithWhatIsFastenedFromTheStart) {
  const Model loose(Workbench()), fastened(Workbench("hole"));
  const ControlIndex lamp = *loose.FindControl("lamp");
  const HostIndex hole = *loose.FindHost("hole"), spare = *loose.FindHost("spare_hole");
  const ObjectIndex screw = *loose.FindObject("screw");
  EXPECT_EQ(loose.initial_state().controls[lamp].state, 0) << "its switch drives it";
  EXPECT_EQ(loose.initial_state().hosts[hole], HostState());
  EXPECT_EQ(loose.initial_state().X_WB[screw]->translation(), Vector3(0, 0, 0.05));
  const SceneState& start = fastened.initial_state();
  EXPECT_EQ(start.controls[lamp].state, 1) << "its hole sets it";
  EXPECT_EQ(start.hosts[hole].guest, loose.FindGuest("tip"));
  EXPECT_EQ(start.hosts[hole].tightness, 1);
  EXPECT_TRUE(start.hosts[spare].is_locked);
  EXPECT_LT((start.X_WB[screw]->translation() - Vector3(0.5, 0, 0.2)).norm(), 1e-12);
  EXPECT_LT((start.X_WB[screw]->rotation() - RotationFromFixedAxes({0, 0, 90})).norm(), 1e-12);
}

TEST(Model, MovesWhatIsJoinedWithWhatIsFastened) {
  scene::SceneSpec scene = Workbench("hole");
  const std::size_t screw = scene.objects.size() - 1;
  scene.objects.push_back(ObjectWith("ring", scene::Block{}, {0, 0, 0.3}));
  scene.sliders = {{.first_object = screw}};
  const Model model(std::move(scene));
  // 15 cm higher, and turned about where the screw was.
  const RigidTransform X_WRing = *model.initial_state().X_WB[*model.FindObject("ring")];
  EXPECT_LT((X_WRing.translation() - Vector3(0.5, 0, 0.45)).norm(), 1e-12);
  EXPECT_EQ(model.initial_state().X_WB[*model.FindObject("block")]->translation(),
            Vector3(-0.5, 0, 0.05));
}

TEST(Model, IsSharedByThreadsAndLivesAsLongAsOneOfThemNeedsIt) {
  auto model = std::make_shared<const Model>(Workbench(), Baxter());
  const std::weak_ptr<const Model> watched = model;
  std::size_t num_names = 0;
  std::thread reader([shared = model, &num_names] {
    const EyeSpec eye{.camera = kEyeCamera};
    (void)EyeView(*shared, shared->robot()->q_start, eye);
    num_names = CameraNames(*shared).size();
  });
  model.reset();
  reader.join();
  EXPECT_EQ(num_names, 4u);
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace smile::model

#include "world/tabletop.h"

#include <gtest/gtest.h>

#include <memory>

#include "math/angles.h"

namespace smile::world {
namespace {

scene::SceneSpec SceneWith(std::vector<scene::ObjectSpec> objects) {
  return {.name = "test", .objects = std::move(objects)};
}

scene::ObjectSpec BlockAt(std::string id, const Vector3& p_WB, double mass = 1) {
  return {.whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = scene::Block{}},
          .mass = mass};
}

TEST(Tabletop, ObjectsComeToRestOnTheTable) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("b", {0.3, 0.2, 0.1})}));
  for (int i = 0; i < 960; ++i) world.Step();
  const RigidTransform X_WB = world.body(tabletop.Find("b")->body).pose_in_world();
  EXPECT_NEAR(X_WB.translation().z(), 0.05, 1e-4);
}

TEST(Tabletop, TheFloorCatchesWhatLeavesTheTable) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("b", {1.5, 0, 0.1})}));
  for (int i = 0; i < 1440; ++i) world.Step();
  EXPECT_NEAR(world.body(tabletop.Find("b")->body).pose_in_world().translation().z(),
              -kFloorDepth + 0.05, 1e-3);
}

TEST(Tabletop, AppendsObjectsAndRemovesThemAgain) {
  physics::World world;
  const auto small = std::make_shared<const model::Model>(SceneWith({BlockAt("a", {0, 0, 0.3})}));
  Tabletop tabletop(&world, small);
  for (int i = 0; i < 30; ++i) world.Step();
  const mechanics::Snapshot before = world.Save();
  const TabletopState state = tabletop.state();
  const physics::BodyId a = tabletop.Find("a")->body;
  const Vector3 velocity = world.body(a).linear_velocity();
  tabletop.Grow(std::make_shared<const model::Model>(
      *small, SceneWith({BlockAt("a", {0, 0, 0.3}), BlockAt("b", {0.5, 0, 0.3})})));
  EXPECT_EQ(tabletop.Find("a")->body, a);
  EXPECT_EQ(world.body(a).linear_velocity(), velocity);
  EXPECT_EQ(tabletop.state().bodies.size(), 2u);
  EXPECT_GT(tabletop.Find("b")->body, a);
  for (int i = 0; i < 30; ++i) world.Step();
  EXPECT_LT(world.body(tabletop.Find("b")->body).pose_in_world().translation().z(), 0.299);
  world.Restore(before);
  tabletop.Restore(state, small);
  EXPECT_EQ(tabletop.Find("b"), nullptr);
  EXPECT_EQ(tabletop.state(), state);
  EXPECT_EQ(tabletop.objects().size(), 1u);
}

/// Returns the ids of the objects that fell to the floor within some steps.
std::vector<std::string> FallenWithin(int steps, physics::World* world, Tabletop* tabletop) {
  std::vector<std::string> ids;
  for (int i = 0; i < steps; ++i) {
    world->Step();
    for (const Object* object : tabletop->NoticeFallen()) ids.push_back(object->id());
  }
  return ids;
}

TEST(Tabletop, NoticesOnceWhatFellToTheFloor) {
  physics::World world;
  scene::ObjectSpec ball = BlockAt("ball", {1.4, 0.5, 0.1});
  ball.whole.shape = scene::Sphere{0.05};
  ball.surface.restitution = 1;
  Tabletop tabletop(
      &world, SceneWith({BlockAt("stays", {0, 0, 0.05}), BlockAt("falls", {1.5, 0, 0.1}), ball,
                         BlockAt("fixed", {-1.5, 0, -0.85}, /*mass=*/0),
                         BlockAt("stands_there", {-1.5, 0.5, -0.848}),
                         BlockAt("comes_down", {1.5, -0.5, -0.6})}));
  EXPECT_EQ(FallenWithin(2400, &world, &tabletop),
            (std::vector<std::string>{"comes_down", "falls", "ball"}));
  EXPECT_TRUE(tabletop.HasFallen(*tabletop.Find("falls")));
  EXPECT_EQ(tabletop.RefuseToReach("falls"), "'falls' fell to the floor; undo restores it");
  EXPECT_EQ(tabletop.RefuseToReach("stands_there"), std::nullopt);
}

TEST(Tabletop, HeldObjectsAndThoseAttachedToThemHaveNotFallen) {
  physics::World world;
  const scene::SceneSpec scene =
      SceneWith({BlockAt("held", {1.5, 0, -0.5}), BlockAt("low", {1.5, 0, -0.7})});
  Tabletop tabletop(&world, scene);
  const physics::BodyId held = tabletop.objects()[0].body, low = tabletop.objects()[1].body;
  world.AddJoint(
      physics::FixedJointSpec{.a = held, .b = low, .X_AB = RigidTransform(Vector3(0, 0, -0.2))});
  world.body(held).SetCarried(true);
  for (int i = 0; i < 240; ++i) {
    world.body(held).SetVelocity({0, 0, -0.5}, {0, 0, 0});
    world.Step();
  }
  EXPECT_EQ(world.BodiesTouching(low).size(), 1u);
  EXPECT_EQ(FallenWithin(1, &world, &tabletop), std::vector<std::string>{});
  world.body(held).SetCarried(false);
  EXPECT_EQ(FallenWithin(1, &world, &tabletop), std::vector<std::string>{"low"});
}

TEST(Tabletop, AnObjectOfTheFloorCanFallAfterItWasLifted) {
  physics::World world;
  Tabletop tabletop(&world, SceneWith({BlockAt("b", {1.5, 0, -0.85})}));
  physics::Body& body = world.body(tabletop.Find("b")->body);
  body.SetCarried(true);
  body.SetPose(RigidTransform(Vector3(1.5, 0, 0.2)));
  EXPECT_EQ(FallenWithin(1, &world, &tabletop), std::vector<std::string>{});
  body.SetCarried(false);
  EXPECT_EQ(FallenWithin(480, &world, &tabletop), std::vector<std::string>{"b"});
}

TEST(Tabletop, ReportsWhyAnObjectCannotBeReached) {
  physics::World world;
  scene::Composite tray;
  tray.parts = {{.id = "rim", .X_PE = {}, .shape = scene::Block{}}};
  scene::ObjectSpec whole = BlockAt("tray", {0.5, 0, 0.05});
  whole.whole.shape = tray;
  Tabletop tabletop(&world, SceneWith({BlockAt("b01", {0, 0, 0.05}), whole}));
  EXPECT_EQ(tabletop.RefuseToReach("b01"), std::nullopt);
  EXPECT_EQ(tabletop.RefuseToReach("b1"), "there is no object 'b1'; did you mean \"b01\"?");
  EXPECT_EQ(tabletop.RefuseToReach("rim"),
            "'rim' is a part of 'tray', which is handled as a whole");
  tabletop.Destroy(*tabletop.Find("b01"));
  EXPECT_EQ(tabletop.RefuseToReach("b01"), "'b01' no longer exists: it was destroyed");
}

TEST(Tabletop, AStaticObjectStaysInTheAir) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("shelf", {0, 0, 0.5}, /*mass=*/0)}));
  for (int i = 0; i < 480; ++i) world.Step();
  EXPECT_EQ(world.body(tabletop.Find("shelf")->body).pose_in_world().translation().z(), 0.5);
}

TEST(Tabletop, ABallWhoseMassIsBelowItsMiddleStandsUp) {
  physics::World world;
  scene::ObjectSpec ball = BlockAt("ball", {0, 0, 0.05});
  ball.whole.shape = scene::Sphere{0.05};
  ball.whole.X_PE = {RotationFromFixedAxes({60, 0, 0}), Vector3(0, 0, 0.05)};
  ball.center_of_mass = {0, 0, -0.03};
  const Tabletop tabletop(&world, SceneWith({ball}));
  physics::Body& body = world.body(tabletop.Find("ball")->body);
  EXPECT_TRUE(body.pose_in_world().translation().isApprox(Vector3(0, 0, 0.05)))
      << "its origin is where the scene says";
  for (int i = 0; i < 4800; ++i) world.Step();
  EXPECT_GT(body.pose_in_world().rotation()(2, 2), 0.99) << "its own z points up";
  body.SetVelocity({0.1, 0.2, 0.3}, {1, 2, 3});
  EXPECT_TRUE(body.linear_velocity().isApprox(Vector3(0.1, 0.2, 0.3))) << "of the origin";
}

/// Returns the position of an object after some seconds; `push` is its velocity at the start [m/s].
Vector3 PlaceAfter(double seconds, const scene::ObjectSpec& object, const Vector3& push,
                   const Vector3& spin = Vector3::Zero()) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({object}));
  physics::Body& body = world.body(tabletop.Find(object.id())->body);
  body.SetVelocity(push, spin);
  for (int i = 0; i < seconds * 480; ++i) world.Step();
  return body.pose_in_world().translation();
}

TEST(Tabletop, FrictionDeterminesHowFarABlockSlides) {
  scene::ObjectSpec block = BlockAt("b", {-0.5, 0, 0.05});
  const auto slides = [&] { return PlaceAfter(1, block, {1, 0, 0}).x() + 0.5; };
  // v2 / (2 mu g) with the product of 0.6 and the table's 0.6.
  EXPECT_NEAR(slides(), 1 / (2 * 0.36 * 9.81), 0.01);
  block.surface.friction = 0.05;
  EXPECT_GT(slides(), 0.6);
  block.surface.friction = 1;
  EXPECT_NEAR(slides(), 1 / (2 * 0.6 * 9.81), 0.01);
}

TEST(Tabletop, RestitutionDeterminesHowHighABallBounces) {
  scene::ObjectSpec ball = BlockAt("b", {0, 0, 0.55});
  ball.whole.shape = scene::Sphere{0.05};
  // It falls 0.5 m in 0.32 s; 0.8 of the speed takes it up 0.32 m within 0.26 s more.
  const auto bounces_to = [&] { return PlaceAfter(0.58, ball, Vector3::Zero()).z() - 0.05; };
  EXPECT_NEAR(bounces_to(), 0, 0.005);
  ball.surface.restitution = 0.8;
  EXPECT_NEAR(bounces_to(), 0.32, 0.05);
}

TEST(Tabletop, RollingFrictionDeterminesHowFarABallRolls) {
  scene::ObjectSpec ball = BlockAt("b", {-0.8, 0, 0.05});
  ball.whole.shape = scene::Sphere{0.05};
  const auto rolls = [&] { return PlaceAfter(3, ball, {0.5, 0, 0}, {0, 10, 0}).x() + 0.8; };
  const double as_ever = rolls();
  ball.surface.rolling_friction = 0.001;
  EXPECT_EQ(rolls(), as_ever);
  ball.surface.rolling_friction = 0.01;
  EXPECT_LT(rolls(), 0.6 * as_ever);
  ball.surface.rolling_friction = 0;
  EXPECT_GT(rolls(), 1.05 * as_ever);
}

TEST(Tabletop, ContainsOnlyItsOwnObjects) {
  physics::World world;
  const Tabletop tabletop(&world, SceneWith({BlockAt("a", {0, 0, 1})}));
  EXPECT_EQ(tabletop.Find("a")->index, model::ObjectIndex(0));
  EXPECT_EQ(tabletop.Find("c"), nullptr);
}

}  // namespace
}  // namespace smile::world

// A screw in a hole of its own radius: once it is loosened, a straight pull draws it out.

#include "math/angles.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

constexpr double kHoleRadius = 0.03;         // [m]
constexpr double kPlateThickness = 0.06;     // [m]
constexpr double kArrivalTolerance = 0.002;  // [m]
const Vector3 kPlateCenter(0, 0, 0.3);

/// A fixed plate with a hole along its z axis and a single stage, the screw's head on the plate.
scene::ObjectSpec Plate(const RigidTransform& X_WPlate) {
  scene::Composite plate;
  plate.parts = {{.shape = scene::Ring{0.1, kHoleRadius, kPlateThickness, 32}}};
  plate.hosts = {{.id = "hole", .type = "m6", .X_PH = {}, .stages = {{.X_HS = {}}}}};
  return {.whole = {.id = "plate", .X_PE = X_WPlate, .shape = plate}, .mass = 0};
}

/// A shaft that ends a little below the plate's lower side, and a head that lies on its upper one.
scene::ObjectSpec Screw(double shaft_radius) {
  const Matrix3 R_PE = RotationFromFixedAxes({90, 0, 0});           // along z
  constexpr double kHead = 0.02, kLength = kPlateThickness + 0.01;  // [m]
  scene::Composite screw;
  screw.parts = {{.X_PE = {R_PE, Vector3(0, 0, kPlateThickness / 2 - kLength / 2)},
                  .shape = scene::Cylinder{shaft_radius, kLength}},
                 {.X_PE = {R_PE, Vector3(0, 0, kPlateThickness / 2 + kHead / 2)},
                  .shape = scene::Cylinder{0.05, kHead}}};
  screw.guests = {
      {.id = "tip", .type = "m6", .X_PG = {}, .initial_host = "hole", .initial_tightness = 1}};
  return {.whole = {.id = "screw", .X_PE = RigidTransform(Vector3(0, 0, 1)), .shape = screw},
          .mass = 0.2};
}

/// Orientation of the hole: the plate's angles about fixed axes [degrees].
class CloseFit : public SimulationFixture,
                 public ::testing::WithParamInterface<std::tuple<double, double>> {
 protected:
  CloseFit()
      : X_WPlate_(RotationFromFixedAxes({std::get<1>(GetParam()), 0, 0}), kPlateCenter),
        simulation_(std::make_unique<Simulation>(Scene())) {}

  scene::SceneSpec Scene() const {
    return {.name = "close fit", .objects = {Plate(X_WPlate_), Screw(std::get<0>(GetParam()))}};
  }
  std::string Do(const Command& command) { return simulation_->Apply(command).value_or(""); }
  void Loosen() {
    ASSERT_LT((PositionOf(*simulation_, "screw") - kPlateCenter).norm(), 1e-6);
    ASSERT_EQ(Do(Grasp{.hand = HandName::kRight, .object = "screw"}), "");
    TickSeconds(*simulation_, 0.3);
    ASSERT_EQ(Do(sim::Loosen{.hand = HandName::kRight, .object = "screw"}), "");
    TickSeconds(*simulation_, 0.6);
  }
  void PullOut() {
    ASSERT_EQ(Do(MoveTo{.hand = HandName::kRight, .p_WH = Goal(), .speed = 0.3}), "");
  }
  Vector3 Goal() const { return X_WPlate_ * Vector3(0, 0, 0.2); }
  double DistanceToGoal() const { return (PositionOf(*simulation_, "screw") - Goal()).norm(); }

  RigidTransform X_WPlate_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_P(CloseFit, IsPulledStraightOut) {
  Loosen();
  PullOut();
  TickSeconds(*simulation_, 5);
  EXPECT_LT(DistanceToGoal(), kArrivalTolerance);
}

TEST_P(CloseFit, CollidesAgainOnceItIsOut) {
  Loosen();
  PullOut();
  TickSeconds(*simulation_, 5);
  const Vector3 p_WBeside = X_WPlate_ * Vector3(0.06, 0, 0.2),
                p_WInside = X_WPlate_ * Vector3(0.06, 0, 0);
  ASSERT_EQ(Do(MoveTo{.hand = HandName::kRight, .p_WH = p_WBeside, .speed = 0.3}), "");
  TickSeconds(*simulation_, 2);
  ASSERT_EQ(Do(MoveTo{.hand = HandName::kRight, .p_WH = p_WInside, .speed = 0.3}), "");
  TickSeconds(*simulation_, 3);
  EXPECT_GT((PositionOf(*simulation_, "screw") - p_WInside).norm(), kPlateThickness / 2);
}

TEST_P(CloseFit, ContinuesExactlyFromASavedState) {
  Loosen();
  PullOut();
  TickSeconds(*simulation_, 0.1);
  const SimulationState saved = simulation_->Save();
  TickSeconds(*simulation_, 1);
  const std::uint64_t hash = simulation_->state_hash();
  simulation_->Restore(saved);
  TickSeconds(*simulation_, 1);
  EXPECT_EQ(simulation_->state_hash(), hash) << "in place";
  Simulation fresh(Scene());
  fresh.Restore(saved);
  TickSeconds(fresh, 1);
  EXPECT_EQ(fresh.state_hash(), hash) << "in a fresh simulation";
}

TEST_P(CloseFit, JamsInRecordingsOfTheFirstPhysicsVersion) {
  scene::SceneSpec scene = Scene();
  scene.physics_version = 1;
  simulation_ = std::make_unique<Simulation>(scene);
  Loosen();
  PullOut();
  TickSeconds(*simulation_, 5);
  const bool has_room = std::get<0>(GetParam()) < kHoleRadius - 0.0005;
  EXPECT_EQ(DistanceToGoal() < kArrivalTolerance, has_room);
}

TEST_P(CloseFit, RestsInItsHoleWhenNoHandHoldsIt) {
  ASSERT_EQ(Do(sim::Loosen{.hand = HandName::kRight, .object = "screw"}), "");
  TickSeconds(*simulation_, 3);
  EXPECT_LT((PositionOf(*simulation_, "screw") - kPlateCenter).norm(), kArrivalTolerance);
  EXPECT_TRUE(simulation_->is_still());
}

INSTANTIATE_TEST_SUITE_P(ShaftAndAxis, CloseFit,
                         ::testing::Combine(::testing::Values(0.029, 0.0299, 0.030, 0.0303),
                                            ::testing::Values(0.0, 90.0, 35.0)));

}  // namespace
}  // namespace smile::sim

// Joints between bodies: their stiffness, and the parameters of sliders.

#include <cmath>
#include <numbers>

#include "physics_fixture.h"

namespace smile::physics {
namespace {

/// Config without damping, so that speeds can be compared.
constexpr WorldConfig kVacuum{.damping = 0};

class JointTest : public ::testing::Test {
 protected:
  BodyId Add(const Vector3& p_WB, double mass, double side = 0.1) {
    return world_.AddBody(
        PhysicsWorldBuilder::BlockSpec(Vector3::Constant(side), RigidTransform(p_WB), mass));
  }
  RigidTransform Pose(BodyId id) const { return world_.body(id).pose_in_world(); }
  Vector3 Place(BodyId id) const { return Pose(id).translation(); }
  RigidTransform Between(BodyId a, BodyId b) const { return Pose(a).inverse() * Pose(b); }
  JointId Fix(BodyId a, BodyId b) {
    return world_.AddJoint(FixedJointSpec{.a = a, .b = b, .X_AB = Between(a, b)});
  }
  /// Returns a rail along `axis` of the world on which B can move from its present position.
  SliderJointSpec RailFrom(BodyId a, BodyId b, const Vector3& axis, double lower, double upper) {
    const Quaternion q_WJ = Quaternion::FromTwoVectors(Vector3::UnitX(), axis);
    const RigidTransform X_WJ(q_WJ, Place(b));
    return {.a = a,
            .b = b,
            .X_AJ = Pose(a).inverse() * X_WJ,
            .X_BK = Pose(b).inverse() * X_WJ,
            .lower = lower,
            .upper = upper};
  }
  void StepSeconds(double seconds, World* world = nullptr) {
    if (world == nullptr) world = &world_;
    const auto steps = std::lround(seconds / world->config().step_seconds);
    for (long i = 0; i < steps; ++i) world->Step();
  }

  World world_{kVacuum};
};

TEST_F(JointTest, AFixedRowHeldAtOneEndDoesNotSag) {
  // A static post, 1 kg fixed to it, 10 kg at its end, 1 kg at the end of that.
  const BodyId post = Add({0, 0, 1}, 0);
  const BodyId near = Add({0.1, 0, 1}, 1), heavy = Add({0.2, 0, 1}, 10), far = Add({0.3, 0, 1}, 1);
  Fix(post, near);
  Fix(near, heavy);
  Fix(heavy, far);
  StepSeconds(5);
  for (BodyId id : {near, heavy, far}) EXPECT_NEAR(Place(id).z(), 1, 1e-6);
}

TEST_F(JointTest, ASliderHeldAtOneEndSlidesAndDoesNotSag) {
  const BodyId post = Add({0, 0, 1}, 0), carriage = Add({0.1, 0, 1}, 1),
               load = Add({0.2, 0, 1}, 10);
  world_.AddJoint(RailFrom(post, carriage, Vector3::UnitY(), -0.5, 0.5));
  Fix(carriage, load);
  for (BodyId id : {carriage, load}) world_.body(id).SetVelocity({0, 0.2, 0}, {0, 0, 0});
  StepSeconds(2);
  EXPECT_NEAR(Place(carriage).y(), 0.4, 1e-6);
  EXPECT_NEAR(Place(load).z(), 1, 1e-6);
  EXPECT_NEAR(Place(load).x(), 0.2, 1e-6);
}

TEST_F(JointTest, AChainBetweenTwoPostsSettles) {
  World world;
  PhysicsWorldBuilder builder;
  // 21 joints 0.1 m apart, in a V between posts 1.6 m apart.
  const double x_step = 1.6 / 20, z_step = std::sqrt(0.1 * 0.1 - x_step * x_step);
  Vector3 end(0, 0, 2);
  BodyId last = world.AddBody(builder.BlockSpec({0.05, 0.05, 0.05}, RigidTransform(end), 0));
  std::vector<BodyId> links;
  const auto hang = [&](BodyId next) {
    world.AddJoint(BallJointSpec{.a = last,
                                 .b = next,
                                 .p_AQ = world.body(last).pose_in_world().inverse() * end,
                                 .p_BQ = world.body(next).pose_in_world().inverse() * end});
    last = next;
  };
  for (int i = 0; i < 20; ++i) {
    const Vector3 next = end + Vector3(x_step, 0, i < 10 ? -z_step : z_step);
    const Matrix3 R(Quaternion::FromTwoVectors(Vector3::UnitX(), Vector3(next - end)));
    links.push_back(world.AddBody(
        builder.BlockSpec({0.09, 0.02, 0.02}, RigidTransform(R, Vector3((end + next) / 2)), 1)));
    hang(links.back());
    end = next;
  }
  hang(world.AddBody(builder.BlockSpec({0.05, 0.05, 0.05}, RigidTransform(end), 0)));
  const auto widest_gap = [&world] {
    double widest = 0;
    for (const Joint& joint : world.joints()) {
      const auto& ball = std::get<BallJointSpec>(joint.spec);
      const Vector3 p_WQ = world.body(ball.a).pose_in_world() * ball.p_AQ;
      widest = std::max(widest, (p_WQ - world.body(ball.b).pose_in_world() * ball.p_BQ).norm());
    }
    return widest;
  };
  double widest = 0;
  for (int i = 0; i < 60; ++i) {
    StepSeconds(1, &world);
    widest = std::max(widest, widest_gap());
    for (BodyId id : links) ASSERT_LT(world.body(id).linear_velocity().norm(), 3);
  }
  EXPECT_LT(widest, 1e-3) << "while it swings";
  EXPECT_LT(widest_gap(), 1e-4) << "when it hangs";
}

TEST_F(JointTest, AHubHoldsThreeHundredGuests) {
  const BodyId post = Add({0, 0, 2}, 0), hub = Add({0.2, 0, 2}, 1);
  Fix(post, hub);
  std::vector<BodyId> guests;
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * std::numbers::pi * i / 300;
    guests.push_back(Add({2 * std::cos(angle), 2 * std::sin(angle), 2 + 0.01 * i}, 1, 0.01));
    Fix(hub, guests.back());
  }
  // As a full matrix, one of these steps would take seconds.
  StepSeconds(0.25);
  for (std::size_t i = 0; i < guests.size(); ++i) {
    EXPECT_NEAR(Place(guests[i]).z(), 2 + 0.01 * static_cast<double>(i), 1e-6) << i;
  }
  EXPECT_NEAR(Place(hub).z(), 2, 1e-6);
}

TEST_F(JointTest, ATumblingRingOfHubsStaysWhole) {
  // Three guests on each of 12 hubs, which close a ring; nothing holds it.
  std::vector<BodyId> hubs;
  std::vector<std::pair<BodyId, BodyId>> pairs;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12;
    const Vector3 outwards(std::cos(angle), std::sin(angle), 0);
    hubs.push_back(Add(outwards, 1 + i));
    for (int k = 0; k < 3; ++k) {
      pairs.emplace_back(hubs.back(), Add(Vector3(outwards * (1.2 + 0.2 * k)), 0.1 + k));
    }
    if (i > 0) pairs.emplace_back(hubs[i - 1], hubs[i]);
  }
  pairs.emplace_back(hubs.back(), hubs.front());
  std::vector<RigidTransform> between;
  for (const auto& [a, b] : pairs) {
    between.push_back(Between(a, b));
    Fix(a, b);
  }
  world_.body(hubs[0]).SetVelocity({0, 0, 30}, {0, 0, 0});
  StepSeconds(1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const RigidTransform now = Between(pairs[i].first, pairs[i].second);
    EXPECT_LT((now.translation() - between[i].translation()).norm(), 1e-4) << i;
  }
  EXPECT_GT(world_.body(hubs[0]).angular_velocity().norm(), 0.1);
}

TEST_F(JointTest, JointsTooTangledForTheDirectSolverStillHold) {
  std::vector<BodyId> tangle;
  for (int i = 0; i < 90; ++i) {
    tangle.push_back(Add({0.2 * (i % 10), 0.2 * (i / 10), 1}, 1, 0.1));
    for (int k = 0; k < i; ++k) Fix(tangle[k], tangle[i]);
  }
  const BodyId post = Add({9, 0, 1}, 0), arm = Add({9.2, 0, 1}, 1);
  Fix(post, arm);
  StepSeconds(0.02);
  EXPECT_NEAR(Between(tangle.front(), tangle.back()).translation().x(), 1.8, 1e-3);
  EXPECT_NEAR(Place(arm).z(), 1, 1e-9) << "what is not part of it holds exactly";
}

class SliderTest : public JointTest {
 protected:
  /// A weightless world of two blocks, in which only the joint acts.
  void MakeFree(double mass_a, double mass_b, double lower, double upper, double step = 1.0 / 480) {
    free_ = std::make_unique<World>(WorldConfig{.step_seconds = step, .gravity = 0, .damping = 0});
    const auto add = [this](const Vector3& p_WB, double mass) {
      return free_->AddBody(
          PhysicsWorldBuilder::BlockSpec(Vector3::Constant(0.1), RigidTransform(p_WB), mass));
    };
    a_ = add({0, 0, 0}, mass_a);
    b_ = add({0.3, 0.05, 0.02}, mass_b);
    rail_ = {.a = a_,
             .b = b_,
             .X_AJ = RigidTransform(Vector3(0.3, 0.05, 0.02)),
             .lower = lower,
             .upper = upper};
  }
  double Offset() const {
    const World& world = *free_;
    return ((world.body(a_).pose_in_world() * rail_.X_AJ).inverse() *
            (world.body(b_).pose_in_world() * rail_.X_BK))
        .translation()
        .x();
  }
  double SlidingSpeed() const {
    const World& world = *free_;
    // They slide along x only, or turn together: speeds of the points on the rail.
    const auto speed_at = [&world](BodyId id, const Vector3& p_WQ) {
      const Body& body = world.body(id);
      const Vector3 arm = p_WQ - body.pose_in_world().translation();
      return Vector3(body.linear_velocity() + body.angular_velocity().cross(arm));
    };
    const Vector3 p_WK = (world.body(b_).pose_in_world() * rail_.X_BK).translation();
    const Vector3 axis = (world.body(a_).pose_in_world() * rail_.X_AJ).rotation().col(0);
    return axis.dot(speed_at(b_, p_WK) - speed_at(a_, p_WK));
  }

  BodyId a_, b_;
  SliderJointSpec rail_;
  std::unique_ptr<World> free_;
};

TEST_F(SliderTest, LimitsHoldHardOnAVerticalRail) {
  const BodyId post = Add({0, 0, 1}, 0), carriage = Add({0.2, 0, 1}, 1),
               load = Add({0.3, 0, 1}, 10);
  SliderJointSpec rail = RailFrom(post, carriage, Vector3::UnitZ(), -0.3, 0.3);
  world_.AddJoint(rail);
  Fix(carriage, load);
  double lowest = 1;
  for (int i = 0; i < 480; ++i) {
    world_.Step();
    lowest = std::min(lowest, Place(carriage).z());
  }
  EXPECT_GT(lowest, 0.7 - 1e-3) << "at the impact";
  EXPECT_NEAR(Place(carriage).z(), 0.7, 1e-5);
}

TEST_F(SliderTest, DampingReducesTheSpeedByItsFractionForAnyMassAndStep) {
  for (const double mass_b : {0.1, 1.0, 10.0}) {
    for (const double step : {1.0 / 480, 1.0 / 120}) {
      MakeFree(1, mass_b, -10, 10, step);
      rail_.damping = 0.6;
      free_->AddJoint(rail_);
      free_->body(b_).SetVelocity({1, 0, 0}, {0, 0, 0});
      free_->Step();
      const auto momentum = [&] {
        return Vector3(free_->body(a_).linear_velocity() +
                       mass_b * free_->body(b_).linear_velocity());
      };
      const double speed = SlidingSpeed();
      const Vector3 before = momentum();
      StepSeconds(1, free_.get());
      EXPECT_NEAR(SlidingSpeed() / speed, 0.4, 0.005) << mass_b << " " << step;
      EXPECT_LT((momentum() - before).norm(), 1e-9) << "equal and opposite";
    }
  }
}

TEST_F(SliderTest, ObjectsFixedToItAreDamped) {
  const BodyId post = Add({0, 0, 1}, 0), base = Add({0.2, 0, 1}, 1),
               carriage = Add({0.4, 0, 1}, 10), load = Add({0.6, 0, 1}, 5);
  Fix(post, base);
  SliderJointSpec rail = RailFrom(base, carriage, Vector3::UnitY(), -5, 5);
  rail.damping = 0.6;
  world_.AddJoint(rail);
  Fix(carriage, load);
  for (BodyId id : {carriage, load}) world_.body(id).SetVelocity({0, 1, 0}, {0, 0, 0});
  StepSeconds(1);
  EXPECT_NEAR(world_.body(load).linear_velocity().y(), 0.4, 1e-6);
}

TEST_F(SliderTest, DampedItStillFallsAlongTheRail) {
  const BodyId post = Add({0, 0, 1}, 0), carriage = Add({0.2, 0, 1}, 1);
  SliderJointSpec rail = RailFrom(post, carriage, Vector3::UnitZ(), -50, 50);
  rail.damping = 0.6;
  world_.AddJoint(rail);
  StepSeconds(1);
  // v' = -g - k v with exp(-k) = 0.4.
  const double k = -std::log(0.4);
  EXPECT_NEAR(world_.body(carriage).linear_velocity().z(), -9.81 / k * (1 - 0.4), 0.02);
}

TEST_F(SliderTest, WithDampingOneItStaysOnAVerticalRailUnderAnyLoad) {
  const BodyId post = Add({0, 0, 1}, 0), carriage = Add({0.2, 0, 1}, 1),
               load = Add({0.3, 0, 1}, 1000);
  SliderJointSpec rail = RailFrom(post, carriage, Vector3::UnitZ(), -0.3, 0.3);
  rail.damping = 1;
  world_.AddJoint(rail);
  Fix(carriage, load);
  StepSeconds(5);
  EXPECT_NEAR(Place(carriage).z(), 1, 1e-6);
  EXPECT_TRUE(world_.is_at_rest());
  // A hand moves it freely; it stays where the hand releases it.
  world_.body(carriage).SetCarried(true);
  for (int i = 0; i < 480; ++i) {
    world_.body(carriage).SetVelocity({0, 0, 0.1}, {0, 0, 0});
    world_.Step();
  }
  const double moved = Place(carriage).z();
  EXPECT_GT(moved, 1.05);
  world_.body(carriage).SetCarried(false);
  for (BodyId id : {carriage, load}) world_.body(id).SetVelocity({0, 0, 0}, {0, 0, 0});
  StepSeconds(5);
  EXPECT_NEAR(Place(carriage).z(), moved, 1e-4);
}

TEST_F(SliderTest, BouncesOffALimitWithItsRestitution) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    MakeFree(1, 3, -0.1, 0.1);
    rail_.restitution = restitution;
    free_->AddJoint(rail_);
    free_->body(b_).SetVelocity({0.4, 0, 0}, {0, 0, 0});
    free_->Step();
    const double before = SlidingSpeed();
    double most = 0;
    for (int i = 0; i < 480 * 0.4; ++i) {
      free_->Step();
      most = std::max(most, std::abs(Offset()));
    }
    EXPECT_NEAR(SlidingSpeed(), -restitution * before, 0.01 * before);
    EXPECT_LT(most, 0.1 + 1e-6);
  }
}

TEST_F(SliderTest, SoftnessTakesTheSpeedAwayBeforeTheLimitAndNeverPushesBack) {
  MakeFree(1, 1, -0.2, 0.2);
  rail_.softness = 0.5;
  free_->AddJoint(rail_);
  free_->body(b_).SetVelocity({0.4, 0, 0}, {0, 0, 0});
  free_->Step();
  const double free_speed = SlidingSpeed();
  double last = free_speed;
  for (int i = 0; i < 480 * 4; ++i) {
    free_->Step();
    const double speed = SlidingSpeed(), offset = Offset();
    ASSERT_GE(speed, -1e-9) << "not outwards";
    ASSERT_LE(speed, last + 1e-9);
    const double kept = std::min(1.0, (0.2 - offset) / 0.1);
    ASSERT_NEAR(speed, free_speed * kept, 0.02 * free_speed) << offset;
    last = speed;
  }
  EXPECT_LT(last, 0.01 * free_speed);
  EXPECT_LT(Offset(), 0.2 + 1e-6);
}

TEST_F(JointTest, AHandLiftsAHeavyBoxByItsLid) {
  // Like the demonstrator's hand: a velocity servo with 40 N per kg.
  World world;
  PhysicsWorldBuilder builder;
  const auto add = [&](const Vector3& size, const Vector3& p, double mass) {
    return world.AddBody(builder.BlockSpec(size, RigidTransform(p), mass));
  };
  add({2, 2, 0.4}, {0, 0, -0.2}, 0);
  const BodyId box = add({0.2, 0.2, 0.1}, {0, 0, 0.05}, 10);
  const BodyId lid = add({0.2, 0.2, 0.02}, {0, 0, 0.11}, 1);
  world.AddJoint(SliderJointSpec{.a = box,
                                 .b = lid,
                                 .X_AJ = RigidTransform(Vector3(0, 0, 0.06)),
                                 .lower = -0.1,
                                 .upper = 0.1});
  StepSeconds(3, &world);
  EXPECT_TRUE(world.is_at_rest()) << "a closed box sleeps";
  EXPECT_EQ(world.Assembly(lid), (std::vector<BodyId>{box, lid}));

  world.body(lid).SetCarried(true);
  const auto pull_to = [&](double z) {
    Body& hand = world.body(lid);
    const Vector3 v = hand.linear_velocity();
    Vector3 change = (Vector3(0, 0, z) - hand.pose_in_world().translation()) / 0.02;
    if (change.norm() > 1) change.normalize();
    change -= v;
    const double most = 40 * world.config().step_seconds;
    if (change.norm() > most) change *= most / change.norm();
    hand.SetVelocity(v + change, -hand.angular_velocity() * 0.5 + hand.angular_velocity());
    world.Step();
  };
  for (int i = 0; i < 480 * 3; ++i) pull_to(0.5);
  const double sag = 0.5 - world.body(lid).pose_in_world().translation().z();
  EXPECT_LT(std::abs(sag), 5e-4);
  EXPECT_NEAR(world.body(box).pose_in_world().translation().z(), 0.44, 1e-3);

  world.body(lid).SetCarried(false);
  StepSeconds(5, &world);
  EXPECT_TRUE(world.is_at_rest());
  EXPECT_NEAR(world.body(lid).pose_in_world().translation().z(), 0.11, 1e-3);
}

TEST_F(JointTest, JoinedBodiesDoNotCollideUntilTheLastReasonEnds) {
  const BodyId a = Add({0, 0, 0}, 0), b = Add({0.05, 0, 0}, 1);
  const JointId first = Fix(a, b), second = Fix(a, b);
  StepSeconds(0.5);
  EXPECT_NEAR(Place(b).x(), 0.05, 1e-6) << "two joints that say the same";
  world_.RemoveJoint(first);
  StepSeconds(0.5);
  EXPECT_NEAR(Place(b).x(), 0.05, 1e-6);
  EXPECT_TRUE(world_.OverlapsAt(b, Pose(b), 0).bodies.empty());
  world_.IgnoreCollisionUntilSeparated(b, a);
  world_.RemoveJoint(second);
  world_.body(b).SetCarried(true);
  world_.body(b).SetVelocity({0.2, 0, 0}, {0, 0, 0});
  StepSeconds(0.2);
  EXPECT_NEAR(Place(b).x(), 0.09, 1e-6) << "it glides out undisturbed";
  StepSeconds(0.1);
  world_.body(b).SetVelocity({-0.2, 0, 0}, {0, 0, 0});
  StepSeconds(0.5);
  EXPECT_GT(Place(b).x(), 0.099) << "and does not come in again";
}

TEST_F(JointTest, OverlapsElsewhereAreReportedWithoutSideEffects) {
  const BodyId table = Add({0, 0, -0.5}, 0, 1.0), box = Add({0.2, 0, 0.05}, 1),
               cube = Add({0, 0, 0.05}, 1);
  StepSeconds(0.2);
  const std::vector<std::byte> before = Serialize(world_.Save());
  const std::uint64_t hash = world_.state_hash();
  const auto overlaps = [&](double x, double z) {
    return world_.OverlapsAt(cube, RigidTransform(Vector3(x, 0, z)), 0.002).bodies;
  };
  EXPECT_EQ(overlaps(0, 0.05), std::vector<BodyId>{}) << "it only rests on the table";
  EXPECT_EQ(overlaps(0.12, 0.05), std::vector<BodyId>{box});
  EXPECT_EQ(overlaps(0.12, 0.04), (std::vector<BodyId>{table, box}));
  EXPECT_EQ(overlaps(0.101, 0.05), std::vector<BodyId>{});
  const std::vector<scene::Solid> imagined = world_.body(cube).spec().solids;
  EXPECT_EQ(overlaps(0.04, 0.05), std::vector<BodyId>{});
  EXPECT_EQ(world_.OverlapsOf(imagined, RigidTransform(Vector3(0.04, 0, 0.05)), 0.002).bodies,
            std::vector<BodyId>{cube})
      << "another one like it would be in it";
  EXPECT_EQ(world_.state_hash(), hash);
  EXPECT_EQ(Serialize(world_.Save()), before);
}

TEST_F(JointTest, ARobotMayAlsoBeInTheWay) {
  PhysicsWorldBuilder builder;
  builder.AddRobot();
  World& world = builder.world_;
  const BodyId cube = builder.AddCube({0, 0.5, 0.3}, 0.1);
  const auto at = [&](const Vector3& p_WB) {
    return world.OverlapsAt(cube, RigidTransform(p_WB), 0.002);
  };
  EXPECT_EQ(at({0, 0.5, 0.3}), Overlaps{});
  const Overlaps robot{.with_articulation = true};
  EXPECT_EQ(at({0, -0.5, 0.3}), robot) << "its base";
  const Vector3 p_WL = world.articulation(builder.robot_).link_poses()[1].translation();
  EXPECT_EQ(at(p_WL + Vector3(0, 0.1, 0)), robot) << "a link";
  world.AddJoint(WeldSpec{.articulation = builder.robot_,
                          .link = 1,
                          .body = cube,
                          .X_LB = RigidTransform(Vector3(0, 0.1, 0.2)),
                          .links_not_colliding = {0, 1, 2}});
  EXPECT_EQ(at(p_WL + Vector3(0, 0.1, 0)), Overlaps{}) << "it may pass through what holds it";
}

TEST_F(JointTest, AnotherFormKeepsPlaceSpeedAndJoints) {
  const BodyId post = Add({0, 0, 1}, 0), b = Add({0.2, 0, 1}, 1), c = Add({0.3, 0, 1}, 1);
  world_.AddJoint(RailFrom(post, b, Vector3::UnitY(), -1, 1));
  Fix(b, c);
  for (BodyId id : {b, c}) world_.body(id).SetVelocity({0, 0.1, 0}, {0, 0, 0});
  StepSeconds(0.5);
  const std::vector<scene::Solid> solids = {
      {scene::Block{{0.3, 0.1, 0.1}}, {}, {}, ""},
      {scene::Block{{0.1, 0.1, 0.4}}, RigidTransform(Vector3(0.1, 0.02, 0)), {}, ""}};
  world_.ChangeForm(b, solids, scene::MassPropertiesOf(solids, 5.0));
  EXPECT_EQ(world_.joints().size(), 2u);
  EXPECT_EQ(world_.body(b).spec().solids.size(), 2u);
  StepSeconds(0.5);
  EXPECT_NEAR(Place(c).y(), 0.1, 1e-4);
  EXPECT_NEAR(Place(c).z(), 1, 1e-6);
}

TEST_F(JointTest, ABodyWithoutSolidsFloatsAndPassesThroughEverything) {
  Add({0, 0, -0.5}, 0, 1.0);
  const BodyId ghost = world_.AddBody({.mass = {.mass = 1, .inertia = Matrix3::Identity()},
                                       .X_WB = RigidTransform(Vector3(0, 0, 0.1))});
  world_.body(ghost).SetVelocity({0, 0, -2}, {0, 0, 0});
  StepSeconds(1);
  EXPECT_NEAR(Place(ghost).z(), 0.1 - 2, 0.001) << "neither gravity nor the block matters to it";
}

TEST_F(JointTest, AngularDampingIsItsOwn) {
  BodySpec spec = PhysicsWorldBuilder::CubeSpec({0, 0, 0}, 0.1);
  spec.angular_damping = 0.75;
  const BodyId id = world_.AddBody(spec);
  world_.body(id).SetVelocity({0, 0, 0}, {0, 0, 2});
  StepSeconds(1);
  EXPECT_NEAR(world_.body(id).angular_velocity().z(), 0.5, 1e-6);
}

TEST_F(JointTest, BodiesWithoutInertiaMayBeJoined) {
  const BodyId post = Add({0, 0, 1}, 0);
  const BodyId point =
      world_.AddBody({.mass = {.mass = 1}, .X_WB = RigidTransform(Vector3(0.1, 0, 1))});
  Fix(post, point);
  StepSeconds(0.5);
  EXPECT_NEAR(Place(point).z(), 1, 1e-6);
}

TEST_F(JointTest, RefusesWhatIsNotAJoint) {
  const BodyId post = Add({0, 0, 1}, 0), wall = Add({1, 0, 1}, 0), b = Add({0.2, 0, 1}, 1);
  EXPECT_THROW(world_.AddJoint(FixedJointSpec{.a = b, .b = b}), std::invalid_argument);
  EXPECT_THROW(world_.AddJoint(FixedJointSpec{.a = post, .b = wall}), std::invalid_argument);
  EXPECT_THROW(world_.AddJoint(BallJointSpec{.a = b, .b = BodyId{99}}), std::logic_error);
  EXPECT_THROW(world_.AddJoint(SliderJointSpec{.a = b, .b = post, .lower = 1}),
               std::invalid_argument);
  EXPECT_THROW(world_.AddJoint(SliderJointSpec{.a = b, .b = post, .damping = 1.5}),
               std::invalid_argument);
  EXPECT_TRUE(world_.joints().empty());
  EXPECT_THROW(world_.ChangeForm(post, {}, {.mass = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace smile::physics

#include "contacts/contact_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace smile::contacts {
namespace {

constexpr double kStep = 1.0 / 480, kGravity = 9.81;
constexpr double kMass = 2, kHalf = 0.05, kFriction = 0.5;
constexpr double kWeight = kMass * kGravity * kStep;  ///< in a step [N s]

/// A cube of 10 cm on the ground, with a contact at each lower corner, for one step.
class CubeTest : public testing::Test {
 protected:
  CubeTest() {
    const double inertia = kMass * (2 * kHalf) * (2 * kHalf) / 6;
    cube_.inverse_mass = 1 / kMass;
    cube_.inverse_inertia = Matrix3::Identity() / inertia;
    cube_.p_WBcm = {0, 0, kHalf};
    cube_.forced_v = {0, 0, -kGravity * kStep};
    for (const double x : {-kHalf, kHalf}) {
      for (const double y : {-kHalf, kHalf}) contacts_.push_back({.p_WB = {x, y, 0}});
    }
  }

  /// Solves a step. Returns true if the cube stands still without being solved.
  bool Solve() {
    v_.setZero(), w_.setZero();
    cube_.change_of_v = v_.data();
    cube_.change_of_w = w_.data();
    Vector3 ground_v = Vector3::Zero(), ground_w = Vector3::Zero();
    const Body ground{.change_of_v = ground_v.data(), .change_of_w = ground_w.data()};
    const std::array bodies{cube_, ground};
    const std::array patches{
        Patch{.a = 0, .b = 1, .count = static_cast<int>(contacts_.size()), .friction = kFriction}};
    ContactSolver solver;
    const bool is_at_rest = solver.Begin({.step_seconds = kStep}, bodies, patches, contacts_, true);
    for (int i = 0; i < 200 && solver.Sweep() > 1e-15; ++i) continue;
    if (!is_at_rest) solver.End();
    EXPECT_EQ(ground_v, Vector3::Zero()) << "the ground does not answer";
    return is_at_rest;
  }
  /// Its velocities at the end of the step.
  Vector3 v() const { return cube_.v + cube_.forced_v + v_; }
  Vector3 w() const { return cube_.w + cube_.forced_w + w_; }
  Vector3 Impulse() const {
    Vector3 sum = Vector3::Zero();
    for (const Contact& contact : contacts_) {
      sum += contact.impulse * contact.normal + contact.friction;
    }
    return sum;
  }

  Body cube_;
  std::vector<Contact> contacts_;

 private:
  Vector3 v_, w_;
};

TEST_F(CubeTest, IsHeldAndThenStandsStillWithTheImpulsesThatItHas) {
  EXPECT_FALSE(Solve()) << "nothing held it before";
  EXPECT_NEAR(v().norm() + w().norm(), 0, 1e-12);
  EXPECT_NEAR((Impulse() - Vector3(0, 0, kWeight)).norm(), 0, 1e-12);
  EXPECT_TRUE(Solve());
  EXPECT_EQ(v(), Vector3::Zero());
  EXPECT_EQ(w(), Vector3::Zero());

  // A push of a thousandth of its weight is more than nothing.
  cube_.forced_v.x() = 0.001 * kGravity * kStep;
  EXPECT_FALSE(Solve());
}

TEST_F(CubeTest, SlidesInWhateverDirectionFromTheSamePushOn) {
  // It cannot turn: how the weight is spread over the corners is then of no account.
  cube_.inverse_inertia.setZero();
  for (int k = 0; k < 16; ++k) {
    const double angle = k * std::numbers::pi / 8 + 0.1;
    const Vector3 direction(std::cos(angle), std::sin(angle), 0);
    const auto push = [this, &direction](double share_of_weight) {
      cube_.forced_v = kGravity * kStep * (share_of_weight * direction - Vector3::UnitZ());
      for (Contact& contact : contacts_) contact.impulse = 0, contact.friction.setZero();
      Solve();
    };
    push(0.95 * kFriction);
    EXPECT_LT(v().norm(), 1e-9) << k;
    EXPECT_TRUE(contacts_[0].sticks);
    push(1.5 * kFriction);
    EXPECT_NEAR((v() - 0.5 * kFriction * kGravity * kStep * direction).norm(), 0, 1e-9) << k;
    EXPECT_FALSE(contacts_[0].sticks) << "it is to be found again where it slid to";
  }
}

TEST_F(CubeTest, ReturnsToWhereItStuckAndPartsFromWhatItHits) {
  for (Contact& contact : contacts_) contact.p_BA_W = {0.0001, 0, 0};
  Solve();
  EXPECT_LT(v().x(), -0.001) << "0.1 mm from its place";
  EXPECT_GT(v().x() * kStep, -0.0001) << "not past it";

  for (Contact& contact : contacts_) contact.restitution = 0.5, contact.p_BA_W.setZero();
  cube_.v = {0, 0, -2};
  Solve();
  EXPECT_NEAR(v().z(), 1, 1e-6);
}

TEST_F(CubeTest, FallsFreelyUntilTheGapCloses) {
  for (Contact& contact : contacts_) contact.distance = 0.001;
  Solve();
  EXPECT_EQ(Impulse(), Vector3::Zero());
  cube_.v = {0, 0, -1};
  Solve();
  EXPECT_NEAR(v().z() * kStep, -0.001, 1e-9) << "it arrives at the end of the step";
}

TEST_F(CubeTest, RollsFromTheTorqueOnThatRollingFrictionBears) {
  // A ball, as it were: one contact below the center.
  constexpr double kLever = 0.002;
  const auto turn = [this](double share) {
    contacts_ = {{.rolling_friction = kLever}};
    cube_.forced_w = cube_.inverse_inertia * Vector3(0, share * kLever * kWeight, 0);
    Solve();
    return w().y();
  };
  EXPECT_NEAR(turn(0.9), 0, 1e-9);
  EXPECT_GT(turn(2), 0.0001);
}

}  // namespace
}  // namespace smile::contacts

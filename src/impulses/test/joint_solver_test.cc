#include "impulses/joint_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace smile::impulses {
namespace {

/// Bodies in a row, each joined to the next at a point, and all of them to the last one.
class JointSolverTest : public testing::Test {
 protected:
  static constexpr int kCount = 8;

  JointSolverTest() : bodies_(kCount), changes_(2 * kCount) {
    for (int i = 0; i < kCount; ++i) {
      bodies_[i].inverse_mass = i == 0 ? 0 : 1 / (1 + std::abs(Random().x()));
      if (i > 0) bodies_[i].inverse_inertia = Vector3(20, 30, 25).asDiagonal();
      bodies_[i].change_of_v = changes_[2 * i].data();
      bodies_[i].change_of_w = changes_[2 * i + 1].data();
      changes_[2 * i] = changes_[2 * i + 1] = Vector3::Zero();
    }
    for (int i = 0; i + 1 < kCount; ++i) Join(i, i + 1);
    for (int i = 1; i + 2 < kCount; ++i) Join(i, kCount - 1);
  }

  /// Rows that hold a point of A at a point of B, in three directions.
  void Join(int a, int b) {
    const Vector3 arm_a = 0.1 * Random(), arm_b = 0.1 * Random();
    for (int k = 0; k < 3; ++k) {
      const Vector3 unit = Vector3::Unit(k);
      const auto side = [&](int body, const Vector3& arm, double sign) {
        const Vector3 angular = sign * arm.cross(unit);
        return JointRow::Side{body, sign * unit, angular, bodies_[body].inverse_inertia * angular};
      };
      JointRow row{.sides = {side(a, arm_a, 1), side(b, arm_b, -1)}};
      double response = 0;
      for (const JointRow::Side& one : row.sides) {
        response += bodies_[one.body].inverse_mass + one.angular.dot(one.turning);
      }
      row.inverse_response = 1 / response;
      row.impulse_alone = Random().x() / response;
      rows_.push_back(row);
      solver_.AddRow(row, /*is_next=*/k > 0);
    }
  }
  double SpeedAlong(const JointRow& row) const {
    double speed = 0;
    for (const JointRow::Side& side : row.sides) {
      speed += side.linear.dot(ChangeOfV(bodies_[side.body])) +
               side.angular.dot(ChangeOfW(bodies_[side.body]));
    }
    return speed;
  }
  Vector3 Random() {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double x = uniform(random_), y = uniform(random_), z = uniform(random_);
    return {x, y, z};
  }

  std::mt19937 random_{3};
  std::vector<Body> bodies_;
  std::vector<Vector3> changes_;
  std::vector<JointRow> rows_;
  JointSolver solver_;
};

TEST_F(JointSolverTest, AllRowsOfLoopsAndOfABodyWithManyJointsHoldAtOnce) {
  solver_.Factor(bodies_);
  solver_.Solve(bodies_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    EXPECT_TRUE(solver_.is_solved(i));
    const double wanted = rows_[i].impulse_alone / rows_[i].inverse_response;
    EXPECT_NEAR(SpeedAlong(rows_[i]), wanted, 1e-5) << i;
  }
  EXPECT_EQ(changes_[0], Vector3::Zero()) << "the first body does not answer";

  // What else changes the velocities is made up for, and the impulses add up.
  const double before = solver_.impulse(4);
  changes_[4] += Vector3(0.5, 0, -0.2);
  solver_.Solve(bodies_);
  EXPECT_NEAR(SpeedAlong(rows_[4]), rows_[4].impulse_alone / rows_[4].inverse_response, 1e-5);
  EXPECT_NE(solver_.impulse(4), before);
}

}  // namespace
}  // namespace smile::impulses

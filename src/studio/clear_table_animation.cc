#include "studio/clear_table_animation.h"

#include "base/uniform.h"

// In the original program the robot could clear the table in a rage. Here it acts on a copy of the
// world at its own random velocities, and the session continues with the untouched original.

namespace smile::studio {

bool ClearTableAnimation::IsPossible(const sim::Simulation& simulation) {
  return simulation.robot() != nullptr && simulation.robot()->num_arms() > 0;
}

ClearTableAnimation::ClearTableAnimation(const sim::Simulation& simulation)
    : copy_(simulation.start_model()) {
  // The model of the start; Restore() adds the objects that came later.
  copy_.Restore(simulation.Save());
  // Hands release everything, so that the arms can move it.
  for (const sim::HandName hand : demonstrator::kHandNames) {
    if (copy_.demonstrator().hand(hand).is_holding()) (void)copy_.Apply(sim::Release{.hand = hand});
  }
  (void)copy_.Apply(sim::ShowRobot{});
  (void)copy_.Apply(sim::Face{.face_expression = robot::FaceExpression::kPuzzled});
}

std::vector<double> ClearTableAnimation::RandomVelocities(int arm) {
  const robot::RobotModel& model = copy_.robot()->model();
  std::vector<double> velocities;
  for (const int joint : model.arms[static_cast<std::size_t>(arm)].joints) {
    // Up to the joint's limit in either direction [rad/s].
    const double most = model.links[static_cast<std::size_t>(joint)].max_velocity;
    velocities.push_back(Uniform(&random_, -most, most));
  }
  return velocities;
}

void ClearTableAnimation::Tick() {
  // New random velocities four times a second.
  constexpr int kTicksBetween = sim::kTicksPerSecond / 4;
  if (ticks_ % kTicksBetween == 0) {
    sim::JointVelocities velocities;
    for (int arm = 0; arm < copy_.robot()->num_arms(); ++arm) {
      velocities.arms[copy_.robot()->model().arms[static_cast<std::size_t>(arm)].name] =
          RandomVelocities(arm);
    }
    (void)copy_.Apply(velocities);
  }
  copy_.Tick();
  ++ticks_;
}

}  // namespace smile::studio

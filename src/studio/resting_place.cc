#include "studio/resting_place.h"

namespace smile::studio {

std::optional<RigidTransform> RestingPlace::Find(const sim::Simulation& simulation,
                                                 sim::HandName hand) {
  constexpr int kMaxTicks = 2 * sim::kTicksPerSecond;
  // What is slow for a moment may bounce or tip over yet.
  constexpr int kCalmTicks = sim::kTicksPerSecond / 4;
  constexpr double kSlow = 0.002, kSlowTurn = 0.02;  // as Simulation::is_still() [m/s, rad/s]
  const physics::BodyId held = simulation.demonstrator().hand(hand).held;
  if (!held) return std::nullopt;
  if (!copy_) {
    copy_ = std::make_unique<sim::Simulation>(simulation.shared_model());
  }
  copy_->Restore(simulation.Save());
  if (copy_->Apply(sim::Release{.hand = hand})) return std::nullopt;
  const physics::Body& body = copy_->physics().body(held);
  for (int i = 0, num_calm = 0; i < kMaxTicks && num_calm < kCalmTicks; ++i) {
    copy_->Tick();
    const bool is_slow =
        body.linear_velocity().norm() < kSlow && body.angular_velocity().norm() < kSlowTurn;
    num_calm = is_slow ? num_calm + 1 : 0;
    if (body.pose_in_world().translation().z() < -simulation.scene().table.thickness) {
      return std::nullopt;
    }
  }
  return body.pose_in_world();
}

}  // namespace smile::studio

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "demonstrator/hand.h"
#include "demonstrator/servo.h"
#include "world/tabletop.h"

namespace smile::demonstrator {

using world::Refusal;

/// What the demonstrator's four hands hold and want; a plain value, part of every saved state.
struct DemonstratorState {
  std::array<Hand, kHandNames.size()> hands;

  bool operator==(const DemonstratorState&) const = default;
};

/// The invisible teacher: hands without a body that grasp, carry, turn and release objects.
///
/// A held object weighs nothing and follows its hand through a servo of limited force, so that it
/// pushes what it touches, stops at the table and never tunnels.
class Demonstrator {
 public:
  /// Both must outlive this.
  Demonstrator(physics::World* world, world::Tabletop* tabletop);

  /// Takes an object, at point `p_WQ` or at its origin.
  [[nodiscard]] std::optional<Refusal> Grasp(HandName hand, std::string_view object_id,
                                             const std::optional<Vector3>& p_WQ);
  /// Carries the point at which the object was grasped to `p_WH` [m], at most at `speed` [m/s].
  [[nodiscard]] std::optional<Refusal> MoveTo(HandName hand, const Vector3& p_WH,
                                              const std::optional<double>& speed);
  /// Turns the held object about its origin, about the world's x, then y, then z axis [deg].
  [[nodiscard]] std::optional<Refusal> Rotate(HandName hand, const Vector3& angles_deg);
  /// Lets go: the object is at rest for a moment, then gravity has it.
  [[nodiscard]] std::optional<Refusal> Release(HandName hand);

  /// Takes the held object out of the world.
  [[nodiscard]] std::optional<Refusal> Destroy(HandName hand);
  /// Shows an object, or a part of one that may be pointed at; nothing else happens.
  [[nodiscard]] std::optional<Refusal> PointAt(HandName hand, std::string_view part_id) const;
  /// Presses a switch or triggers a custom control; see world::Controls::Trigger().
  [[nodiscard]] std::optional<Refusal> Trigger(HandName hand, std::string_view control,
                                               std::string_view part);
  /// One stage tighter or looser, of the guest point of the object that is nearest to `p_WQ`, or to
  /// its origin. A hand that holds something can only fasten and loosen that; see
  /// world::Bonds::Fasten().
  [[nodiscard]] std::optional<Refusal> Fasten(HandName hand, std::string_view object_id,
                                              const std::optional<Vector3>& p_WQ);
  [[nodiscard]] std::optional<Refusal> Loosen(HandName hand, std::string_view object_id,
                                              const std::optional<Vector3>& p_WQ);

  /// To be called before each physics step.
  void BeforeStep();

  const Hand& hand(HandName name) const { return state_.hands[static_cast<std::size_t>(name)]; }
  /// True when every held object is where its hand wants it (within 0.5 mm and 0.5 degrees).
  bool has_arrived() const;

  const DemonstratorState& state() const { return state_; }
  void Restore(const DemonstratorState& state) { state_ = state; }

 private:
  Hand& MutableHand(HandName name) { return state_.hands[static_cast<std::size_t>(name)]; }
  std::optional<Refusal> RefuseIfEmpty(HandName name) const;
  std::optional<Refusal> RefuseIfHolding(HandName name, const char* what) const;
  using Turning = std::optional<Refusal> (world::Tabletop::*)(const world::Object&, const Vector3&);
  std::optional<Refusal> Turn(HandName name, std::string_view object_id,
                              const std::optional<Vector3>& p_WQ, Turning turning);

  physics::World* world_;
  world::Tabletop* tabletop_;
  ServoConfig servo_;
  DemonstratorState state_;
};

}  // namespace smile::demonstrator

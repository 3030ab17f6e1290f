#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demonstrator/hand.h"
#include "demonstrator/servo.h"
#include "world/tabletop.h"

namespace smile::demonstrator {

using world::Refusal;

/// So many properties of an object can matter, and so long are their names at most.
inline constexpr std::size_t kMaxProperties = 32, kMaxPropertyLength = 256;

/// What the demonstrator's four hands hold and want, and what they said; a plain value, part of
/// every saved state.
struct DemonstratorState {
  std::array<Hand, kHandNames.size()> hands;
  /// Of each hand, where its motion plane runs: from the x axis, counterclockwise seen from above.
  std::array<double, kHandNames.size()> plane_angles_deg = {};
  /// Of objects, which properties matter; of most nothing was said.
  std::map<physics::BodyId, std::vector<std::string>> attention;

  bool operator==(const DemonstratorState&) const = default;
};

/// What must happen before a hand can take an object.
struct GraspPlan {
  std::optional<Refusal> refusal;    ///< it cannot
  std::vector<HandName> to_release;  ///< these let go first, in this order
};

/// What a mouse points at: from an origin [m] in a direction of any length.
struct Ray {
  Vector3 p_WOrigin = Vector3::Zero();
  Vector3 direction_in_world = Vector3::Zero();
};

/// The invisible teacher: hands without a body that grasp, carry, turn and release objects.
///
/// A held object weighs nothing and follows its hand through a servo of limited force, so that it
/// pushes what it touches, stops at the table and never tunnels.
class Demonstrator {
 public:
  /// Both must outlive this.
  Demonstrator(physics::World* world, world::Tabletop* tabletop);

  /// The hands are two: `both` are all of them, `any` is one that is free. So each of them lets go
  /// when another is to be used that needs it, and whoever held the object hands it over.
  GraspPlan PlanGrasp(HandName hand, std::string_view object_id) const;
  /// Takes an object, at point `p_WQ` or at its origin. Who has to let go must have done so.
  [[nodiscard]] std::optional<Refusal> Grasp(HandName hand, std::string_view object_id,
                                             const std::optional<Vector3>& p_WQ);
  /// Carries the point at which the object was grasped to `p_WH` [m], at most at `speed` [m/s].
  [[nodiscard]] std::optional<Refusal> MoveTo(HandName hand, const Vector3& p_WH,
                                              const std::optional<double>& speed);
  /// Turns the hand's motion plane, which is vertical and through where the hand wants to be. It
  /// keeps its direction from grasp to grasp.
  void TurnPlane(HandName hand, double angle_deg);
  /// Where a ray meets the hand's motion plane, or the level one through where it wants to be: the
  /// place to move to [m]; or why there is none.
  std::optional<Vector3> PointOnPlane(HandName hand, const Ray& ray, bool is_level,
                                      Refusal* refusal) const;
  /// Turns the held object about its origin, about the world's x, then y, then z axis [deg].
  [[nodiscard]] std::optional<Refusal> Rotate(HandName hand, const Vector3& angles_deg);
  /// Lets go: the object is at rest for a moment, then gravity has it.
  [[nodiscard]] std::optional<Refusal> Release(HandName hand);

  /// Takes the held object out of the world.
  [[nodiscard]] std::optional<Refusal> Destroy(HandName hand);
  /// Takes an object out of the world that no hand and no gripper holds.
  [[nodiscard]] std::optional<Refusal> Remove(const world::Object& object);
  /// Tells which properties of the held object matter, instead of what was told of it before; none:
  /// nothing in particular. Known are color (or colour), shape, size, position, orientation, order,
  /// and the names of its descriptions.
  [[nodiscard]] std::optional<Refusal> Attend(HandName hand,
                                              const std::vector<std::string>& properties);
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
  double plane_angle_deg(HandName name) const {
    return state_.plane_angles_deg[static_cast<std::size_t>(name)];
  }
  /// Those of an object that matter, as they were told; also after it was released.
  const std::vector<std::string>& PropertiesThatMatter(const world::Object& object) const;
  /// True when every held object is where its hand wants it (within 0.5 mm and 0.5 degrees).
  bool has_arrived() const;
  /// The same of one hand; true when it holds nothing.
  bool has_arrived(HandName name) const;

  const DemonstratorState& state() const { return state_; }
  void Restore(const DemonstratorState& state) { state_ = state; }
  void AddToHash(StateHash* hash) const;

 private:
  Hand& MutableHand(HandName name) { return state_.hands[static_cast<std::size_t>(name)]; }
  /// Whatever the other hands hold.
  std::optional<Refusal> RefuseToTake(HandName name, std::string_view object_id) const;
  std::string WhatHolds(HandName name) const;
  std::optional<Refusal> RefuseIfEmpty(HandName name) const;
  std::optional<Refusal> RefuseIfHolding(HandName name, const char* what) const;
  using Turning = std::optional<Refusal> (world::Tabletop::*)(const world::Object&, const Vector3&);
  bool IsInAHand(physics::BodyId body) const;
  std::optional<Refusal> Turn(HandName name, std::string_view object_id,
                              const std::optional<Vector3>& p_WQ, Turning turning);

  physics::World* world_;
  world::Tabletop* tabletop_;
  ServoConfig servo_;
  DemonstratorState state_;
};

}  // namespace smile::demonstrator

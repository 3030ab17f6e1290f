#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demonstrator/hands.h"
#include "world/tabletop.h"

namespace smile::demonstrator {

/// Limits of the properties of an object that can matter: their number, and the length of a name.
inline constexpr std::size_t kMaxProperties = 32, kMaxPropertyLength = 256;

/// State of the demonstrator's four hands and of the properties it pointed out; a plain value, part
/// of each saved state.
struct DemonstratorState {
  HandStates hands;
  /// Direction of each hand's motion plane: from the x axis, counterclockwise seen from above.
  std::array<double, kHandNames.size()> plane_angles_deg = {};
  /// Properties that matter, for the objects for which any were named.
  std::map<physics::BodyId, std::vector<std::string>> attention;

  bool operator==(const DemonstratorState&) const = default;
};

/// Ray of a mouse pointer: from an origin [m] in a direction of any length.
struct Ray {
  Vector3 p_WOrigin = Vector3::Zero();
  Vector3 direction_in_world = Vector3::Zero();
};

/// The demonstrator: hands without a body that grasp, carry, rotate and release objects.
///
/// A held object weighs nothing and follows its hand through a servo of limited force, so that it
/// pushes what it touches, stops at the table and never tunnels.
class Demonstrator {
 public:
  /// Both must outlive this.
  Demonstrator(physics::World* world, world::Tabletop* tabletop);

  /// Plans a grasp. There are two physical hands: `both` is both of them, `any` is a free one. Each
  /// therefore releases its object if another hand that needs it is used, and the present holder of
  /// an object hands it over.
  GraspPlan PlanGrasp(HandName hand, std::string_view object_id) const;
  /// Takes an object, at point `p_WQ` or at its origin. The hands of PlanGrasp() must have released
  /// before.
  [[nodiscard]] std::optional<Refusal> Grasp(HandName hand, std::string_view object_id,
                                             const std::optional<Vector3>& p_WQ);
  /// Moves the point at which the object was grasped to `p_WH` [m], at most at `speed` [m/s].
  [[nodiscard]] std::optional<Refusal> MoveTo(HandName hand, const Vector3& p_WH,
                                              const std::optional<double>& speed);
  /// Rotates the hand's motion plane, which is vertical and contains the hand's goal. It keeps its
  /// direction from grasp to grasp.
  void TurnPlane(HandName hand, double angle_deg);
  /// Returns the point [m] where a ray meets the hand's motion plane, or the level plane, through
  /// the hand's goal; nullopt with the reason in `refusal` if it meets none.
  std::optional<Vector3> PointOnPlane(HandName hand, const Ray& ray, bool is_level,
                                      Refusal* refusal) const;
  /// Rotates the held object about its origin, about the world's x, then y, then z axis [deg].
  [[nodiscard]] std::optional<Refusal> Rotate(HandName hand, const Vector3& angles_deg);
  /// Releases the object, which starts at rest.
  [[nodiscard]] std::optional<Refusal> Release(HandName hand);

  /// Removes the held object from the world.
  [[nodiscard]] std::optional<Refusal> Destroy(HandName hand);
  /// Removes an object from the world that no hand and no gripper holds.
  [[nodiscard]] std::optional<Refusal> Remove(const world::Object& object);
  /// Sets the properties of the held object that matter, replacing earlier ones; empty: none in
  /// particular. Accepted are color (or colour), shape, size, position, orientation, order,
  /// support, and the names of its descriptions.
  [[nodiscard]] std::optional<Refusal> Attend(HandName hand,
                                              const std::vector<std::string>& properties);
  /// Points at an object or a pointable part; nothing else happens.
  [[nodiscard]] std::optional<Refusal> PointAt(HandName hand, std::string_view part_id) const;
  /// Presses a switch or triggers a custom control; see world::Controls::Trigger().
  [[nodiscard]] std::optional<Refusal> Trigger(HandName hand, std::string_view control,
                                               std::string_view part);
  /// Fastens or loosens by one stage the guest point of the object that is nearest to `p_WQ`, or to
  /// its origin. A hand that holds an object can only fasten and loosen that one; see
  /// world::Bonds::Fasten().
  [[nodiscard]] std::optional<Refusal> Fasten(HandName hand, std::string_view object_id,
                                              const std::optional<Vector3>& p_WQ);
  [[nodiscard]] std::optional<Refusal> Loosen(HandName hand, std::string_view object_id,
                                              const std::optional<Vector3>& p_WQ);

  /// Uses the tool that a hand holds; see world::Tools::Use(). Its tip stays where it works: the
  /// tool follows what it has moved.
  /// @param loosens  direction of a tool that is turned.
  /// @param use      what it did.
  [[nodiscard]] std::optional<Refusal> Use(HandName hand, bool loosens, world::ToolUse* use);

  /// Call before each physics step: drives held objects towards their goals.
  void BeforeStep();

  const Hand& hand(HandName name) const { return state_.hands[static_cast<std::size_t>(name)]; }
  double plane_angle_deg(HandName name) const {
    return state_.plane_angles_deg[static_cast<std::size_t>(name)];
  }
  /// Returns the properties of an object that matter, also after it was released.
  const std::vector<std::string>& PropertiesThatMatter(const world::Object& object) const;
  /// Returns true if each held object is at its goal (within 0.5 mm and 0.5 degrees).
  bool has_arrived() const;
  /// The same for one hand; true if it holds nothing.
  bool has_arrived(HandName name) const;

  const DemonstratorState& state() const { return state_; }
  void Restore(const DemonstratorState& state) { state_ = state; }
  void AddToHash(StateHash* hash) const;

 private:
  Hand& MutableHand(HandName name) { return state_.hands[static_cast<std::size_t>(name)]; }
  Refusal WhatHolds(HandName name) const;
  std::optional<Refusal> RefuseIfEmpty(HandName name) const;
  std::optional<Refusal> RefuseIfHolding(HandName name, const char* action) const;
  using Turning = std::optional<Refusal> (world::Tabletop::*)(const world::Object&, const Vector3&);
  bool IsInAHand(physics::BodyId body) const;
  std::optional<Refusal> Turn(HandName name, std::string_view object_id,
                              const std::optional<Vector3>& p_WQ, Turning turning);
  /// Carries out a change that may move held objects at once: their goals move with them.
  std::optional<Refusal> MoveGoalsWith(const std::function<std::optional<Refusal>()>& change);
  /// Moves a held tool by the displacement of what it worked on, unless something is in the way.
  void FollowWork(const world::Object& tool, const world::Object& work, const Vector3& p_WW_before);

  physics::World* world_;
  world::Tabletop* tabletop_;
  ServoConfig servo_;
  DemonstratorState state_;
};

}  // namespace smile::demonstrator

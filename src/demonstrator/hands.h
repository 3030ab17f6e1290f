#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demonstrator/engine.h"
#include "demonstrator/hand.h"
#include "demonstrator/servo.h"

namespace smile {
class StateHash;
}

namespace smile::demonstrator {

using world::Refusal;

/// The state of all hands, in the order of kHandNames.
using HandStates = std::array<Hand, kHandNames.size()>;

/// Returns the name of a hand as a singular subject.
Refusal NameOf(HandName hand);

/// Preconditions for a hand to take an object.
struct GraspPlan {
  std::optional<Refusal> refusal;    ///< reason why it cannot
  std::vector<HandName> to_release;  ///< hands that must release first, in this order
};

/// The hands of a demonstrator on any Engine: grasp, carry, rotate and release. Each command takes
/// effect at once, or is refused without effect; motion happens in BeforeStep(). See Demonstrator
/// for the rules. It has no state of its own.
class Hands {
 public:
  /// Engine and states must outlive this.
  Hands(Engine* engine, HandStates* states, const ServoConfig& servo = {})
      : engine_(*engine), states_(*states), servo_(servo) {}

  GraspPlan PlanGrasp(HandName hand, std::string_view object_id) const;
  [[nodiscard]] std::optional<Refusal> Grasp(HandName hand, std::string_view object_id,
                                             const std::optional<Vector3>& p_WQ);
  [[nodiscard]] std::optional<Refusal> MoveTo(HandName hand, const Vector3& p_WH,
                                              const std::optional<double>& speed);
  [[nodiscard]] std::optional<Refusal> Rotate(HandName hand, const Vector3& angles_deg);
  [[nodiscard]] std::optional<Refusal> Release(HandName hand);

  /// Call before each physics step: drives held objects towards their goals.
  void BeforeStep();

  /// Returns true if the held object is at its goal (within 0.5 mm and 0.5 degrees), or there is
  /// none.
  bool has_arrived(HandName hand) const;
  /// Returns true if one of the hands holds a body.
  bool IsInAHand(mechanics::BodyId body) const;
  /// Returns who holds what, as refusals write it. The hand must hold something.
  Refusal WhatHolds(HandName hand) const;
  std::optional<Refusal> RefuseIfEmpty(HandName hand) const;

 private:
  const Hand& hand(HandName name) const { return states_[static_cast<std::size_t>(name)]; }
  Hand& MutableHand(HandName name) { return states_[static_cast<std::size_t>(name)]; }
  std::optional<Refusal> RefuseToTake(HandName name, std::string_view object_id) const;
  std::optional<Refusal> RefuseAny(mechanics::BodyId body) const;
  std::vector<HandName> InTheWay(HandName name, mechanics::BodyId body) const;
  bool HoldsAnother(HandName name, mechanics::BodyId body) const;

  Engine& engine_;
  HandStates& states_;
  ServoConfig servo_;
};

void AddToHash(const HandStates& states, StateHash* hash);

}  // namespace smile::demonstrator

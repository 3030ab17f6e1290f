#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/state_hash.h"
#include "physics/world.h"
#include "world/bonds.h"
#include "world/controls.h"
#include "world/object.h"
#include "world/object_states.h"
#include "world/refusal.h"

namespace smile::world {

/// State of a tool.
struct ToolState {
  enum class Grip { kFree, kHeld, kSqueezed };
  Grip grip = Grip::kFree;         ///< by hands and grippers, at the last tick
  std::optional<GuestIndex> at{};  ///< guest that a tool of kind kDrive is at
  double angle = 0;                ///< about the place, relative to the guest [rad]

  bool operator==(const ToolState&) const = default;
};

/// State of all tools.
struct ToolsState {
  std::vector<ToolState> tools;  ///< by model::ToolIndex
  /// Rotation of guests since their last change of stage, by GuestIndex: > 0 tightens [rad].
  std::vector<double> turned;

  bool operator==(const ToolsState&) const = default;
};

/// Hand or gripper that holds a body.
struct Holder {
  physics::BodyId body;
  int arm = -1;               ///< of the robot; -1: a hand
  bool is_squeezing = false;  ///< a gripper that is commanded to close
};

/// What a tool does to the thing that it is at.
struct ToolUse {
  model::ToolIndex tool{0};
  int arm = -1;                                  ///< of the robot, if a gripper used it
  std::string verb;                              ///< `cut`, `fasten` or `loosen`
  ObjectIndex object{0};                         ///< that it worked on
  std::string target;                            ///< in words: `Rope between link 4 and 5`, `Screw`
  std::optional<GuestIndex> guest{};             ///< of a bond
  std::optional<GuestTurn> turn{};               ///< of the guest, if it is not cut off
  std::optional<model::ControlIndex> control{};  ///< of a part
  int next_state = -1;                           ///< of the control
  physics::JointId joint{};                      ///< of a chain
};

/// A place at which a tool can work, however far away; for a part that is cut, its middle.
struct WorkPlace {
  std::string target;                      ///< in words, as in ToolUse
  Vector3 displacement = Vector3::Zero();  ///< from the working point [m]
};

/// Tools of a scene: what they are at, and what happens when they are used or turned.
///
/// One mechanism for all: a tool has a working point and an axis, and acts on the nearest place
/// that fits, within its reach and angle. What it does there is decided at once.
class Tools {
 public:
  /// All must outlive this.
  Tools(physics::World* world, const model::Model& model, const std::vector<Object>* objects,
        const ObjectStates* object_states, Controls* controls, Bonds* bonds);
  /// Adds the tools that a larger model has behind the present ones.
  /// @param model  must outlive this, as the one of Restore().
  void Grow(const model::Model& model);
  const ToolsState& state() const { return state_; }
  void Restore(ToolsState state, const model::Model& model);
  bool is_empty() const { return state_.tools.empty(); }

  /// Returns what a tool would do if it were used now, or nullopt with the reason in `refusal`.
  /// @param loosens  direction of a tool of kind kDrive.
  std::optional<ToolUse> PlanUse(model::ToolIndex tool, bool loosens, Refusal* refusal) const;
  /// Returns the nearest place at which nothing immovable is in the tool's way, turned as it is;
  /// the nearest one if there is something everywhere, and nullopt if there is nothing to work on.
  std::optional<WorkPlace> NearestWork(model::ToolIndex tool) const;
  /// Uses a tool as planned in the present state.
  void Use(const ToolUse& use);
  /// Returns every use that is possible now of the tools that are held: up to two of a tool of kind
  /// kDrive.
  std::vector<ToolUse> PossibleUses(const std::vector<Holder>& holders) const;
  /// Call after the steps of a tick: squeezed tools are used, and turned ones turn.
  /// @param holders  all bodies that hands and grippers hold.
  /// @returns what was done; reasons of what was not done are appended to `refusals`.
  std::vector<ToolUse> AfterTick(const std::vector<Holder>& holders,
                                 std::vector<Refusal>* refusals);
  void AddToHash(StateHash* hash) const;

  /// How far a tool is from a thing.
  struct Offset {
    double distance = 0;  ///< [m]
    Vector3 direction;    ///< of the tool from the thing, in the world, of any length
  };

 private:
  struct Candidate {
    Offset offset;
    ToolUse use;
  };
  RigidTransform PoseOf(ObjectIndex object) const {
    return world_->body((*objects_)[object].body).pose_in_world();
  }
  bool IsInPlay(ObjectIndex object) const {
    return world_->Has((*objects_)[object].body) && !(*object_states_)[object].has_fallen;
  }
  const std::string& NameOf(ObjectIndex object) const { return (*objects_)[object].id(); }
  const Holder* HolderOf(model::ToolIndex tool, const std::vector<Holder>& holders) const;
  /// Returns all that the tool could cut, the nearest first.
  std::vector<Candidate> CutsByDistance(model::ToolIndex tool) const;
  /// @param angle  of the tool against the axis of the place [rad].
  std::optional<Candidate> NearestGuest(model::ToolIndex tool, double* angle) const;
  /// Returns the reason why a tool does nothing where one of another type belongs.
  std::optional<Refusal> RefuseOtherType(model::ToolIndex tool) const;
  /// Returns true if the tool would not overlap anything immovable where it can cut that.
  bool HasRoom(const Candidate& cut) const;
  std::optional<ToolUse> CutTarget(model::ToolIndex tool, Refusal* refusal) const;
  void AppendChainCuts(const Vector3& p_WT, const Vector3& p_WTip,
                       std::vector<Candidate>* candidates) const;
  void AppendBondCuts(const Vector3& p_WT, const Vector3& p_WTip,
                      std::vector<Candidate>* candidates) const;
  void AppendPartCuts(const Vector3& p_WT, const Vector3& p_WTip,
                      std::vector<Candidate>* candidates) const;
  std::optional<ToolUse> BondTarget(model::ToolIndex tool, Refusal* refusal) const;
  /// Adds to a target what a stage in this direction would do to it.
  std::optional<ToolUse> PlanStage(ToolUse target, int direction, Refusal* refusal) const;
  /// Returns the angle of a tool about the axis of a place of a guest.
  double AngleAt(model::ToolIndex tool, GuestIndex guest) const;
  /// Advances a tool of kind kDrive that is held.
  std::optional<ToolUse> Turn(model::ToolIndex tool, Refusal* refusal);

  physics::World* world_;
  const model::Model* model_;
  const std::vector<Object>* objects_;
  const ObjectStates* object_states_;
  Controls* controls_;
  Bonds* bonds_;
  ToolsState state_;
};

}  // namespace smile::world

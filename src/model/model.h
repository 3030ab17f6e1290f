#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/bond.h"
#include "model/control.h"
#include "model/indices.h"
#include "model/robot_placement.h"
#include "robot/face_expression.h"
#include "scene/scene_spec.h"
#include "scene/visual_model.h"

namespace smile::model {

/// What can be seen of the objects at a moment, apart from a robot.
struct SceneState {
  std::vector<std::optional<RigidTransform>> X_WB;  ///< of each object; nullopt: destroyed
  std::vector<ControlState> controls;               ///< by ControlIndex
  std::vector<HostState> hosts;                     ///< by HostIndex
};

/// A scene and a robot, compiled once: everything about them that does not change while they are
/// simulated, shown or compared, as MuJoCo's mjModel and Drake's MultibodyPlant. What changes is a
/// plain value beside it (a recording::TraceTick, a sim::SimulationState), and what can be seen of
/// such a value is a pure function of both. Knows no physics: who only looks needs no world.
///
/// Immutable, and neither copied nor moved, so that any thread may read it and the pointers of its
/// Controls, Guests and Hosts into its scene stay valid. Shared ownership is for whoever outlives
/// the maker: a world that runs it, and pages and pictures of that world which are still being made
/// when it is replaced, own it by `shared_ptr<const Model>`; the last one ends it.
///
/// A model that is to have more objects is another model, which has them behind those of before:
/// all indices of objects, controls, guests and hosts stay valid. Those of frames and choices are
/// the model's own.
class Model {
 public:
  /// @param robot  nullopt for a table without one.
  explicit Model(scene::SceneSpec scene, std::optional<RobotPlacement> robot = std::nullopt);
  /// Another scene with the same robot, which both models share. If it is to have more objects than
  /// that of `other`, these are behind its own; see scene::Joined().
  Model(const Model& other, scene::SceneSpec scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const scene::SceneSpec& scene() const { return scene_; }

  IndexRange<ObjectIndex> objects() const { return IndexRange<ObjectIndex>(scene_.objects.size()); }
  const scene::ObjectSpec& object(ObjectIndex object) const { return scene_.objects[object]; }
  const std::string& id(ObjectIndex object) const { return scene_.objects[object].id(); }
  [[nodiscard]] std::optional<ObjectIndex> FindObject(std::string_view id) const;
  /// The chain of which an object is a link; nullptr for all others.
  const scene::ChainSpec* chain_of_link(ObjectIndex object) const;

  IndexRange<ControlIndex> controls() const { return IndexRange<ControlIndex>(controls_.size()); }
  const Control& control(ControlIndex control) const { return controls_[control]; }
  const std::vector<Control>& all_controls() const { return controls_; }
  [[nodiscard]] std::optional<ControlIndex> FindControl(std::string_view id) const;
  /// An object's own.
  IndexRange<ControlIndex> controls_of(ObjectIndex object) const {
    return {first_control_[object], first_control_[object + 1]};
  }

  IndexRange<GuestIndex> guests() const { return IndexRange<GuestIndex>(guests_.size()); }
  const Guest& guest(GuestIndex guest) const { return guests_[guest]; }
  [[nodiscard]] std::optional<GuestIndex> FindGuest(std::string_view id) const;
  IndexRange<HostIndex> hosts() const { return IndexRange<HostIndex>(hosts_.size()); }
  const Host& host(HostIndex host) const { return hosts_[host]; }
  [[nodiscard]] std::optional<HostIndex> FindHost(std::string_view id) const;

  const std::optional<RobotPlacement>& robot_placement() const { return *placement_; }
  /// nullptr without one.
  const robot::RobotModel* robot() const {
    return robot_placement() ? &robot_placement()->model : nullptr;
  }
  /// X_WBase; the identity without a robot.
  const RigidTransform& robot_base_pose() const { return X_WBase_; }

  /// All that may be seen. Its frames are the world's, one per object, then the robot's base and
  /// links; its choices are per object whether it is there and its controls, then the robot's face
  /// expression.
  const scene::VisualModel& visual_model() const { return visual_model_; }
  FrameIndex frame_of(ObjectIndex object) const { return FrameIndex(1 + object); }
  /// The robot must have such a link.
  FrameIndex frame_of(LinkIndex link) const;
  /// The frame that carries a frame of the robot's description.
  FrameIndex frame_of(const robot::Frame& frame) const;
  /// The base's, then one per link; empty without a robot.
  IndexRange<FrameIndex> robot_frames() const;
  /// The object that a frame belongs to; nullopt for the world's and the robot's.
  [[nodiscard]] std::optional<ObjectIndex> object_of(FrameIndex frame) const;
  /// Whether an object is there.
  ChoiceIndex presence_of(ObjectIndex object) const {
    return ChoiceIndex(object + first_control_[object]);
  }
  ChoiceIndex choice_of(ControlIndex control) const {
    return ChoiceIndex(controls_[control].object + 1 + control);
  }

  /// The start, with what is fastened from the start where it is then.
  const SceneState& initial_state() const { return initial_state_; }
  /// The looks of an object's own controls.
  std::vector<int> LooksOf(ObjectIndex object, std::span<const ControlState> controls) const;
  /// What a moment looks like.
  /// @param q  of the robot's joints [rad or m]; empty without one.
  scene::VisualState VisualStateOf(const SceneState& state, std::span<const double> q,
                                   robot::FaceExpression face_expression) const;

 private:
  template <class I>
  using IndexOfId = std::map<std::string, I, std::less<>>;

  Model(scene::SceneSpec scene, std::shared_ptr<const std::optional<RobotPlacement>> robot);
  /// @param link  -1: the base.
  FrameIndex FrameOfLink(int link) const;
  void AddMechanismsOf(ObjectIndex object);
  /// Resolves the ids by which controls and hosts name what is downstream of them.
  void ConnectMechanisms();
  void AppendVisuals(ObjectIndex object);

  scene::SceneSpec scene_;
  std::shared_ptr<const std::optional<RobotPlacement>> placement_;  ///< never null
  RigidTransform X_WBase_;
  std::vector<Control> controls_;
  std::vector<ControlIndex> first_control_;  ///< of each object; one more at the end
  std::vector<Guest> guests_;
  std::vector<Host> hosts_;
  IndexOfId<ObjectIndex> object_of_id_;
  IndexOfId<ControlIndex> control_of_id_;
  IndexOfId<GuestIndex> guest_of_id_;
  IndexOfId<HostIndex> host_of_id_;
  scene::VisualModel visual_model_;
  SceneState initial_state_;
};

}  // namespace smile::model

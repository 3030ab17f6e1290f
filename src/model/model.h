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
#include "model/tool.h"
#include "robot/face_expression.h"
#include "scene/scene_spec.h"
#include "scene/visual_model.h"

namespace smile::model {

/// Visible state of the objects at a moment, without the robot.
struct SceneState {
  std::vector<std::optional<RigidTransform>> X_WB;  ///< of each object; nullopt if destroyed
  std::vector<ControlState> controls;               ///< by ControlIndex
  std::vector<HostState> hosts;                     ///< by HostIndex
};

/// A scene and a robot, compiled once: everything about them that does not change while they are
/// simulated, shown or compared, like MuJoCo's mjModel and Drake's MultibodyPlant. State is a plain
/// value beside it (a recording::TraceTick, a sim::SimulationState), and the appearance of such a
/// value is a pure function of both. It needs no physics world.
///
/// Immutable, and neither copied nor moved, so that any thread may read it and the pointers of its
/// Controls, Guests and Hosts into its scene stay valid. It is owned by `shared_ptr<const Model>`
/// wherever a user may outlive its maker: a running world, and pages and pictures of that world
/// that are still being made when it is replaced.
///
/// A model with more objects is another model, which has the new ones behind the old: all indices
/// of objects, controls, guests and hosts stay valid. Those of frames and choices are the model's
/// own.
class Model {
 public:
  /// Compiles a scene.
  /// @param robot  nullopt for a table without a robot.
  explicit Model(scene::SceneSpec scene, std::optional<RobotPlacement> robot = std::nullopt);
  /// Compiles another scene with the same robot, which both models share. A larger version of the
  /// scene of `other` has its additional objects behind those of `other`; see scene::Joined().
  Model(const Model& other, scene::SceneSpec scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const scene::SceneSpec& scene() const { return scene_; }

  IndexRange<ObjectIndex> objects() const { return IndexRange<ObjectIndex>(scene_.objects.size()); }
  const scene::ObjectSpec& object(ObjectIndex object) const { return scene_.objects[object]; }
  const std::string& id(ObjectIndex object) const { return scene_.objects[object].id(); }
  [[nodiscard]] std::optional<ObjectIndex> FindObject(std::string_view id) const;
  /// Returns the chain that an object is a link of; nullptr for other objects.
  const scene::ChainSpec* chain_of_link(ObjectIndex object) const;

  IndexRange<ControlIndex> controls() const { return IndexRange<ControlIndex>(controls_.size()); }
  const Control& control(ControlIndex control) const { return controls_[control]; }
  const std::vector<Control>& all_controls() const { return controls_; }
  [[nodiscard]] std::optional<ControlIndex> FindControl(std::string_view id) const;
  /// Returns the controls of an object.
  IndexRange<ControlIndex> controls_of(ObjectIndex object) const {
    return {first_control_[object], first_control_[object + 1]};
  }

  IndexRange<GuestIndex> guests() const { return IndexRange<GuestIndex>(guests_.size()); }
  const Guest& guest(GuestIndex guest) const { return guests_[guest]; }
  [[nodiscard]] std::optional<GuestIndex> FindGuest(std::string_view id) const;
  IndexRange<HostIndex> hosts() const { return IndexRange<HostIndex>(hosts_.size()); }
  const Host& host(HostIndex host) const { return hosts_[host]; }
  [[nodiscard]] std::optional<HostIndex> FindHost(std::string_view id) const;

  IndexRange<ToolIndex> tools() const { return IndexRange<ToolIndex>(tools_.size()); }
  const Tool& tool(ToolIndex tool) const { return tools_[tool]; }
  /// Returns the tool that an object is; nullopt for other objects.
  [[nodiscard]] std::optional<ToolIndex> ToolOf(ObjectIndex object) const;

  const std::optional<RobotPlacement>& robot_placement() const { return *placement_; }
  /// Returns the robot, or nullptr.
  const robot::RobotModel* robot() const {
    return robot_placement() ? &robot_placement()->model : nullptr;
  }
  /// Returns X_WBase; the identity without a robot.
  const RigidTransform& robot_base_pose() const { return X_WBase_; }

  /// Returns everything that can be visible. Its frames are the world's, one per object, then the
  /// robot's base and links; its choices are, per object, its presence and its controls, then the
  /// robot's face expression.
  const scene::VisualModel& visual_model() const { return visual_model_; }
  FrameIndex frame_of(ObjectIndex object) const { return FrameIndex(1 + object); }
  /// Returns the frame of a link, which the robot must have.
  FrameIndex frame_of(LinkIndex link) const;
  /// Returns the frame that carries a frame of the robot's description.
  FrameIndex frame_of(const robot::Frame& frame) const;
  /// Returns the frames of the base and of each link; empty without a robot.
  IndexRange<FrameIndex> robot_frames() const;
  /// Returns the object of a frame; nullopt for frames of the world and the robot.
  [[nodiscard]] std::optional<ObjectIndex> object_of(FrameIndex frame) const;
  /// Returns the choice for the presence of an object.
  ChoiceIndex presence_of(ObjectIndex object) const {
    return ChoiceIndex(object + first_control_[object]);
  }
  ChoiceIndex choice_of(ControlIndex control) const {
    return ChoiceIndex(controls_[control].object + 1 + control);
  }

  /// Returns the state at the start, with guests at their initial hosts.
  const SceneState& initial_state() const { return initial_state_; }
  /// Returns the variants of an object's own controls.
  std::vector<int> VariantsOf(ObjectIndex object, std::span<const ControlState> controls) const;
  /// Returns the visual state of a moment.
  /// @param q  of the robot's joints [rad or m]; empty without one.
  scene::VisualState VisualStateOf(const SceneState& state, std::span<const double> q,
                                   robot::FaceExpression face_expression) const;
  /// Write one object, or the robot, which the model must have, into a visual state of this model.
  /// @param X_WB  nullopt if the object is destroyed.
  void WriteObject(ObjectIndex object, const std::optional<RigidTransform>& X_WB,
                   std::span<const ControlState> controls, scene::VisualState* visual) const;
  void WriteRobot(std::span<const double> q, robot::FaceExpression face_expression,
                  scene::VisualState* visual) const;

 private:
  template <class I>
  using IndexOfId = std::map<std::string, I, std::less<>>;

  Model(scene::SceneSpec scene, std::shared_ptr<const std::optional<RobotPlacement>> robot);
  /// @param link  -1: the base.
  FrameIndex FrameOfLink(int link) const;
  void AddMechanismsOf(ObjectIndex object);
  /// Resolves the ids of downstream controls and hosts.
  void ConnectMechanisms();
  void AppendVisuals(ObjectIndex object);

  scene::SceneSpec scene_;
  std::shared_ptr<const std::optional<RobotPlacement>> placement_;  ///< never null
  RigidTransform X_WBase_;
  std::vector<Control> controls_;
  std::vector<ControlIndex> first_control_;  ///< of each object; one more at the end
  std::vector<Guest> guests_;
  std::vector<Host> hosts_;
  std::vector<Tool> tools_;
  IndexOfId<ObjectIndex> object_of_id_;
  IndexOfId<ControlIndex> control_of_id_;
  IndexOfId<GuestIndex> guest_of_id_;
  IndexOfId<HostIndex> host_of_id_;
  scene::VisualModel visual_model_;
  SceneState initial_state_;
};

}  // namespace smile::model

#include "interchange/exported_world.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/overloaded.h"
#include "base/wording.h"
#include "interchange/unique_names.h"
#include "model/eye.h"

namespace smile::interchange {
namespace {

using mechanics::BodyId;

/// Returns what is drawn of a frame now.
std::vector<scene::Visual> VisualsOfFrame(const scene::VisualModel& model,
                                          const scene::VisualState& state, std::size_t frame) {
  std::vector<scene::Visual> visuals;
  for (const scene::Visual& visual : model.visuals) {
    if (visual.frame != static_cast<int>(frame)) continue;
    const bool is_visible =
        visual.choice < 0 ||
        state.variants[static_cast<std::size_t>(visual.choice)] == visual.variant;
    if (is_visible) visuals.push_back(visual);
  }
  return visuals;
}

/// Above this distance, a joint does not yet hold its bodies together [m].
constexpr double kGap = 0.001;

/// Returns the distance of the two points that a joint holds together [m].
double GapOf(const mechanics::JointSpec& spec, const RigidTransform& X_WA,
             const RigidTransform& X_WB) {
  return std::visit(
      Overloaded{[](const mechanics::WeldSpec&) { return 0.0; },
                 [&](const mechanics::FixedJointSpec& fixed) {
                   return ((X_WA * fixed.X_AB).translation() - X_WB.translation()).norm();
                 },
                 [&](const mechanics::SliderJointSpec& slider) {
                   const Vector3 p_JK =
                       ((X_WA * slider.X_AJ).inverse() * X_WB * slider.X_BK).translation();
                   return p_JK.tail<2>().norm();
                 },
                 [&](const mechanics::BallJointSpec& ball) {
                   return (X_WA * ball.p_AQ - X_WB * ball.p_BQ).norm();
                 }},
      spec);
}

/// Collects a world.
class Collector {
 public:
  explicit Collector(const sim::RunningModel& running)
      : running_(running), model_(*running.model()), state_(running.visual_state()) {
    world_.name = model_.scene().name;
    world_.gravity = running.physics().config().gravity;
    world_.lighting = model_.scene().lighting;
    AddBodies();
    AddJoints();
    if (running.robot() != nullptr) AddRobot();
    AddCameras();
    ListLeftOut();
  }

  ExportedWorld Take() { return std::move(world_); }

 private:
  void AddBodies() {
    const mechanics::Snapshot snapshot = running_.physics().Save();
    for (const auto& entry : snapshot.bodies) {
      const world::Object* object = running_.tabletop().Find(entry.id);
      index_of_[entry.id] = static_cast<int>(world_.bodies.size());
      ExportedBody body{.spec = *entry.spec};
      body.spec.X_WB = running_.physics().body(entry.id).pose_in_world();
      if (object != nullptr) {
        body.name = names_.Take(model_.id(object->index));
        body.frame = static_cast<int>(model_.frame_of(object->index));
        body.visuals =
            VisualsOfFrame(model_.visual_model(), state_, model_.frame_of(object->index));
      } else {
        // The ground comes first: the table, which is drawn in the world's frame, then the floor.
        const bool is_table = world_.bodies.empty();
        body.name = names_.Take(is_table ? "table" : "floor");
        if (is_table) {
          body.frame = 0;
          body.visuals = VisualsOfFrame(model_.visual_model(), state_, 0);
        }
      }
      world_.bodies.push_back(std::move(body));
    }
  }

  void AddJoints() {
    for (const mechanics::Joint& joint : running_.physics().joints()) {
      const auto pair = BodyPairOf(joint.spec);
      if (!pair) {
        world_.left_out.push_back("what a gripper holds: it lies in the gripper, unheld");
        continue;
      }
      const int a = index_of_.at(pair->first), b = index_of_.at(pair->second);
      world_.joints.push_back(
          {.name = names_.Take(world_.bodies[static_cast<std::size_t>(a)].name + "_" +
                               world_.bodies[static_cast<std::size_t>(b)].name),
           .spec = joint.spec,
           .a = a,
           .b = b});
    }
  }

  void AddRobot() {
    ExportedRobot robot{.spec = running_.physics().Save().articulations.front().spec,
                        .q = running_.robot()->body().positions()};
    const auto frames = model_.robot_frames();
    auto frame = frames.begin();
    const auto link_at = [&](const std::string& name) {
      return ExportedLink{.name = names_.Take(name),
                          .frame = static_cast<int>(*frame),
                          .visuals = VisualsOfFrame(model_.visual_model(), state_, *frame)};
    };
    robot.base = link_at("robot_base");
    for (const scene::LinkSpec& link : robot.spec->links) {
      ++frame;
      robot.links.push_back(link_at(link.name));
    }
    world_.robot = std::move(robot);
  }

  void AddCameras() {
    const std::vector<double> q = world_.robot ? world_.robot->q : std::vector<double>();
    for (const std::string& name : model::CameraNames(model_)) {
      const CameraView view = model::EyeView(model_, q, {.camera = name});
      ExportedCamera camera{.name = name, .X_FC = view.X_WC, .intrinsics = view.intrinsics};
      // What a camera does not see is the link that carries it.
      const auto hidden = model::FramesHiddenFromEye(model_, /*is_robot_shown=*/true, name);
      if (world_.robot && hidden.size() == 1) {
        const int first = static_cast<int>(*model_.robot_frames().begin());
        camera.link = hidden.front() - first - 1;
        const RigidTransform& X_WF = state_.poses[static_cast<std::size_t>(hidden.front())];
        camera.X_FC = X_WF.inverse() * view.X_WC;
      }
      world_.cameras.push_back(std::move(camera));
    }
  }

  void ListLeftOut() {
    std::vector<std::string>& list = world_.left_out;
    const auto pose_of = [this](int body) {
      return world_.bodies[static_cast<std::size_t>(body)].spec.X_WB;
    };
    const auto is_open = [&](const ExportedJoint& joint) {
      return GapOf(joint.spec, pose_of(joint.a), pose_of(joint.b)) > kGap;
    };
    if (const auto count = std::ranges::count_if(world_.joints, is_open); count > 0) {
      list.push_back(std::to_string(count) +
                     " joints do not hold yet, as those of a string that has not come down: take a "
                     "later moment");
    }
    for (const model::ControlIndex index : model_.controls()) {
      const model::Control& control = model_.control(index);
      list.push_back(Quoted(control.id()) + " of " + Quoted(model_.id(control.object)) +
                     ": a control, which keeps its present form and starts nothing");
    }
    for (const model::HostIndex host : model_.hosts()) {
      list.push_back(Quoted(model_.host(host).point->id) + " of " +
                     Quoted(model_.id(model_.host(host).object)) +
                     ": a place where guests can be fastened; what is fastened now stays so");
    }
    for (const model::ToolIndex tool : model_.tools()) {
      list.push_back(Quoted(model_.id(model_.tool(tool).object)) + ": what it does as a tool");
    }
    for (const scene::ChainSpec& chain : model_.scene().chains) {
      if (chain.can_be_cut) list.push_back(Quoted(chain.id) + ": a chain that tools can cut");
    }
  }

  const sim::RunningModel& running_;
  const model::Model& model_;
  const scene::VisualState& state_;
  ExportedWorld world_;
  std::map<BodyId, int> index_of_;
  UniqueNames names_;
};

}  // namespace

Vector3 LightDirectionOf(const scene::Lighting& lighting) {
  return Eigen::AngleAxisd(lighting.turn, Vector3::UnitZ()) * Vector3(0.3, 0.4, -1);
}

ExportedWorld WorldOf(const sim::RunningModel& running) { return Collector(running).Take(); }

}  // namespace smile::interchange

#include "checkpoint/checkpoint.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/diagnostic.h"
#include "base/state_hash.h"
#include "motion/channels.h"
#include "scene/controls_of.h"
#include "scene/field_archive.h"
#include "scene/joined.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

// A state as bytes: a header with the hashes of the model and of the content, then the content.
// Each type lists its fields once, in Walk(), for writing and reading (scene/field_archive.h). What
// is read is checked against the model before a simulation sees it.

namespace smile::checkpoint {
namespace {

using sim::SimulationState;

constexpr std::array kMagic = {'S', 'M', 'I', 'L', 'E', 'S', 'I', 'M'};
/// Version of the format. Others are refused, since states are exchanged only within one build.
constexpr std::uint32_t kVersion = 1;

struct Writer : scene::FieldWriter {
  using FieldWriter::FieldWriter;
};
struct Reader : scene::FieldReader {
  using FieldReader::FieldReader;
};

void WalkFlag(Writer& writer, bool flag) { writer(static_cast<std::uint8_t>(flag)); }
void WalkFlag(Reader& reader, bool& flag) { flag = reader.bytes.Get<std::uint8_t>() != 0; }

/// The largest number stands for no index.
constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();
template <class I>
void WalkIndex(Writer& writer, const std::optional<I>& index) {
  writer(index ? static_cast<std::uint32_t>(*index) : kNoIndex);
}
template <class I>
void WalkIndex(Reader& reader, std::optional<I>& index) {
  const auto value = reader.bytes.Get<std::uint32_t>();
  index = value == kNoIndex ? std::nullopt : std::optional(I(value));
}

/// Lists of texts.
template <class Archive>
void WalkTexts(Archive& archive, std::vector<std::string>& texts) {
  texts.resize(archive.Count(texts.size()));
  for (std::string& text : texts) archive(text);
}

template <class Archive>
void Walk(Archive& archive, model::ControlState& state) {
  archive(state.state);
  archive(state.override_state);
  archive(state.position);
}
template <class Archive>
void Walk(Archive& archive, world::BondState& state) {
  WalkIndex(archive, state.guest);
  archive(state.tightness);
  WalkFlag(archive, state.is_locked);
  archive(state.joint.value);
}
template <class Archive>
void Walk(Archive& archive, world::PressState& state) {
  archive(state.release_force);
  archive(state.by.value);
  archive(state.quiet_ticks);
}
template <class Archive>
void Walk(Archive& archive, world::ToolState& state) {
  archive(state.grip);
  WalkIndex(archive, state.at);
  archive(state.angle);
}

void Walk(Writer& writer, const world::ObjectStates& states) {
  writer.Count(states.changed().size());
  for (const auto& [object, state] : states.changed()) {
    writer(static_cast<std::uint32_t>(object));
    WalkFlag(writer, state.was_raised);
    WalkFlag(writer, state.has_fallen);
  }
}
void Walk(Reader& reader, world::ObjectStates& states) {
  const std::uint32_t count = reader.Count(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const model::ObjectIndex object(reader.bytes.Get<std::uint32_t>());
    world::ObjectState state;
    WalkFlag(reader, state.was_raised);
    WalkFlag(reader, state.has_fallen);
    states.Set(object, state);
  }
}

void WalkBodies(Writer& writer, const SharedList<physics::BodyId>& bodies) {
  writer.Count(bodies.size());
  for (physics::BodyId body : bodies) writer(body.value);
}
void WalkBodies(Reader& reader, SharedList<physics::BodyId>& bodies) {
  std::vector<physics::BodyId> all(reader.Count(0));
  for (physics::BodyId& body : all) reader(body.value);
  bodies = SharedList(std::move(all));
}

template <class Archive>
void Walk(Archive& archive, world::TabletopState& state) {
  WalkEach(archive, state.controls);
  WalkEach(archive, state.bonds);
  WalkEach(archive, state.presses);
  WalkEach(archive, state.tools.tools);
  WalkEach(archive, state.tools.turned);
  Walk(archive, state.objects);
  WalkBodies(archive, state.bodies);
}

template <class Archive>
void Walk(Archive& archive, demonstrator::Hand& hand) {
  archive(hand.held.value);
  scene::Walk(archive, hand.X_WB_goal);
  scene::WalkMatrix(archive, hand.p_BH);
  archive(hand.speed);
}

void WalkAttention(Writer& writer,
                   const std::map<physics::BodyId, std::vector<std::string>>& attention) {
  writer.Count(attention.size());
  for (auto [body, properties] : attention) {
    writer(body.value);
    WalkTexts(writer, properties);
  }
}
void WalkAttention(Reader& reader, std::map<physics::BodyId, std::vector<std::string>>& attention) {
  const std::uint32_t count = reader.Count(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    physics::BodyId body;
    reader(body.value);
    WalkTexts(reader, attention[body]);
  }
}

template <class Archive>
void Walk(Archive& archive, demonstrator::DemonstratorState& state) {
  for (demonstrator::Hand& hand : state.hands) Walk(archive, hand);
  for (double& angle : state.plane_angles_deg) archive(angle);
  WalkAttention(archive, state.attention);
}

template <class Archive>
void Walk(Archive& archive, physics::JointId& joint) {
  archive(joint.value);
}
template <class Archive>
void Walk(Archive& archive, world::GripperState& gripper) {
  archive(gripper.opening_velocity);
  WalkEach(archive, gripper.welds);
}

template <class Archive>
void Walk(Archive& archive, motion::TrajectoryPoint& point) {
  archive(point.seconds);
  scene::WalkEach(archive, point.positions);
  scene::WalkEach(archive, point.velocities);
}
template <class Archive>
void Walk(Archive& archive, motion::JointTrajectory& trajectory) {
  WalkTexts(archive, trajectory.joint_names);
  WalkEach(archive, trajectory.points);
}
template <class Archive>
void Walk(Archive& archive, sim::Following::Column& column) {
  archive(column.column);
  archive(column.channel);
}
template <class Archive>
void Walk(Archive& archive, sim::Following& following) {
  Walk(archive, following.trajectory);
  archive(following.hash);
  archive(following.start_tick);
  WalkEach(archive, following.columns);
}

template <class Archive>
void Walk(Archive& archive, sim::SimulatedRobotState& state) {
  WalkEach(archive, state.body.grippers);
  WalkEach(archive, state.follower.followings);
  WalkFlag(archive, state.is_shown);
  archive(state.face_expression);
}

void WalkPhysics(Writer& writer, const mechanics::Snapshot& snapshot) {
  const std::vector<std::byte> bytes = mechanics::Serialize(snapshot);
  writer(static_cast<std::uint64_t>(bytes.size()));
  writer.bytes.PutBytes(bytes);
}
void WalkPhysics(Reader& reader, mechanics::Snapshot& snapshot) {
  snapshot = mechanics::ParseSnapshot(reader.bytes.GetBytes(reader.bytes.Get<std::uint64_t>()));
}

template <class Archive>
void WalkAllButModels(Archive& archive, SimulationState& state) {
  archive(state.tick);
  WalkPhysics(archive, state.physics);
  Walk(archive, state.tabletop);
  Walk(archive, state.demonstrator);
  Walk(archive, state.robot);
}

/// Returns the objects that were added to the scene as a text; empty if none was.
std::string AddedObjects(const SimulationState& state) {
  const scene::SceneSpec& start = state.start_model->scene();
  if (state.model->scene().objects.size() == start.objects.size()) return "";
  return scene_xml::WriteScene(scene::AddedTo(start, state.model->scene()));
}
std::shared_ptr<const model::Model> WithAdded(std::shared_ptr<const model::Model> start_model,
                                              const std::string& added) {
  if (added.empty()) return start_model;
  // A text without mesh files, as the commands that added the objects.
  scene_xml::SceneReading reading = scene_xml::ReadSceneText(added, "added objects");
  if (!reading.scene) throw InputError(std::move(reading.diagnostics));
  return std::make_shared<const model::Model>(
      *start_model, scene::Joined(start_model->scene(), *std::move(reading.scene)));
}

[[noreturn]] void Fail(const std::string& complaint) {
  throw std::invalid_argument("saved state: " + complaint);
}

/// Checks that a state fits its model.
class StateCheck {
 public:
  explicit StateCheck(const SimulationState& state) : state_(state), model_(*state.model) {
    for (const auto& entry : state.physics.bodies) bodies_.insert(entry.id);
    for (const auto& joint : state.physics.joints) joints_.insert(joint.id);
  }

  void Check() const {
    CheckSizes();
    for (model::ControlIndex i : model_.controls()) {
      const int num_states = scene::NumStatesOf(*model_.control(i).part);
      const model::ControlState& control = state_.tabletop.controls[i];
      Demand(control.state >= 0 && control.state < num_states && control.override_state >= -1 &&
             control.override_state < num_states && control.position >= 0 && control.position <= 1);
    }
    for (model::HostIndex i : model_.hosts()) {
      const world::BondState& bond = state_.tabletop.bonds[i];
      const auto num_stages = static_cast<int>(model_.host(i).point->stages.size());
      Demand(IsGuest(bond.guest) && bond.tightness >= 0 && bond.tightness <= num_stages);
      DemandJoint(bond.joint);
    }
    // Bodies that pressed controls are not checked: they may have been removed since.
    for (const world::ToolState& tool : state_.tabletop.tools.tools) {
      Demand(IsGuest(tool.at) && tool.grip >= world::ToolState::Grip::kFree &&
             tool.grip <= world::ToolState::Grip::kSqueezed);
    }
    for (const auto& [object, unused] : state_.tabletop.objects.changed()) {
      Demand(object < model_.objects().size());
    }
    for (const demonstrator::Hand& hand : state_.demonstrator.hands) DemandBody(hand.held);
    CheckRobot();
  }

 private:
  static void Demand(bool is_right) {
    if (!is_right) Fail("its content does not fit its scene");
  }
  void DemandBody(physics::BodyId body) const { Demand(!body || bodies_.contains(body)); }
  void DemandJoint(physics::JointId joint) const { Demand(!joint || joints_.contains(joint)); }
  bool IsGuest(const std::optional<model::GuestIndex>& guest) const {
    return !guest || *guest < model_.guests().size();
  }

  void CheckSizes() const {
    const world::TabletopState& tabletop = state_.tabletop;
    Demand(tabletop.controls.size() == model_.controls().size() &&
           tabletop.presses.size() == model_.controls().size() &&
           tabletop.bonds.size() == model_.hosts().size() &&
           tabletop.tools.tools.size() == model_.tools().size() &&
           tabletop.tools.turned.size() == model_.guests().size() &&
           tabletop.bodies.size() == model_.objects().size());
  }

  void CheckRobot() const {
    const robot::RobotModel* robot = model_.robot();
    const std::size_t num_arms = robot != nullptr ? robot->arms.size() : 0;
    Demand(state_.robot.body.grippers.size() == num_arms &&
           state_.robot.face_expression <= robot::FaceExpression::kDone);
    for (const world::GripperState& gripper : state_.robot.body.grippers) {
      for (physics::JointId weld : gripper.welds) DemandJoint(weld);
    }
    for (const sim::Following& following : state_.robot.follower.followings) {
      Demand(!following.trajectory->points.empty());
      const std::size_t num_columns = following.trajectory->joint_names.size();
      for (const motion::TrajectoryPoint& point : following.trajectory->points) {
        Demand(point.positions.size() == num_columns && point.velocities.size() == num_columns);
      }
      for (const sim::Following::Column& column : following.columns) {
        Demand(column.column < num_columns && robot != nullptr &&
               column.channel < motion::ChannelsOf(*robot).size());
      }
    }
  }

  const SimulationState& state_;
  const model::Model& model_;
  std::set<physics::BodyId> bodies_;
  std::set<physics::JointId> joints_;
};

std::uint64_t HashOf(std::span<const std::byte> bytes) {
  StateHash hash;
  hash.Add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  return hash.value();
}

}  // namespace

std::uint64_t ModelHash(const model::Model& model) {
  StateHash hash;
  hash.Add(std::string_view(scene_xml::WriteScene(model.scene())));
  for (const scene_xml::MeshFile& file : scene_xml::MeshFilesOf(model.scene())) {
    for (const scene::Hull& piece : file.mesh->pieces) {
      for (const Vector3& corner : piece.polyhedron().corners)
        hash.Add(std::span(corner.data(), 3));
    }
  }
  hash.Add(static_cast<std::uint64_t>(model.scene().physics_version));
  if (!model.robot_placement()) return hash.value();
  const model::RobotPlacement& robot = *model.robot_placement();
  hash.Add(std::string_view(robot.gripper));
  for (const robot::RobotFile& file : robot.files) hash.Add(std::string_view(*file.bytes));
  hash.Add(robot.gap);
  hash.Add(robot.height);
  hash.Add(std::uint64_t{robot.body.is_kinematic} +
           2 * std::uint64_t{robot.body.grasps_by_friction});
  return hash.value();
}

std::vector<std::byte> Serialize(const SimulationState& state) {
  Writer content("saved state");
  content(AddedObjects(state));
  SimulationState copy = state;  // fields are visited as for reading
  WalkAllButModels(content, copy);

  ByteWriter out;
  out.PutBytes(std::as_bytes(std::span(kMagic)));
  out.Put(kVersion);
  out.Put(ModelHash(*state.start_model));
  out.Put(HashOf(content.bytes.bytes()));
  out.PutBytes(content.bytes.bytes());
  return out.Take();
}

SimulationState ParseState(std::span<const std::byte> bytes,
                           std::shared_ptr<const model::Model> start_model) {
  ByteReader header(bytes);
  const auto magic = header.GetBytes(kMagic.size());
  if (!std::ranges::equal(magic, std::as_bytes(std::span(kMagic)))) {
    Fail("the bytes are not a state of a simulation");
  }
  const auto version = header.Get<std::uint32_t>();
  if (version != kVersion) {
    Fail("version " + std::to_string(version) + ", expected " + std::to_string(kVersion));
  }
  if (header.Get<std::uint64_t>() != ModelHash(*start_model)) {
    Fail("it belongs to another scene or robot");
  }
  const auto hash = header.Get<std::uint64_t>();
  const auto content = header.GetBytes(header.remaining());
  if (!header.ok() || hash != HashOf(content)) Fail("it is truncated or damaged");

  try {
    Reader reader("saved state", content);
    std::string added;
    reader(added);
    SimulationState state;
    state.model = WithAdded(start_model, added);
    state.start_model = std::move(start_model);
    WalkAllButModels(reader, state);
    if (!reader.bytes.ok() || reader.bytes.remaining() > 0) Fail("it has another length");
    StateCheck(state).Check();
    return state;
  } catch (const std::runtime_error& error) {
    Fail(error.what());
  }
}

}  // namespace smile::checkpoint

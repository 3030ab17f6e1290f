// Compiles a scene into flat lists with indices. The order of indices is fixed: objects as in the
// scene, the controls, guests and hosts of each object in the order of its parts. Traces, states
// and hashes rely on it.

#include "model/model.h"

#include <algorithm>
#include <utility>

#include "base/demand.h"
#include "model/internal_initial_state.h"
#include "robot/robot_visuals.h"
#include "scene/solid.h"

namespace smile::model {
namespace {

/// A variant that no visual has: no visual of the choice is visible.
constexpr int kHidden = -1;

template <class Map>
auto FindIn(const Map& index_of_id, std::string_view id)
    -> std::optional<typename Map::mapped_type> {
  const auto found = index_of_id.find(id);
  return found != index_of_id.end() ? std::optional(found->second) : std::nullopt;
}

/// Lengthens a drawn link, so that a chain has no gaps.
void Lengthen(double padding, scene::Visual* visual) {
  // Links of chains are blocks along y; only their drawing grows, not their collision shape.
  if (auto* block = std::get_if<scene::Block>(&visual->shape)) block->size.y() += 2 * padding;
}

std::uint32_t AddName(const std::string& name, scene::VisualModel* model) {
  model->object_names.push_back(name);
  return static_cast<std::uint32_t>(model->object_names.size() - 1);
}

}  // namespace

Model::Model(scene::SceneSpec scene, std::optional<RobotPlacement> robot)
    : Model(std::move(scene),
            std::make_shared<const std::optional<RobotPlacement>>(std::move(robot))) {}

Model::Model(const Model& other, scene::SceneSpec scene)
    : Model(std::move(scene), other.placement_) {}

Model::Model(scene::SceneSpec scene, std::shared_ptr<const std::optional<RobotPlacement>> robot)
    : scene_(std::move(scene)), placement_(std::move(robot)) {
  // All controls and hosts must exist before ids between them can be resolved.
  for (ObjectIndex object : objects()) AddMechanismsOf(object);
  // One entry beyond the last object, so that controls_of() needs no special case.
  first_control_.emplace_back(controls_.size());
  ConnectMechanisms();

  visual_model_.lighting = scene_.lighting;
  // The order of names gives the ids of objects in pictures: the table, then objects, then the
  // robot.
  const std::uint32_t table = AddName("table", &visual_model_);
  for (scene::Visual& visual : scene::VisualsOf(scene_.table)) {
    visual.object_id = table;
    visual_model_.visuals.push_back(std::move(visual));
  }
  for (ObjectIndex object : objects()) AppendVisuals(object);
  if (const auto& placement = robot_placement()) {
    X_WBase_ = RobotBasePose(scene_.table, placement->gap, placement->height);
    robot::AppendVisuals(placement->model, static_cast<int>(*robot_frames().begin()),
                         AddName("robot", &visual_model_), &visual_model_);
  }
  // Last: it needs everything else.
  initial_state_ = InitialStateOf(*this);
}

void Model::AddMechanismsOf(ObjectIndex object) {
  const scene::Part& whole = scene_.objects[object].whole;
  // Ids are unique in valid scenes; the reader checks that.
  object_of_id_.insert_or_assign(whole.id, object);
  first_control_.emplace_back(controls_.size());
  for (const scene::Part* part : scene::ControlsOf(whole)) {
    control_of_id_.insert_or_assign(part->id, ControlIndex(controls_.size()));
    controls_.push_back({.part = part, .object = object});
  }
  for (const auto& [point, X_BG] : scene::GuestsOf(whole)) {
    guest_of_id_.insert_or_assign(point->id, GuestIndex(guests_.size()));
    guests_.push_back({.point = point, .object = object, .X_BG = X_BG});
  }
  for (const auto& [point, X_BH] : scene::HostsOf(whole)) {
    host_of_id_.insert_or_assign(point->id, HostIndex(hosts_.size()));
    hosts_.push_back({.point = point, .object = object, .X_BH = X_BH});
  }
  if (const auto& tool = scene_.objects[object].tool) {
    tools_.push_back({.spec = &*tool, .object = object});
  }
}

void Model::ConnectMechanisms() {
  for (Control& control : controls_) {
    for (const std::string& id : scene::DownstreamOf(*control.part)) {
      // Ids that name nothing are ignored here; the reader of scenes reports them.
      if (const auto driven = FindControl(id)) control.downstream.push_back(*driven);
    }
  }
  for (Host& host : hosts_) {
    host.downstream = FindControl(host.point->downstream);
    host.downstream_override = FindControl(host.point->downstream_override);
    host.downstream_lock = FindHost(host.point->downstream_lock);
  }
}

void Model::AppendVisuals(ObjectIndex object) {
  const std::uint32_t object_id = AddName(id(object), &visual_model_);
  const int presence = static_cast<int>(presence_of(object));
  const scene::ChainSpec* chain = chain_of_link(object);
  for (scene::Visual visual : scene::VisualsOf(scene_.objects[object].whole)) {
    visual.frame = static_cast<int>(frame_of(object));
    visual.object_id = object_id;
    // The object's own choices follow its presence; visuals without a choice depend on presence
    // only.
    visual.choice = visual.choice < 0 ? presence : presence + 1 + visual.choice;
    if (chain != nullptr) Lengthen(chain->link_padding, &visual);
    visual_model_.visuals.push_back(std::move(visual));
  }
  ++visual_model_.num_frames;
  visual_model_.num_choices += 1 + static_cast<int>(controls_of(object).size());
}

std::optional<ObjectIndex> Model::FindObject(std::string_view id) const {
  return FindIn(object_of_id_, id);
}

std::optional<ControlIndex> Model::FindControl(std::string_view id) const {
  return FindIn(control_of_id_, id);
}

std::optional<GuestIndex> Model::FindGuest(std::string_view id) const {
  return FindIn(guest_of_id_, id);
}

std::optional<HostIndex> Model::FindHost(std::string_view id) const {
  return FindIn(host_of_id_, id);
}

std::optional<ToolIndex> Model::ToolOf(ObjectIndex object) const {
  for (const ToolIndex tool : tools()) {
    if (tools_[tool].object == object) return tool;
  }
  return std::nullopt;
}

const scene::ChainSpec* Model::chain_of_link(ObjectIndex object) const {
  for (const scene::ChainSpec& chain : scene_.chains) {
    // Its two ends come first.
    const std::size_t first_link = chain.first_object + 2;
    if (first_link <= object && object < first_link + chain.link_ids.size()) return &chain;
  }
  return nullptr;
}

FrameIndex Model::frame_of(LinkIndex link) const { return FrameOfLink(static_cast<int>(link)); }

FrameIndex Model::frame_of(const robot::Frame& frame) const { return FrameOfLink(frame.link); }

/// The robot's frames follow those of all objects.
FrameIndex Model::FrameOfLink(int link) const {
  return FrameIndex(*robot_frames().begin() + static_cast<std::size_t>(robot::VisualFrameOf(link)));
}

IndexRange<FrameIndex> Model::robot_frames() const {
  const FrameIndex first(1 + scene_.objects.size());
  const auto num_frames =
      static_cast<std::size_t>(robot() != nullptr ? robot::NumVisualFrames(*robot()) : 0);
  return {first, FrameIndex(first + num_frames)};
}

std::optional<ObjectIndex> Model::object_of(FrameIndex frame) const {
  const bool is_objects = frame > 0 && frame <= scene_.objects.size();
  return is_objects ? std::optional(ObjectIndex(frame - 1)) : std::nullopt;
}

std::vector<int> Model::VariantsOf(ObjectIndex object,
                                   std::span<const ControlState> controls) const {
  std::vector<int> variants;
  for (ControlIndex control : controls_of(object)) {
    variants.push_back(VariantOf(controls_[control], controls[control]));
  }
  return variants;
}

scene::VisualState Model::VisualStateOf(const SceneState& state, std::span<const double> q,
                                        robot::FaceExpression face_expression) const {
  scene::VisualState visual;
  visual.poses.resize(static_cast<std::size_t>(visual_model_.num_frames));
  visual.variants.resize(static_cast<std::size_t>(visual_model_.num_choices));
  for (ObjectIndex object : objects()) {
    WriteObject(object, state.X_WB[object], state.controls, &visual);
  }
  if (robot() != nullptr) WriteRobot(q, face_expression, &visual);
  return visual;
}

void Model::WriteObject(ObjectIndex object, const std::optional<RigidTransform>& X_WB,
                        std::span<const ControlState> controls, scene::VisualState* visual) const {
  // A missing object still has a frame; all of its visuals are hidden.
  visual->poses[frame_of(object)] = X_WB.value_or(RigidTransform());
  visual->variants[presence_of(object)] = X_WB ? 0 : kHidden;
  for (ControlIndex control : controls_of(object)) {
    visual->variants[choice_of(control)] =
        X_WB ? VariantOf(controls_[control], controls[control]) : kHidden;
  }
}

void Model::WriteRobot(std::span<const double> q, robot::FaceExpression face_expression,
                       scene::VisualState* visual) const {
  std::ranges::copy(robot::FramePosesOf(*robot(), X_WBase_, q),
                    visual->poses.begin() + static_cast<std::ptrdiff_t>(*robot_frames().begin()));
  // Its choice is the last one.
  visual->variants.back() = robot::VariantOf(face_expression);
}

}  // namespace smile::model

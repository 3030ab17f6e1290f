#include "world/tools.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/wording.h"
#include "math/angles.h"
#include "physics/solid_probe.h"
#include "world/overlap.h"

// Tools. What a tool is at follows from poses only: cut tools take the nearest thing at their
// blades, all others the nearest place of their type. Only how far a screw was turned is kept.

namespace smile::world {

using texts::Say;
namespace {

using scene::ToolAction;

/// A turn counts when less than this is missing [rad]: hands and wrists arrive within half a
/// degree.
constexpr double kAlmost = DegreesToRadians(2.0);

/// Returns the distance of two segments, seen from the second one. Source: C. Ericson, Real-Time
/// Collision Detection (2005), 5.1.9.
Tools::Offset SegmentOffset(const Vector3& p1, const Vector3& q1, const Vector3& p2,
                            const Vector3& q2) {
  const Vector3 d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
  const auto fraction = [](double over, double under) {
    return under > 0 ? std::clamp(over / under, 0.0, 1.0) : 0.0;
  };
  const double b = d1.dot(d2), c = d1.dot(r);
  double s = fraction(b * f - c * e, a * e - b * b);
  double t = e > 0 ? (b * s + f) / e : 0.0;
  // Outside of the second segment, its end is the nearest, and the first point follows.
  if (t < 0 || t > 1 || e == 0) {
    t = std::clamp(t, 0.0, 1.0);
    s = fraction(t * b - c, a);
  }
  const Vector3 offset = p1 + s * d1 - p2 - t * d2;
  return {.distance = offset.norm(), .direction = offset};
}

/// Returns the distance of a segment from a solid, whose pose is in the world, to within 2 mm; at
/// most 0.1 m. It is seen from the middle of the solid.
Tools::Offset OffsetFrom(const Vector3& p_WT, const Vector3& p_WTip, const scene::Solid& solid) {
  constexpr double kFar = 0.1, kStep = 0.004;  // [m]
  constexpr int kMaxSteps = 200;
  // A ball around a point of the segment overlaps the solid by what it is larger than the distance.
  physics::SolidProbe probe(
      {{.shape = scene::Sphere{kFar}, .X_BS = {}, .color = {}, .part_id = ""}, solid});
  const double length = (p_WTip - p_WT).norm();
  const int count = std::clamp(static_cast<int>(length / kStep), 1, kMaxSteps);
  double distance = kFar;
  Vector3 nearest = p_WT;
  for (int i = 0; i <= count; ++i) {
    const Vector3 p = p_WT + (p_WTip - p_WT) * i / count;
    probe.SetPose(0, RigidTransform(p));
    const double here = std::max(0.0, kFar - probe.Depth(0, 1));
    if (here >= distance) continue;
    distance = here;
    nearest = p;
  }
  return {.distance = distance, .direction = nearest - solid.X_BS.translation()};
}

/// Returns in which direction a tool is from what it does not reach: a person cannot see that in
/// the picture.
std::string SideOf(const Vector3& direction) {
  if (std::abs(direction.z()) < direction.head<2>().norm()) return "beside";
  return direction.z() > 0 ? "above" : "below";
}

/// Returns the displacement that takes a tool to what it does not reach, in units: for people who
/// type numbers.
/// @param direction  of the tool from it [m].
std::string DisplacementTo(const Vector3& direction, double meters_per_unit) {
  std::string text;
  for (const int axis : {0, 1, 2}) {
    // Adding 0 makes -0 a 0.
    const double units = std::round(-direction[axis] / meters_per_unit * 100) / 100 + 0.0;
    text += (axis == 0 ? "(" : ",") + NumberText(units);
  }
  return text + ")";
}

/// Returns a direction perpendicular to a unit vector; a function of it alone.
Vector3 Perpendicular(const Vector3& n) {
  Eigen::Index least = 0;
  n.cwiseAbs().minCoeff(&least);
  return n.cross(Vector3::Unit(least)).normalized();
}

double RoundedUnits(double meters, double meters_per_unit) {
  return std::round(meters / meters_per_unit * 100) / 100;
}

/// Rounded up: what is too far does not look like the limit.
double UnitsRoundedUp(double meters, double meters_per_unit) {
  return std::ceil(meters / meters_per_unit * 100 - 1e-6) / 100;
}

}  // namespace

Tools::Tools(physics::World* world, const model::Model& model, const std::vector<Object>* objects,
             const ObjectStates* object_states, Controls* controls, Bonds* bonds)
    : world_(world),
      model_(&model),
      objects_(objects),
      object_states_(object_states),
      controls_(controls),
      bonds_(bonds) {
  Grow(model);
}

void Tools::Grow(const model::Model& model) {
  model_ = &model;
  state_.tools.resize(model.tools().size());
  // Without tools nothing is ever turned.
  state_.turned.resize(is_empty() ? 0 : model.guests().size());
}

void Tools::Restore(ToolsState state, const model::Model& model) {
  state_ = std::move(state);
  model_ = &model;
}

std::vector<Tools::Candidate> Tools::CutsByDistance(model::ToolIndex tool) const {
  const model::Tool& which = model_->tool(tool);
  const scene::ToolSpec& spec = *which.spec;
  const RigidTransform X_WB = PoseOf(which.object);
  const Vector3 p_WT = X_WB * spec.p_BT;
  const Vector3 p_WTip = X_WB * (spec.p_BT + spec.edge * spec.axis.normalized());
  std::vector<Candidate> candidates;
  AppendChainCuts(p_WT, p_WTip, &candidates);
  AppendBondCuts(p_WT, p_WTip, &candidates);
  AppendPartCuts(p_WT, p_WTip, &candidates);
  std::erase_if(candidates, [&](const Candidate& one) {
    // A tool does not cut itself.
    return one.use.object == which.object;
  });
  for (Candidate& one : candidates) one.use.tool = tool;
  // Stable: the first one in the order of the scene wins a tie.
  std::ranges::stable_sort(candidates, {},
                           [](const Candidate& one) { return one.offset.distance; });
  return candidates;
}

std::optional<ToolUse> Tools::CutTarget(model::ToolIndex tool, Refusal* refusal) const {
  const model::Tool& which = model_->tool(tool);
  const std::vector<Candidate> cuts = CutsByDistance(tool);
  if (cuts.empty()) {
    *refusal = Say("tools.nothingToCut", {{"tool", NameOf(which.object)}});
    return std::nullopt;
  }
  const Candidate& nearest = cuts.front();
  if (nearest.offset.distance > which.spec->reach) {
    const double unit = model_->scene().meters_per_unit;
    *refusal =
        Say("tools.bladesAreFar", {{"tool", NameOf(which.object)},
                                   {"distance", UnitsRoundedUp(nearest.offset.distance, unit)},
                                   {"target", nearest.use.target},
                                   {"side", SideOf(nearest.offset.direction)},
                                   {"displacement", DisplacementTo(nearest.offset.direction, unit)},
                                   {"reach", RoundedUnits(which.spec->reach, unit)}});
    return std::nullopt;
  }
  return nearest.use;
}

void Tools::AppendChainCuts(const Vector3& p_WT, const Vector3& p_WTip,
                            std::vector<Candidate>* candidates) const {
  std::map<std::pair<physics::BodyId, physics::BodyId>, const physics::Joint*> balls;
  for (const physics::Joint& joint : world_->joints()) {
    if (const auto* ball = std::get_if<physics::BallJointSpec>(&joint.spec)) {
      balls[{ball->a, ball->b}] = &joint;
    }
  }
  for (const scene::ChainSpec& chain : model_->scene().chains) {
    if (!chain.can_be_cut) continue;
    const std::size_t first_link = chain.first_object + 2, count = chain.link_ids.size();
    for (std::size_t i = 0; i <= count; ++i) {
      const ObjectIndex a(i == 0 ? chain.first_object : first_link + i - 1);
      const ObjectIndex b(i == count ? chain.first_object + 1 : first_link + i);
      const auto joint = balls.find({(*objects_)[a].body, (*objects_)[b].body});
      // Cut already, or a piece was destroyed.
      if (joint == balls.end()) continue;
      // Blades on half of either link part it at the joint between them.
      const auto& ball = std::get<physics::BallJointSpec>(joint->second->spec);
      const Vector3 p_WJ = PoseOf(a) * ball.p_AQ;
      const Offset from_a = SegmentOffset(p_WT, p_WTip, p_WJ, PoseOf(a).translation());
      const Offset from_b = SegmentOffset(p_WT, p_WTip, p_WJ, PoseOf(b).translation());
      const std::string before = i == 0 ? "start" : "link " + std::to_string(i - 1);
      const std::string after = i == count ? "end" : (i == 0 ? "link " : "") + std::to_string(i);
      candidates->push_back({from_b.distance < from_a.distance ? from_b : from_a,
                             {.verb = "cut",
                              .object = i == 0 ? b : a,
                              .target = chain.id + " between " + before + " and " + after,
                              .joint = joint->second->id}});
    }
  }
}

void Tools::AppendBondCuts(const Vector3& p_WT, const Vector3& p_WTip,
                           std::vector<Candidate>* candidates) const {
  for (const GuestIndex guest : model_->guests()) {
    const model::Guest& plug = model_->guest(guest);
    const auto host = bonds_->HostOf(guest);
    if (!plug.point->can_be_cut || !host || !IsInPlay(plug.object)) continue;
    const Vector3 p_WG = PoseOf(plug.object) * plug.X_BG.translation();
    candidates->push_back(
        {SegmentOffset(p_WT, p_WTip, p_WG, p_WG),
         {.verb = "cut",
          .object = plug.object,
          .target = NameOf(plug.object) + " from " + NameOf(model_->host(*host).object),
          .guest = guest}});
  }
}

void Tools::AppendPartCuts(const Vector3& p_WT, const Vector3& p_WTip,
                           std::vector<Candidate>* candidates) const {
  for (const ObjectIndex object : model_->objects()) {
    const auto controls = model_->controls_of(object);
    if (controls.size() == 0 || !IsInPlay(object)) continue;
    const RigidTransform X_WB = PoseOf(object);
    for (scene::Solid solid : scene::SolidsWith(model_->VariantsOf(object, controls_->states()),
                                                scene::SolidsOf(model_->object(object).whole))) {
      if (!solid.trigger || solid.trigger->rule.cause != scene::TriggerCause::kCut) continue;
      solid.X_BS = X_WB * solid.X_BS;
      const model::ControlIndex control(*controls.begin() +
                                        static_cast<std::size_t>(solid.control));
      candidates->push_back(
          {OffsetFrom(p_WT, p_WTip, solid),
           {.verb = "cut",
            .object = object,
            .target = solid.part_id.empty() ? model_->control(control).id() : solid.part_id,
            .control = control,
            .next_state = solid.trigger->next_state}});
    }
  }
}

std::optional<Tools::Candidate> Tools::NearestGuest(model::ToolIndex tool, double* angle) const {
  const model::Tool& which = model_->tool(tool);
  const scene::ToolSpec& spec = *which.spec;
  const RigidTransform X_WB = PoseOf(which.object);
  const Vector3 p_WT = X_WB * spec.p_BT, axis = X_WB.rotation() * spec.axis.normalized();
  std::optional<Candidate> nearest;
  for (const GuestIndex guest : model_->guests()) {
    const model::Guest& plug = model_->guest(guest);
    if (!IsInPlay(plug.object) || plug.object == which.object) continue;
    const RigidTransform X_WG = PoseOf(plug.object) * plug.X_BG;
    for (const scene::ToolPlace& place : plug.point->accepts) {
      if (place.type != spec.type) continue;
      const Vector3 offset = p_WT - X_WG * place.p_GS;
      const double distance = offset.norm();
      if (nearest && distance >= nearest->offset.distance) continue;
      nearest = Candidate{
          .offset = {.distance = distance, .direction = offset},
          .use = {
              .tool = tool, .object = plug.object, .target = NameOf(plug.object), .guest = guest}};
      const double cosine = -axis.dot(X_WG.rotation() * place.axis.normalized());
      *angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    }
  }
  return nearest;
}

std::optional<Refusal> Tools::RefuseOtherType(model::ToolIndex tool) const {
  const model::Tool& which = model_->tool(tool);
  const scene::ToolSpec& spec = *which.spec;
  const Vector3 p_WT = PoseOf(which.object) * spec.p_BT;
  std::optional<Refusal> refusal;
  for (const GuestIndex guest : model_->guests()) {
    const model::Guest& plug = model_->guest(guest);
    if (!IsInPlay(plug.object) || plug.object == which.object) continue;
    const RigidTransform X_WG = PoseOf(plug.object) * plug.X_BG;
    for (const scene::ToolPlace& place : plug.point->accepts) {
      if (place.type == spec.type || (p_WT - X_WG * place.p_GS).norm() > spec.reach) continue;
      refusal = Say("tools.otherType", {{"object", NameOf(plug.object)},
                                        {"expected", place.type},
                                        {"tool", NameOf(which.object)},
                                        {"type", spec.type}});
    }
  }
  return refusal;
}

std::optional<ToolUse> Tools::BondTarget(model::ToolIndex tool, Refusal* refusal) const {
  const model::Tool& which = model_->tool(tool);
  const scene::ToolSpec& spec = *which.spec;
  double angle = 0;
  const auto nearest = NearestGuest(tool, &angle);
  const bool is_near = nearest && nearest->offset.distance <= spec.reach;
  if (is_near && angle <= spec.angle) return nearest->use;
  const double unit = model_->scene().meters_per_unit;
  if (auto other_type = RefuseOtherType(tool)) {
    *refusal = *std::move(other_type);
  } else if (!nearest) {
    *refusal = Say("tools.nothingOfType", {{"type", spec.type}});
  } else if (!is_near) {
    *refusal =
        Say("tools.tipIsFar", {{"tool", NameOf(which.object)},
                               {"distance", UnitsRoundedUp(nearest->offset.distance, unit)},
                               {"object", nearest->use.target},
                               {"side", SideOf(nearest->offset.direction)},
                               {"displacement", DisplacementTo(nearest->offset.direction, unit)},
                               {"reach", RoundedUnits(spec.reach, unit)}});
  } else {
    *refusal =
        Say("tools.isTilted", {{"tool", NameOf(which.object)},
                               {"degrees", std::round(RadiansToDegrees(angle))},
                               {"object", nearest->use.target},
                               {"limit", std::round(RadiansToDegrees(spec.angle) * 10) / 10}});
  }
  return std::nullopt;
}

bool Tools::HasRoom(const Candidate& cut) const {
  const ObjectIndex object = model_->tool(cut.use.tool).object;
  const RigidTransform X_WB = PoseOf(object);
  const RigidTransform X_there(X_WB.rotation(), X_WB.translation() - cut.offset.direction);
  const auto overlaps = world_->OverlapsAt((*objects_)[object].body, X_there, kMaxOverlap);
  return std::ranges::none_of(overlaps.bodies, [this](physics::BodyId blocker) {
    return world_->body(blocker).is_static();
  });
}

std::optional<WorkPlace> Tools::NearestWork(model::ToolIndex tool) const {
  double angle = 0;
  std::optional<Candidate> nearest;
  if (model_->tool(tool).spec->action == ToolAction::kCut) {
    const std::vector<Candidate> cuts = CutsByDistance(tool);
    const auto free = std::ranges::find_if(cuts, [this](const auto& cut) { return HasRoom(cut); });
    if (!cuts.empty()) nearest = free == cuts.end() ? cuts.front() : *free;
  } else {
    nearest = NearestGuest(tool, &angle);
  }
  if (!nearest) return std::nullopt;
  return WorkPlace{.target = nearest->use.target, .displacement = -nearest->offset.direction};
}

std::optional<ToolUse> Tools::PlanUse(model::ToolIndex tool, bool loosens, Refusal* refusal) const {
  const ToolAction action = model_->tool(tool).spec->action;
  if (action == ToolAction::kCut) {
    auto use = CutTarget(tool, refusal);
    if (use && use->control && !controls_->CanPress(*use->control, use->next_state)) {
      *refusal = Say("tools.leadsNowhere", {{"part", use->target}});
      return std::nullopt;
    }
    return use;
  }
  auto target = BondTarget(tool, refusal);
  if (!target) return std::nullopt;
  const bool is_looser = action == ToolAction::kLoosen || (action == ToolAction::kDrive && loosens);
  return PlanStage(*std::move(target), is_looser ? -1 : 1, refusal);
}

std::optional<ToolUse> Tools::PlanStage(ToolUse target, int direction, Refusal* refusal) const {
  const physics::BodyId body = (*objects_)[model_->tool(target.tool).object].body;
  target.turn = bonds_->PlanTurn(*target.guest, direction, body, refusal);
  if (!target.turn) return std::nullopt;
  target.verb = direction > 0 ? "fasten" : "loosen";
  return target;
}

void Tools::Use(const ToolUse& use) {
  if (use.turn) {
    bonds_->Turn(*use.turn);
    state_.turned[*use.guest] = 0;
    // The stage has turned the guest, not the tool.
    ToolState& state = state_.tools[use.tool];
    if (state.at == use.guest) state.angle = AngleAt(use.tool, *use.guest);
    return;
  }
  if (use.joint) world_->RemoveJoint(use.joint);
  if (use.guest) bonds_->End(*bonds_->HostOf(*use.guest));
  if (use.control) controls_->Press(*use.control, use.next_state);
}

std::vector<ToolUse> Tools::PossibleUses(const std::vector<Holder>& holders) const {
  std::vector<ToolUse> uses;
  for (const model::ToolIndex tool : model_->tools()) {
    const Holder* holder = HolderOf(tool, holders);
    if (holder == nullptr) continue;
    const bool has_two_directions = model_->tool(tool).spec->action == ToolAction::kDrive;
    for (const bool loosens : {false, true}) {
      if (loosens && !has_two_directions) continue;
      Refusal refusal;
      if (auto use = PlanUse(tool, loosens, &refusal)) {
        use->arm = holder->arm;
        uses.push_back(*std::move(use));
      }
    }
  }
  return uses;
}

double Tools::AngleAt(model::ToolIndex tool, GuestIndex guest) const {
  const model::Tool& which = model_->tool(tool);
  const model::Guest& plug = model_->guest(guest);
  const RigidTransform X_WG = PoseOf(plug.object) * plug.X_BG;
  // About the direction into the work: seen from behind the tool, clockwise is positive.
  const auto place =
      std::ranges::find(plug.point->accepts, which.spec->type, &scene::ToolPlace::type);
  const Vector3 into = -place->axis.normalized();
  const Vector3 first = Perpendicular(into), second = into.cross(first);
  const Vector3 mark = X_WG.rotation().transpose() * (PoseOf(which.object).rotation() *
                                                      Perpendicular(which.spec->axis.normalized()));
  return std::atan2(mark.dot(second), mark.dot(first));
}

std::optional<ToolUse> Tools::Turn(model::ToolIndex tool, Refusal* refusal) {
  ToolState& state = state_.tools[tool];
  Refusal not_at;
  std::optional<ToolUse> use = BondTarget(tool, &not_at);
  if (!use || use->guest != state.at) {
    state.at = use ? use->guest : std::nullopt;
    state.angle = use ? AngleAt(tool, *use->guest) : 0;
    return std::nullopt;
  }
  const GuestIndex guest = *use->guest;
  const double now = AngleAt(tool, guest);
  double& turned = state_.turned[guest];
  turned += std::remainder(now - state.angle, 2 * std::numbers::pi);
  state.angle = now;
  const double turn = model_->tool(tool).spec->turn;
  if (std::abs(turned) < turn - kAlmost) return std::nullopt;
  const int direction = turned > 0 ? 1 : -1;
  // What remains counts for the next stage, also when this one is refused: the tool spins.
  turned -= direction * turn;
  use = PlanStage(*std::move(use), direction, refusal);
  if (!use) return std::nullopt;
  bonds_->Turn(*use->turn);
  // The stage has turned the guest.
  state.angle = AngleAt(tool, guest);
  return use;
}

const Holder* Tools::HolderOf(model::ToolIndex tool, const std::vector<Holder>& holders) const {
  const ObjectIndex object = model_->tool(tool).object;
  if (!IsInPlay(object)) return nullptr;
  const auto holder = std::ranges::find(holders, (*objects_)[object].body, &Holder::body);
  return holder == holders.end() ? nullptr : &*holder;
}

std::vector<ToolUse> Tools::AfterTick(const std::vector<Holder>& holders,
                                      std::vector<Refusal>* refusals) {
  std::vector<ToolUse> uses;
  for (const model::ToolIndex tool : model_->tools()) {
    ToolState& state = state_.tools[tool];
    const model::Tool& which = model_->tool(tool);
    const Holder* holder = HolderOf(tool, holders);
    if (holder == nullptr) {
      state = {};
      continue;
    }
    const auto before = state.grip;
    state.grip = holder->is_squeezing ? ToolState::Grip::kSqueezed : ToolState::Grip::kHeld;
    Refusal refusal;
    std::optional<ToolUse> use;
    if (which.spec->action == ToolAction::kDrive) {
      use = Turn(tool, &refusal);
    } else if (before == ToolState::Grip::kHeld && state.grip == ToolState::Grip::kSqueezed) {
      // The grasp itself closes the gripper, too: only closing it again is a use.
      use = PlanUse(tool, /*loosens=*/false, &refusal);
      if (use) Use(*use);
    }
    if (use) {
      use->arm = holder->arm;
      uses.push_back(*use);
    } else if (!refusal.empty()) {
      refusals->push_back(std::move(refusal));
    }
  }
  return uses;
}

void Tools::AddToHash(StateHash* hash) const {
  for (std::size_t i = 0; i < state_.tools.size(); ++i) {
    const ToolState& tool = state_.tools[i];
    if (tool == ToolState()) continue;
    hash->Add(std::uint64_t{i});
    hash->Add(static_cast<std::uint64_t>(tool.grip));
    hash->Add(tool.at ? std::uint64_t{*tool.at} : ~std::uint64_t{0});
    hash->Add(tool.angle);
  }
  for (std::size_t i = 0; i < state_.turned.size(); ++i) {
    if (state_.turned[i] == 0) continue;
    hash->Add(std::uint64_t{i});
    hash->Add(state_.turned[i]);
  }
}

}  // namespace smile::world

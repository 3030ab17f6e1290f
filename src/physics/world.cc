#include "physics/world.h"

#include <stdexcept>
#include <utility>

#include "base/bytes.h"
#include "base/state_hash.h"
#include "mechanics/joint_graph.h"
#include "physics/internal_body_dynamics.h"
#include "physics/internal_engine.h"
#include "physics/internal_exempt_pairs.h"
#include "physics/internal_held_bodies.h"
#include "physics/internal_joint_action.h"
#include "physics/internal_joint_set.h"
#include "physics/internal_queries.h"
#include "physics/internal_world_objects.h"

// The world is a facade: each part (objects, held bodies, joints, exemptions) keeps one kind of
// state, with its share of saving, restoring and hashing. The order of these calls is the same
// everywhere, as it is the order of bytes in a snapshot.

namespace smile::physics {

World::World(const WorldConfig& config)
    : config_(config),
      engine_(std::make_unique<Engine>(config_)),
      objects_(std::make_unique<WorldObjects>(config_, *engine_)),
      held_bodies_(std::make_unique<HeldBodies>(config_, *objects_, *engine_)),
      joints_(std::make_unique<JointSet>(*objects_, *held_bodies_, *engine_)),
      exempt_pairs_(std::make_unique<ExemptPairs>(*objects_, *engine_)),
      exemptions_(std::make_unique<mechanics::CollisionExemptions>(
          exempt_pairs_.get(), ExactWorld::kCloseFitPlay, config_.eases_close_fits)) {}

World::~World() = default;

/// Returns a part of the world for a call that changes what there is, or what may collide: all
/// islands are then in Bullet's world.
template <class Part>
Part& World::Changing(const std::unique_ptr<Part>& part) {
  engine_->dormant_islands.ReturnAll();
  return *part;
}

BodyId World::AddBody(const BodySpec& spec) { return Changing(objects_).AddBody(spec); }

/// Joints and exemptions refer to the body, so they end first.
void World::RemoveBody(BodyId id) {
  Changing(joints_).RemoveAllOf(id);
  exemptions_->EndAllOf(id);
  objects_->RemoveBody(id);
}

ArticulationId World::AddArticulation(const scene::ArticulationSpec& spec) {
  return Changing(objects_).AddArticulation(spec);
}

void World::ChangeForm(BodyId id, const std::vector<scene::Solid>& solids,
                       const scene::MassProperties& mass) {
  Changing(objects_).ChangeForm(id, solids, mass);
  // Bullet's object of the body is another one now.
  joints_->Rejoin(id);
}

JointId World::AddJoint(const JointSpec& spec) { return Changing(joints_).Add(spec); }
void World::RemoveJoint(JointId id) { Changing(joints_).Remove(id); }
const std::vector<Joint>& World::joints() const { return joints_->joints(); }

std::vector<BodyId> World::Assembly(BodyId id, JointId without) const {
  return mechanics::AssemblyOf(id, joints(), without,
                               [this](BodyId other) { return body(other).is_static(); });
}

bool World::IsAnchored(BodyId id, JointId without) const {
  return mechanics::IsAnchored(id, joints(), without,
                               [this](BodyId other) { return body(other).is_static(); });
}

void World::MoveAssembly(BodyId id, const RigidTransform& X_WB) {
  const RigidTransform X_moved = X_WB * body(id).pose_in_world().inverse();
  for (BodyId member : Assembly(id)) {
    Body& one = body(member);
    one.SetPose(member == id ? X_WB : X_moved * one.pose_in_world());
  }
}

void World::IgnoreCollisionUntilSeparated(BodyId a, BodyId b) {
  Changing(exemptions_).IgnoreUntilSeparated(a, b);
}

Overlaps World::OverlapsAt(BodyId id, const RigidTransform& X_WB, double depth) const {
  return FindOverlaps(body(id), X_WB, depth, *objects_, *engine_);
}

Overlaps World::OverlapsOf(const std::vector<scene::Solid>& solids, const RigidTransform& X_WB,
                           double depth) const {
  // Static, so that it needs no mass; with an empty id, to which no exclusion applies.
  const Body imagined(BodyId(), std::make_shared<const BodySpec>(BodySpec{.solids = solids}));
  return FindOverlaps(imagined, X_WB, depth, *objects_, *engine_);
}

bool World::Has(BodyId id) const { return objects_->Find(id) != nullptr; }
Body& World::body(BodyId id) { return objects_->body(id); }
const Body& World::body(BodyId id) const { return objects_->body(id); }
Articulation& World::articulation(ArticulationId id) { return objects_->articulation(id); }
const Articulation& World::articulation(ArticulationId id) const {
  return objects_->articulation(id);
}

std::vector<LinkContact> World::ContactsWith(ArticulationId id, int link) const {
  return FindContacts(articulation(id), link, *objects_, *engine_);
}

std::vector<Push> World::PushesOn(std::span<const BodyId> ids) const {
  return FindPushes(ids, *objects_, *engine_);
}

std::vector<BodyId> World::BodiesTouching(BodyId id) const {
  return FindTouchingBodies(body(id), *objects_);
}

std::vector<BodyId> World::awake_bodies() const {
  std::vector<BodyId> awake;
  if (engine_->dormant_islands.AllSleep()) return awake;
  objects_->ForEachPresent([&awake](const Body& body) {
    if (body.is_awake()) awake.push_back(body.id());
  });
  return awake;
}

Moment World::now() const {
  Moment now = engine_->dormant_islands.now();
  now.num_removals = objects_->num_removals();
  return now;
}

std::vector<BodyId> World::BodiesChangedSince(const Moment& moment) const {
  std::vector<BodyId> changed;
  for (std::size_t i : objects_->NumbersChangedSince(moment)) {
    changed.push_back(objects_->bodies()[i]->id());
  }
  return changed;
}

bool World::HasRemovedSince(const Moment& moment) const {
  return moment.num_removals != objects_->num_removals();
}

bool World::is_at_rest() const { return objects_->is_at_rest(); }
void World::WakeAll() { Changing(objects_).WakeAll(); }

void World::Step() {
  // The condition depends on saved state only, so a replay skips the same steps.
  if (is_at_rest()) return;
  // Prepare: masses and forces of this step, and the pairs that collide in it.
  LoadCarriedBodies(*objects_, *joints_);
  if (joints_->has_constraints()) DampSliders(*objects_, *joints_, config_.step_seconds);
  exemptions_->Update();
  // The solver's world applies the play in each step.
  engine_->world.SetCloseFits(exemptions_->close_fits());
  ApplyGravity();
  for (const auto& articulation : objects_->articulations()) {
    articulation->BeforeStep(config_.step_seconds, config_.gravity);
  }
  // Articulations come before the bodies they hold, which need the next link poses.
  held_bodies_->SetKinematicVelocities();
  // 0 substeps: exactly one step of this length, without Bullet's own accumulation of time.
  engine_->world.stepSimulation(config_.step_seconds, /*maxSubSteps=*/0);
  for (const auto& articulation : objects_->articulations()) articulation->AfterStep();
  held_bodies_->MoveKinematicBodies();
  engine_->world.TurnNormals();
  engine_->dormant_islands.LeaveOut();
}

void World::ApplyGravity() {
  objects_->ForEachPresent([this](Body& body) {
    // A body without solids would never stop falling.
    const bool floats = body.is_carried() || body.spec().solids.empty();
    const double gravity = floats ? 0.0 : -config_.gravity;
    body.dynamics().bullet().setGravity(btVector3(0, 0, gravity));
  });
  held_bodies_->ApplyExcessWeight();
}

std::uint64_t World::state_hash() const {
  StateHash hash;
  objects_->AddTo(&hash);
  joints_->AddTo(&hash);
  exemptions_->AddTo(&hash);
  return hash.value();
}

Snapshot World::Save() const {
  Snapshot snapshot;
  ByteWriter state;
  objects_->Save(&snapshot, &state);
  joints_->Save(&snapshot, &state);
  exemptions_->Save(&snapshot);
  // State of the solver's random numbers.
  state.Put(static_cast<std::uint64_t>(engine_->solver.getRandSeed()));
  snapshot.state = state.Take();
  return snapshot;
}

/// The procedure is explained in docs/decisions/physics.md.
void World::Restore(const Snapshot& snapshot) {
  WorldObjects::Replacement replacement = objects_->ReplacementFor(snapshot);
  // From here on nothing fails until states are read.
  if (!replacement.is_empty() || !joints_->AreThoseOf(snapshot) ||
      !exemptions_->AreThoseOf(snapshot)) {
    // Joints refer to bodies: all are made again from their specs; their states are read below.
    Changing(joints_).RemoveAll();
    exemptions_->EndAll();
  }
  objects_->Apply(std::move(replacement));
  joints_->Restore(snapshot);
  exemptions_->Restore(snapshot);

  ByteReader in(snapshot.state);
  objects_->RestoreState(snapshot, &in);
  joints_->RestoreState(&in);
  engine_->solver.setRandSeed(static_cast<unsigned long>(in.Get<std::uint64_t>()));
  if (!in.ok() || in.remaining() > 0) {
    throw std::invalid_argument("snapshot: its state does not fit its objects");
  }
}

}  // namespace smile::physics

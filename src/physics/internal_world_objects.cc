#include "physics/internal_world_objects.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/state_hash.h"
#include "mechanics/by_id.h"
#include "mechanics/checks.h"
#include "physics/internal_articulation_links.h"
#include "physics/internal_body_dynamics.h"

// Bodies and articulations of a world, sorted by id, and their lives in Bullet's world. Ids count
// up and are never used again; they determine the order of all work (OrderOf). Specs are immutable
// and shared with snapshots, so a removed body can return.

namespace smile::physics {

using mechanics::FindById;
using mechanics::InsertById;
using mechanics::IsOfRecord;

namespace {

BodyId IdOf(const btCollisionObject* object) {
  return BodyId{static_cast<std::uint32_t>(OrderOf(object))};
}

/// Returns the state of a body with the contacts that are saved with it.
std::shared_ptr<const std::vector<std::byte>> StateOf(const Body& body,
                                                      std::span<const OwnedManifold> contacts) {
  ByteWriter out;
  body.dynamics().Save(&out);
  SaveContacts(contacts, &out);
  // A copy takes no more room than it needs: thousands are kept for undo.
  return std::make_shared<const std::vector<std::byte>>(out.bytes().begin(), out.bytes().end());
}

}  // namespace

WorldObjects::WorldObjects(const WorldConfig& config, Engine& engine)
    : config_(config), engine_(engine) {}

WorldObjects::~WorldObjects() {
  // Bullet's world does not own its objects; they must leave it before they are destroyed.
  engine_.dormant_islands.ReturnAll();
  while (!bodies_.empty()) Erase(*bodies_.back());
  for (const auto& articulation : articulations_) {
    for (const auto& link : articulation->links().links) {
      // The drive before the multibody to which it refers.
      if (link.drive) engine_.world.removeMultiBodyConstraint(link.drive.get());
      engine_.world.removeCollisionObject(link.collider.get());
    }
    if (auto* base = articulation->links().collider(-1)) engine_.world.removeCollisionObject(base);
    if (articulation->spec().is_kinematic) continue;
    for (const auto& tree : articulation->links().trees) engine_.world.removeMultiBody(tree.get());
  }
}

Body* WorldObjects::Find(BodyId id) const {
  const auto found = FindById(bodies_, id);
  return found == bodies_.end() ? nullptr : found->get();
}

Body& WorldObjects::body(BodyId id) const {
  if (Body* found = Find(id)) return *found;
  throw std::logic_error("body " + std::to_string(id.value) + " does not exist");
}

Articulation& WorldObjects::articulation(ArticulationId id) const {
  const auto found = FindById(articulations_, id);
  if (found == articulations_.end()) {
    throw std::logic_error("articulation " + std::to_string(id.value) + " does not exist");
  }
  return **found;
}

BodyId WorldObjects::AddBody(const BodySpec& spec) {
  CheckBody(spec);
  const BodyId id{next_id_++};
  Insert(std::make_unique<Body>(id, std::make_shared<const BodySpec>(spec)));
  return id;
}

ArticulationId WorldObjects::AddArticulation(const scene::ArticulationSpec& spec) {
  const ArticulationId id{next_id_};
  // One number for the base and one per link: contacts sort links individually.
  next_id_ += 1 + static_cast<std::uint32_t>(spec.links.size());
  Insert(std::make_unique<Articulation>(id, std::make_shared<const scene::ArticulationSpec>(spec),
                                        config_.motor));
  return id;
}

/// Notes the places of bodies after one came or went.
void WorldObjects::NumberBodiesFrom(std::size_t first) {
  for (std::size_t i = first; i < bodies_.size(); ++i) bodies_[i]->dynamics().set_place(i);
}

void WorldObjects::Insert(std::unique_ptr<Body> fresh) {
  const auto place = InsertById(bodies_, std::move(fresh));
  NumberBodiesFrom(static_cast<std::size_t>(place - bodies_.begin()));
  Body& body = **place;
  entries_ = {};
  btRigidBody& bullet = body.dynamics().bullet();
  body.dynamics().set_dormant_islands(&engine_.dormant_islands);
  bullet.setSleepingThresholds(config_.sleep_linear_speed, config_.sleep_angular_speed);
  bullet.setDamping(config_.damping, body.spec().angular_damping.value_or(config_.damping));
  engine_.world.addRigidBody(&bullet);
  engine_.world.SortObjects();
}

void WorldObjects::Insert(std::unique_ptr<Articulation> fresh) {
  // Base and links are separate collision objects, whose orders follow that of the articulation.
  Articulation& articulation = **InsertById(articulations_, std::move(fresh));
  const Articulation::Links& links = articulation.links();
  ExactWorld& world = engine_.world;
  const int base_order = static_cast<int>(articulation.id().value);
  for (const auto& [a, b] : articulation.spec().never_collide) {
    engine_.broadphase.filter().Exclude(base_order + 1 + a, base_order + 1 + b);
  }
  // A link does not collide with its parent. Bullet knows that within a tree only.
  for (std::size_t i = 0; i < links.links.size(); ++i) {
    if (articulation.spec().links[i].parent >= 0) continue;
    engine_.broadphase.filter().Exclude(base_order, base_order + 1 + static_cast<int>(i));
  }
  if (!articulation.spec().is_kinematic) {
    for (const auto& tree : links.trees) world.addMultiBody(tree.get());
  }
  if (auto* base = links.collider(-1)) world.addCollisionObject(base);
  for (const auto& link : links.links) {
    world.addCollisionObject(link.collider.get());
    if (link.drive) world.addMultiBodyConstraint(link.drive.get());
  }
  world.SortObjects();
}

void WorldObjects::RemoveBody(BodyId id) {
  const Body& gone = body(id);
  WakeTouching(gone);
  Erase(gone);
}

void WorldObjects::Erase(const Body& gone) {
  entries_ = {};
  const std::size_t place = gone.dynamics().place();
  engine_.world.removeRigidBody(&bodies_[place]->dynamics().bullet());
  engine_.world.SortObjects();
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(place));
  NumberBodiesFrom(place);
  ++num_removals_;
}

void WorldObjects::ChangeForm(BodyId id, const std::vector<scene::Solid>& solids,
                              const scene::MassProperties& mass) {
  const Body& old = body(id);
  auto spec = std::make_shared<BodySpec>(old.spec());
  spec->solids = solids;
  spec->mass = mass;
  CheckBody(*spec);
  // Joints and carrying rely on this.
  if ((mass.mass == 0) != old.is_static()) {
    throw std::invalid_argument("body: a new form cannot change whether it is static");
  }
  // Everything that can throw is done before the old body is removed.
  auto fresh = std::make_unique<Body>(id, spec);
  fresh->dynamics().set_is_carried(old.is_carried());
  fresh->SetPose(old.pose_in_world());
  fresh->SetVelocity(old.linear_velocity(), old.angular_velocity());
  WakeTouching(old);
  // `old` is destroyed here; the new body takes its id, and with it its place in all orders.
  Erase(old);
  Insert(std::move(fresh));
  WakeNear(body(id));
}

/// Wakes bodies in contact with a body, which must react when it changes.
void WorldObjects::WakeTouching(const Body& body) {
  ForEachManifoldOf(&body.dynamics().bullet(),
                    [](const btPersistentManifold& manifold, Body& other) {
                      if (manifold.getNumContacts() > 0) other.WakeUp();
                    });
}

/// Wakes bodies whose bounding boxes overlap that of a body.
void WorldObjects::WakeNear(const Body& body) {
  btVector3 min, max;
  body.dynamics().bullet().getAabb(min, max);
  for (const auto& other : bodies_) {
    btVector3 other_min, other_max;
    other->dynamics().bullet().getAabb(other_min, other_max);
    if (TestAabbAgainstAabb2(min, max, other_min, other_max)) other->WakeUp();
  }
}

std::vector<std::size_t> WorldObjects::NumbersChangedSince(const Moment& moment) const {
  std::vector<std::size_t> numbers;
  engine_.dormant_islands.ForEachChangedSince(moment, [&](const btRigidBody& bullet) {
    if (const Body* body = BodyOf(&bullet)) numbers.push_back(body->dynamics().place());
  });
  std::ranges::sort(numbers);
  return numbers;
}

bool WorldObjects::is_at_rest() const {
  return engine_.dormant_islands.AllSleep() &&
         std::all_of(articulations_.begin(), articulations_.end(),
                     [](const auto& a) { return a->is_at_rest(); });
}

void WorldObjects::WakeAll() {
  for (const auto& body : bodies_) body->WakeUp();
}

/// Returns the body or link of an order; null if there is none.
btCollisionObject* WorldObjects::FindObject(int order) const {
  if (Body* body = Find(BodyId{static_cast<std::uint32_t>(order)})) {
    return &body->dynamics().bullet();
  }
  for (const auto& articulation : articulations_) {
    // -1 is the base.
    const std::int64_t link = std::int64_t{order} - articulation->id().value - 1;
    if (link < -1 || link >= articulation->num_joints()) continue;
    return articulation->links().collider(static_cast<int>(link));
  }
  return nullptr;
}

/// Returns the order of the object with which contacts of two objects are saved: the last that is a
/// body and can move. Contacts of links only are saved with no body, order 0.
int WorldObjects::OwnerOf(const btCollisionObject* a, const btCollisionObject* b) const {
  int owner = 0;
  for (const auto* object : {a, b}) {
    const bool is_link = !articulations_.empty() && Find(IdOf(object)) == nullptr;
    if (!is_link && !object->isStaticObject()) owner = std::max(owner, OrderOf(object));
  }
  return owner;
}

/// Returns the manifolds of links only, and those of at least the given bodies, sorted by owner and
/// then by key.
std::vector<OwnedManifold> WorldObjects::ManifoldsOf(std::span<const std::size_t> bodies) const {
  const bool are_in_world = std::ranges::all_of(bodies, [this](std::size_t i) {
    return engine_.dormant_islands.PeriodOf(bodies_[i]->dynamics().bullet()) < 0;
  });
  std::vector<OwnedManifold> touching;
  for (btPersistentManifold* manifold :
       are_in_world ? engine_.dispatcher.Manifolds() : engine_.dormant_islands.AllManifolds()) {
    if (manifold->getNumContacts() == 0) continue;
    touching.push_back({OwnerOf(manifold->getBody0(), manifold->getBody1()), manifold});
  }
  // The bytes must not depend on the order in which contacts arose.
  std::ranges::sort(touching, {}, [](const OwnedManifold& owned) {
    return std::pair(owned.owner, KeyOfManifold(owned.manifold));
  });
  return touching;
}

void WorldObjects::Save(Snapshot* snapshot, ByteWriter* state) {
  std::vector<std::size_t> changed, unknown;
  if (entries_.size() == bodies_.size()) {
    changed = NumbersChangedSince(entries_moment_);
  } else {
    entries_ = SharedList(std::vector<Snapshot::BodyEntry>(bodies_.size()));
    changed.resize(bodies_.size());
    std::iota(changed.begin(), changed.end(), 0);
  }
  std::ranges::copy_if(changed, std::back_inserter(unknown), [this](std::size_t i) {
    return bodies_[i]->dynamics().known_state() == nullptr;
  });
  const std::vector<OwnedManifold> manifolds = ManifoldsOf(unknown);
  const auto contacts_of = [&manifolds](int owner) -> std::span<const OwnedManifold> {
    const auto first = std::ranges::lower_bound(manifolds, owner, {}, &OwnedManifold::owner);
    const auto end = std::ranges::upper_bound(manifolds, owner, {}, &OwnedManifold::owner);
    return {first, end};
  };
  for (std::size_t i : unknown) {
    Body& body = *bodies_[i];
    body.dynamics().KeepState(StateOf(body, contacts_of(static_cast<int>(body.id().value))));
  }
  std::vector<std::pair<std::size_t, Snapshot::BodyEntry>> entries;
  for (std::size_t i : changed) {
    const Body& body = *bodies_[i];
    entries.emplace_back(
        i, Snapshot::BodyEntry{body.id(), body.shared_spec(), body.dynamics().known_state()});
  }
  entries_.Set(std::move(entries));
  entries_moment_ = engine_.dormant_islands.now();

  snapshot->next_id = next_id_;
  snapshot->bodies = entries_;
  for (const auto& articulation : articulations_) {
    snapshot->articulations.push_back({articulation->id(), articulation->shared_spec()});
    articulation->Save(state);
  }
  SaveContacts(contacts_of(/*owner=*/0), state);
}

void WorldObjects::RestoreState(const Snapshot& snapshot, ByteReader* in) {
  const std::vector<std::size_t> replaced = NumbersOfBodiesToRestore(snapshot);
  std::vector<btRigidBody*> changing;
  for (std::size_t i : replaced) changing.push_back(&bodies_[i]->dynamics().bullet());
  if (!changing.empty()) engine_.dormant_islands.Return(changing);

  std::vector<SavedManifold> contacts;
  for (std::size_t i : replaced) {
    ByteReader own(*snapshot.bodies[i].state);
    bodies_[i]->dynamics().Restore(&own);
    ReadContacts(static_cast<int>(bodies_[i]->id().value), &own, &contacts);
    if (own.remaining() > 0) throw std::invalid_argument("snapshot: a body's state is too long");
  }
  for (const auto& articulation : articulations_) articulation->Restore(in);
  ReadContacts(/*owner=*/0, in, &contacts);
  const ContactOwners owners = {
      .object_of = [this](int order) { return FindObject(order); },
      .owner_of = [this](const auto* a, const auto* b) { return OwnerOf(a, b); },
      .is_replaced =
          [this, &replaced](int owner) {
            return owner == 0 ||
                   std::ranges::binary_search(replaced, owner, {}, [this](std::size_t i) {
                     return static_cast<int>(bodies_[i]->id().value);
                   });
          }};
  RestoreContacts(contacts, owners, engine_.world, engine_.broadphase);
  // The next save and the next way back to this snapshot take these states as they are.
  for (const std::size_t i : NumbersThatMayDifferFrom(snapshot)) {
    Body::Dynamics& dynamics = bodies_[i]->dynamics();
    if (dynamics.known_state() != snapshot.bodies[i].state) {
      dynamics.KeepState(snapshot.bodies[i].state);
    }
  }
  entries_ = snapshot.bodies;
  entries_moment_ = engine_.dormant_islands.now();
}

/// Returns the places of the bodies that may have changed since the last snapshot, or may be others
/// in that than in this one. The others are in this one's state.
std::vector<std::size_t> WorldObjects::NumbersThatMayDifferFrom(const Snapshot& snapshot) const {
  std::vector<std::size_t> numbers(bodies_.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  if (entries_.size() != bodies_.size()) return numbers;
  numbers.clear();
  std::ranges::set_union(NumbersChangedSince(entries_moment_),
                         entries_.MayDifferFrom(snapshot.bodies), std::back_inserter(numbers));
  return numbers;
}

/// Returns the places of the bodies that are not in the snapshot's state, as far as that is known
/// without reading it.
std::vector<std::size_t> WorldObjects::NumbersOfBodiesToRestore(const Snapshot& snapshot) const {
  std::vector<std::size_t> numbers;
  for (const std::size_t i : NumbersThatMayDifferFrom(snapshot)) {
    const auto& saved = snapshot.bodies[i].state;
    const Body::Dynamics& dynamics = bodies_[i]->dynamics();
    if (dynamics.known_state() == saved) continue;
    // What never moves is in the world, where something happens in each step. It has no contacts of
    // its own.
    if (bodies_[i]->is_static() && *StateOf(*bodies_[i], {}) == *saved) continue;
    numbers.push_back(i);
  }
  return numbers;
}

void WorldObjects::AddTo(StateHash* hash) const {
  if (config_.sums_hashes) {
    hash->Add(engine_.dormant_islands.HashOfBodies());
  } else {
    for (const auto& body : bodies_) {
      hash->Add(std::uint64_t{body->id().value});
      AddMotion(body->dynamics().bullet(), hash);
    }
  }
  for (const auto& articulation : articulations_) {
    hash->Add(std::uint64_t{articulation->id().value});
    articulation->AddTo(hash);
  }
}

WorldObjects::Replacement WorldObjects::ReplacementFor(const Snapshot& snapshot) const {
  mechanics::CheckSnapshot(snapshot, entries_);
  Replacement result{.next_id = snapshot.next_id};
  // Articulations are never removed, so a snapshot's list must begin with those of this world.
  for (std::size_t i = 0; i < std::max(articulations_.size(), snapshot.articulations.size()); ++i) {
    if (i >= articulations_.size()) {
      const auto& record = snapshot.articulations[i];
      mechanics::CheckArticulation(*record.spec);
      result.fresh_articulations.push_back(
          std::make_unique<Articulation>(record.id, record.spec, config_.motor));
    } else if (i >= snapshot.articulations.size() ||
               !IsOfRecord(*articulations_[i], snapshot.articulations[i])) {
      throw std::invalid_argument("snapshot: it is of a world without this robot");
    }
  }
  // If the snapshot's bodies are those of the last one, but for a few, only these are compared.
  if (entries_.size() == bodies_.size() && snapshot.bodies.size() == bodies_.size() &&
      std::ranges::all_of(entries_.MayDifferFrom(snapshot.bodies), [&](std::size_t i) {
        return IsOfRecord(*bodies_[i], snapshot.bodies[i]);
      })) {
    return result;
  }
  // Both lists are sorted by id: merge them. A body that is unchanged stays.
  auto old = bodies_.begin();
  for (const auto& record : snapshot.bodies) {
    while (old != bodies_.end() && (*old)->id() < record.id) result.gone.push_back((*old++)->id());
    const bool is_there = old != bodies_.end() && (*old)->id() == record.id;
    if (is_there && IsOfRecord(**old++, record)) continue;
    if (is_there) result.gone.push_back(record.id);
    CheckBody(*record.spec);
    result.fresh_bodies.push_back(std::make_unique<Body>(record.id, record.spec));
  }
  // Bodies behind the snapshot's last one were added later.
  while (old != bodies_.end()) result.gone.push_back((*old++)->id());
  return result;
}

void WorldObjects::Apply(Replacement replacement) {
  while (!replacement.gone.empty()) {
    Erase(body(replacement.gone.back()));
    replacement.gone.pop_back();
  }
  for (auto& fresh : replacement.fresh_bodies) Insert(std::move(fresh));
  for (auto& fresh : replacement.fresh_articulations) Insert(std::move(fresh));
  next_id_ = replacement.next_id;
}

}  // namespace smile::physics

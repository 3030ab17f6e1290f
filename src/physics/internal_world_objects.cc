#include "physics/internal_world_objects.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/state_hash.h"
#include "mechanics/checks.h"
#include "physics/internal_articulation_links.h"
#include "physics/internal_body_dynamics.h"

// Bodies and articulations of a world, sorted by id, and their lives in Bullet's world. Ids count
// up and are never used again; they determine the order of all work (OrderOf). Specs are immutable
// and shared with snapshots, so a removed body can return.

namespace smile::physics {
namespace {

/// Returns an iterator to the element with this id in a sorted list, or its end.
template <class Things, class Id>
auto FindById(Things& things, Id id) {
  const auto found = std::lower_bound(things.begin(), things.end(), id,
                                      [](const auto& thing, Id key) { return thing->id() < key; });
  return found != things.end() && (*found)->id() == id ? found : things.end();
}

/// Inserts an element into a list sorted by id, and returns it.
template <class Things, class Thing>
Thing& InsertById(Things& things, std::unique_ptr<Thing> thing) {
  const auto place = std::lower_bound(things.begin(), things.end(), thing->id(),
                                      [](const auto& other, auto id) { return other->id() < id; });
  return **things.insert(place, std::move(thing));
}

BodyId IdOf(const btCollisionObject* object) {
  return BodyId{static_cast<std::uint32_t>(OrderOf(object))};
}

/// Returns true if the record describes this object: same id, equal spec.
template <class Thing, class Record>
bool Is(const Thing& thing, const Record& record) {
  return thing.id() == record.id &&
         (&thing.spec() == record.spec.get() || thing.spec() == *record.spec);
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

void WorldObjects::Insert(std::unique_ptr<Body> fresh) {
  Body& body = InsertById(bodies_, std::move(fresh));
  btRigidBody& bullet = body.dynamics().bullet();
  body.dynamics().set_dormant_islands(&engine_.dormant_islands);
  bullet.setSleepingThresholds(config_.sleep_linear_speed, config_.sleep_angular_speed);
  bullet.setDamping(config_.damping, body.spec().angular_damping.value_or(config_.damping));
  engine_.world.addRigidBody(&bullet);
  engine_.world.SortObjects();
}

void WorldObjects::Insert(std::unique_ptr<Articulation> fresh) {
  // Base and links are separate collision objects, whose orders follow that of the articulation.
  Articulation& articulation = InsertById(articulations_, std::move(fresh));
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
  const auto found = FindById(bodies_, gone.id());
  engine_.world.removeRigidBody(&(*found)->dynamics().bullet());
  engine_.world.SortObjects();
  bodies_.erase(found);
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

bool WorldObjects::is_at_rest() const {
  return engine_.dormant_islands.AllSleep() &&
         std::all_of(articulations_.begin(), articulations_.end(),
                     [](const auto& a) { return a->is_at_rest(); });
}

void WorldObjects::WakeAll() {
  for (const auto& body : bodies_) body->WakeUp();
}

/// Returns the manifolds of the bodies whose states are not known, sorted by owner, which is the
/// last of its bodies that can move, and then by key. Those of links only come first, with owner 0.
std::vector<OwnedManifold> WorldObjects::ManifoldsToSave() const {
  const bool are_sleepers_known = std::ranges::all_of(bodies_, [this](const auto& body) {
    const Body::Dynamics& dynamics = body->dynamics();
    return !engine_.dormant_islands.PeriodOf(dynamics.bullet()) || dynamics.known_state();
  });
  std::vector<OwnedManifold> touching;
  for (btPersistentManifold* manifold : are_sleepers_known
                                            ? engine_.dispatcher.Manifolds()
                                            : engine_.dormant_islands.AllManifolds()) {
    if (manifold->getNumContacts() == 0) continue;
    int owner = 0;
    for (const auto* object : {manifold->getBody0(), manifold->getBody1()}) {
      const bool is_link = articulations_.size() > 0 && Find(IdOf(object)) == nullptr;
      if (!is_link && !object->isStaticObject()) owner = std::max(owner, OrderOf(object));
    }
    touching.push_back({owner, manifold});
  }
  // The bytes must not depend on the order in which contacts arose.
  std::ranges::sort(touching, {}, [](const OwnedManifold& owned) {
    return std::pair(owned.owner, KeyOfManifold(owned.manifold));
  });
  return touching;
}

void WorldObjects::Save(Snapshot* snapshot, ByteWriter* state) const {
  const std::vector<OwnedManifold> manifolds = ManifoldsToSave();
  const auto save_contacts = [&manifolds](int owner, ByteWriter* out) {
    const auto first = std::ranges::lower_bound(manifolds, owner, {}, &OwnedManifold::owner);
    const auto end = std::ranges::upper_bound(manifolds, owner, {}, &OwnedManifold::owner);
    SaveContacts({first, end}, out);
  };
  snapshot->next_id = next_id_;
  snapshot->bodies.reserve(bodies_.size());
  for (const auto& body : bodies_) {
    auto own = body->dynamics().known_state();
    if (own == nullptr) {
      ByteWriter bytes;
      body->dynamics().Save(&bytes);
      save_contacts(static_cast<int>(body->id().value), &bytes);
      own = std::make_shared<const std::vector<std::byte>>(bytes.Take());
      body->dynamics().KeepState(own);
    }
    snapshot->bodies.push_back({body->id(), body->shared_spec(), std::move(own)});
  }
  for (const auto& articulation : articulations_) {
    snapshot->articulations.push_back({articulation->id(), articulation->shared_spec()});
    articulation->Save(state);
  }
  save_contacts(/*owner=*/0, state);
}

void WorldObjects::RestoreState(const Snapshot& snapshot, ByteReader* in) {
  std::vector<SavedManifold> contacts;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    ByteReader own(*snapshot.bodies[i].state);
    bodies_[i]->dynamics().Restore(&own);
    ReadContacts(&own, &contacts);
    if (own.remaining() > 0) throw std::invalid_argument("snapshot: a body's state is too long");
  }
  for (const auto& articulation : articulations_) articulation->Restore(in);
  ReadContacts(in, &contacts);
  RestoreContacts(engine_.world, engine_.broadphase, std::move(contacts));
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
  Replacement result{.next_id = snapshot.next_id};
  // Articulations are never removed, so a snapshot's list must begin with those of this world.
  for (std::size_t i = 0; i < std::max(articulations_.size(), snapshot.articulations.size()); ++i) {
    if (i >= articulations_.size()) {
      const auto& record = snapshot.articulations[i];
      result.fresh_articulations.push_back(
          std::make_unique<Articulation>(record.id, record.spec, config_.motor));
    } else if (i >= snapshot.articulations.size() ||
               !Is(*articulations_[i], snapshot.articulations[i])) {
      throw std::invalid_argument("snapshot: it is of a world without this robot");
    }
  }
  // Both lists are sorted by id: merge them. A body that is unchanged stays.
  auto old = bodies_.begin();
  for (const auto& record : snapshot.bodies) {
    while (old != bodies_.end() && (*old)->id() < record.id) result.gone.push_back((*old++)->id());
    const bool is_there = old != bodies_.end() && (*old)->id() == record.id;
    if (is_there && Is(**old++, record)) continue;
    if (is_there) result.gone.push_back(record.id);
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

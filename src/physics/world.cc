#include "physics/world.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "physics/internal_articulation_links.h"
#include "physics/internal_checks.h"
#include "physics/internal_engine.h"

namespace smile::physics {
namespace {

/// Farther apart than this, two things do not touch [m].
constexpr double kTouching = 1e-4;

template <class Things, class Id>
auto FindById(Things& things, Id id) {
  const auto found = std::lower_bound(things.begin(), things.end(), id,
                                      [](const auto& thing, Id key) { return thing->id() < key; });
  return found != things.end() && (*found)->id() == id ? found : things.end();
}

template <class Things, class Thing>
void InsertSorted(Things& things, std::unique_ptr<Thing> thing) {
  const auto place = std::lower_bound(things.begin(), things.end(), thing->id(),
                                      [](const auto& other, auto id) { return other->id() < id; });
  things.insert(place, std::move(thing));
}

}  // namespace

World::World(const WorldConfig& config)
    : config_(config), engine_(std::make_unique<Engine>(config)) {}

World::~World() {
  while (!joints_.empty()) RemoveJoint(joints_.back().id);
  while (!bodies_.empty()) Erase(*bodies_.back());
  for (const auto& articulation : articulations_) {
    for (const auto& link : articulation->links_->links) {
      if (link.drive) engine_->world.removeMultiBodyConstraint(link.drive.get());
      engine_->world.removeCollisionObject(link.collider.get());
    }
    if (auto* base = articulation->links_->collider(-1)) engine_->world.removeCollisionObject(base);
    if (!articulation->spec().is_kinematic) {
      engine_->world.removeMultiBody(articulation->bullet_.get());
    }
  }
}

BodyId World::AddBody(const BodySpec& spec) {
  CheckBody(spec);
  const BodyId id{next_id_++};
  Insert(std::unique_ptr<Body>(new Body(id, std::make_shared<const BodySpec>(spec))));
  return id;
}

void World::Insert(std::unique_ptr<Body> body) {
  btRigidBody* bullet = body->bullet_.get();
  bullet->setSleepingThresholds(config_.sleep_linear_speed, config_.sleep_angular_speed);
  bullet->setDamping(config_.damping, body->spec_->angular_damping.value_or(config_.damping));
  engine_->world.addRigidBody(bullet);
  engine_->world.SortObjects();
  InsertSorted(bodies_, std::move(body));
}

void World::RemoveBody(BodyId id) {
  Body& gone = body(id);
  std::vector<JointId> ended;
  for (const Joint& joint : joints_) {
    if (Joins(joint.spec, id)) ended.push_back(joint.id);
  }
  for (JointId joint : ended) RemoveJoint(joint);
  EndPassingOf(id);
  WakeTouching(gone);
  Erase(gone);
}

/// What leans on a body must notice when it changes.
void World::WakeTouching(const Body& body) {
  for (int i = 0; i < engine_->dispatcher.getNumManifolds(); ++i) {
    const auto* manifold = engine_->dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() == 0) continue;
    const auto* a = manifold->getBody0();
    const auto* b = manifold->getBody1();
    if (a != body.bullet_.get() && b != body.bullet_.get()) continue;
    const int other = OrderOf(a == body.bullet_.get() ? b : a);
    const auto neighbour = FindById(bodies_, BodyId{static_cast<std::uint32_t>(other)});
    if (neighbour != bodies_.end()) (*neighbour)->WakeUp();
  }
}

void World::ChangeForm(BodyId id, const std::vector<scene::Solid>& solids,
                       const scene::MassProperties& mass) {
  Body& old = body(id);
  auto spec = std::make_shared<BodySpec>(old.spec());
  spec->solids = solids;
  spec->mass = mass;
  CheckBody(*spec);
  if ((mass.mass == 0) != old.is_static()) {
    throw std::invalid_argument("body: another form cannot make it static, or end that");
  }
  auto fresh = std::unique_ptr<Body>(new Body(id, spec));
  fresh->is_carried_ = old.is_carried_;
  fresh->SetPose(old.pose_in_world());
  fresh->SetVelocity(old.linear_velocity(), old.angular_velocity());
  WakeTouching(old);
  Erase(old);
  Insert(std::move(fresh));
  WakeNear(body(id));
  RejoinBullet(id);
}

void World::WakeNear(const Body& body) {
  btVector3 min, max;
  body.bullet_->getAabb(min, max);
  for (const auto& other : bodies_) {
    btVector3 other_min, other_max;
    other->bullet_->getAabb(other_min, other_max);
    if (TestAabbAgainstAabb2(min, max, other_min, other_max)) other->WakeUp();
  }
}

void World::Erase(Body& gone) {
  engine_->world.removeRigidBody(gone.bullet_.get());
  engine_->world.SortObjects();
  bodies_.erase(FindById(bodies_, gone.id()));
}

ArticulationId World::AddArticulation(const scene::ArticulationSpec& spec) {
  const ArticulationId id{next_id_};
  next_id_ += 1 + static_cast<std::uint32_t>(spec.links.size());
  Insert(std::unique_ptr<Articulation>(
      new Articulation(id, std::make_shared<const scene::ArticulationSpec>(spec), config_.motor)));
  return id;
}

void World::Insert(std::unique_ptr<Articulation> articulation) {
  ExactWorld& world = engine_->world;
  const Articulation::Links& links = *articulation->links_;
  const int base_order = static_cast<int>(articulation->id().value);
  for (const auto& [a, b] : articulation->spec().never_collide) {
    engine_->broadphase.filter().Exclude(base_order + 1 + a, base_order + 1 + b);
  }
  if (!articulation->spec().is_kinematic) world.addMultiBody(articulation->bullet_.get());
  if (auto* base = links.collider(-1)) world.addCollisionObject(base);
  for (const auto& link : links.links) {
    world.addCollisionObject(link.collider.get());
    if (link.drive) world.addMultiBodyConstraint(link.drive.get());
  }
  world.SortObjects();
  InsertSorted(articulations_, std::move(articulation));
}

bool World::Has(BodyId id) const { return FindById(bodies_, id) != bodies_.end(); }

Body& World::body(BodyId id) { return const_cast<Body&>(std::as_const(*this).body(id)); }

const Body& World::body(BodyId id) const {
  const auto found = FindById(bodies_, id);
  if (found == bodies_.end()) {
    throw std::logic_error("body " + std::to_string(id.value) + " does not exist");
  }
  return **found;
}

Articulation& World::articulation(ArticulationId id) {
  return const_cast<Articulation&>(std::as_const(*this).articulation(id));
}

const Articulation& World::articulation(ArticulationId id) const {
  const auto found = FindById(articulations_, id);
  if (found == articulations_.end()) {
    throw std::logic_error("articulation " + std::to_string(id.value) + " does not exist");
  }
  return **found;
}

const std::vector<Joint>& World::joints() const { return joints_; }

std::vector<Contact> World::ContactsWith(ArticulationId id, int link) const {
  const btCollisionObject* collider = articulation(id).links_->collider(link);
  engine_->world.SortManifolds();
  std::vector<Contact> contacts;
  for (int i = 0; i < engine_->dispatcher.getNumManifolds(); ++i) {
    const auto* manifold = engine_->dispatcher.getManifoldByIndexInternal(i);
    const bool link_is_a = manifold->getBody0() == collider;
    if (!link_is_a && manifold->getBody1() != collider) continue;
    const auto* other = link_is_a ? manifold->getBody1() : manifold->getBody0();
    const BodyId body_id{static_cast<std::uint32_t>(OrderOf(other))};
    if (!Has(body_id)) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      if (point.getDistance() > kTouching) continue;
      contacts.push_back(
          {.body = body_id,
           .p_WQ = FromBullet(link_is_a ? point.m_positionWorldOnA : point.m_positionWorldOnB),
           .normal_in_world = FromBullet(point.m_normalWorldOnB) * (link_is_a ? 1.0 : -1.0),
           .distance = point.getDistance()});
    }
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return a.body < b.body; });
  return contacts;
}

std::vector<BodyId> World::BodiesTouching(BodyId id) const {
  const btCollisionObject* touched = body(id).bullet_.get();
  const auto is_touch = [](const btManifoldPoint& point) {
    return point.getDistance() <= kTouching || point.getAppliedImpulse() > 0;
  };
  std::vector<BodyId> bodies;
  for (int i = 0; i < engine_->dispatcher.getNumManifolds(); ++i) {
    const auto* manifold = engine_->dispatcher.getManifoldByIndexInternal(i);
    const bool is_a = manifold->getBody0() == touched;
    if (!is_a && manifold->getBody1() != touched) continue;
    const BodyId other{
        static_cast<std::uint32_t>(OrderOf(is_a ? manifold->getBody1() : manifold->getBody0()))};
    if (!Has(other)) continue;  // a link
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      if (is_touch(manifold->getContactPoint(k))) bodies.push_back(other);
    }
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

bool World::is_at_rest() const {
  return std::none_of(bodies_.begin(), bodies_.end(),
                      [](const auto& b) { return b->is_awake(); }) &&
         std::all_of(articulations_.begin(), articulations_.end(),
                     [](const auto& a) { return a->is_at_rest(); });
}

void World::WakeAll() {
  for (const auto& body : bodies_) body->WakeUp();
}

void World::Step() {
  if (is_at_rest()) return;
  LoadCarriedBodies();
  if (!engine_->joints.empty()) DampSliders();
  if (!close_fits_.empty()) EndCloseFitsApart();
  if (!passing_.empty()) EndPassingApart();
  engine_->world.SetCloseFits(close_fits_);
  PullDown();
  for (const auto& articulation : articulations_) {
    articulation->BeforeStep(config_.step_seconds, config_.gravity);
  }
  LeadHeldBodies();
  engine_->world.stepSimulation(config_.step_seconds, /*maxSubSteps=*/0);
  for (const auto& articulation : articulations_) articulation->AfterStep();
  PlaceHeldBodies();
}

void World::PullDown() {
  for (const auto& body : bodies_) {
    if (body->is_static()) continue;
    // What touches nothing would fall for ever.
    const bool floats = body->is_carried() || body->spec().solids.empty();
    const double gravity = floats ? 0.0 : -config_.gravity;
    body->bullet_->setGravity(btVector3(0, 0, gravity));
  }
  for (const Joint& joint : joints_) {
    const auto* weld = std::get_if<WeldSpec>(&joint.spec);
    if (weld == nullptr) continue;
    Body& held = body(weld->body);
    const double excess = std::max(0.0, held.spec().mass.mass - weld->holds_up);
    held.bullet_->setGravity(btVector3(0, 0, -config_.gravity * excess / held.loaded_mass()));
    if (excess > 0) articulation(weld->articulation).NoteOverload(weld->link);
  }
}

}  // namespace smile::physics

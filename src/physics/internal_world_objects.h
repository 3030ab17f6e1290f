#pragma once

#include <memory>
#include <vector>

#include "physics/articulation.h"
#include "physics/body.h"
#include "physics/definitions.h"
#include "physics/internal_contact_cache.h"
#include "physics/internal_engine.h"

namespace smile::physics {

/// Bodies and articulations of a World, by id, each with its place in Bullet's world.
class WorldObjects {
 public:
  /// Both must outlive it.
  WorldObjects(const WorldConfig& config, Engine& engine);
  ~WorldObjects();
  WorldObjects(const WorldObjects&) = delete;
  WorldObjects& operator=(const WorldObjects&) = delete;

  const std::vector<std::unique_ptr<Body>>& bodies() const { return bodies_; }
  const std::vector<std::unique_ptr<Articulation>>& articulations() const { return articulations_; }

  Body* Find(BodyId id) const;  ///< null if it does not exist
  /// @throws std::logic_error if it does not exist.
  Body& body(BodyId id) const;
  Articulation& articulation(ArticulationId id) const;

  /// Calls visit(const btPersistentManifold&, Body& other) for each manifold of an object with a
  /// body.
  template <class Visit>
  void ForEachManifoldOf(const btCollisionObject* object, Visit visit) const {
    for (const btPersistentManifold* manifold : engine_.dormant_islands.AllManifolds()) {
      const bool is_a = manifold->getBody0() == object;
      if (!is_a && manifold->getBody1() != object) continue;
      const int order = OrderOf(is_a ? manifold->getBody1() : manifold->getBody0());
      if (Body* other = Find(BodyId{static_cast<std::uint32_t>(order)})) visit(*manifold, *other);
    }
  }

  /// See World.
  BodyId AddBody(const BodySpec& spec);
  ArticulationId AddArticulation(const scene::ArticulationSpec& spec);
  /// Removes a body and wakes those that touch it. Nothing may refer to it afterwards.
  void RemoveBody(BodyId id);
  /// Replaces the body by one of another form in its place; its Bullet object is replaced too.
  void ChangeForm(BodyId id, const std::vector<scene::Solid>& solids,
                  const scene::MassProperties& mass);

  /// Calls visit(Body&) for each body that is not static, by id, except those of dormant islands.
  template <class Visit>
  void ForEachPresent(Visit visit) const {
    for (const btRigidBody* present : All(engine_.world.getNonStaticRigidBodies())) {
      visit(body(BodyId{static_cast<std::uint32_t>(OrderOf(present))}));
    }
  }

  bool is_at_rest() const;
  void WakeAll();

  /// Adds the objects with their contacts to the snapshot: the bodies' states to their entries, and
  /// all others to `state`.
  void Save(Snapshot* snapshot, ByteWriter* state) const;
  /// Restores the states of all objects, which are those of the snapshot, and their contacts.
  /// @throws std::invalid_argument if the states do not fit.
  void RestoreState(const Snapshot& snapshot, ByteReader* in);
  void AddTo(StateHash* hash) const;

  /// Changes that turn these objects into those of a snapshot.
  struct Replacement {
    std::vector<std::unique_ptr<Articulation>> fresh_articulations;
    std::vector<std::unique_ptr<Body>> fresh_bodies;
    std::vector<BodyId> gone;  ///< replaced or removed, by id
    std::uint32_t next_id = 1;
  };
  /// Computes the changes without applying them.
  /// @throws std::invalid_argument if the snapshot lacks an articulation of this world.
  Replacement ReplacementFor(const Snapshot& snapshot) const;
  void Apply(Replacement replacement);

 private:
  std::vector<OwnedManifold> ManifoldsToSave() const;
  void Insert(std::unique_ptr<Body> body);
  void Insert(std::unique_ptr<Articulation> articulation);
  void Erase(const Body& body);
  void WakeTouching(const Body& body);
  void WakeNear(const Body& body);

  const WorldConfig& config_;
  Engine& engine_;
  std::uint32_t next_id_ = 1;  ///< bodies and links share one counter: it orders everything
  std::vector<std::unique_ptr<Articulation>> articulations_;
  std::vector<std::unique_ptr<Body>> bodies_;
};

}  // namespace smile::physics

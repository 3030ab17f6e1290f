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
      visit(*BodyOf(present));
    }
  }

  /// Returns the places of the bodies that may have changed since a moment, in ascending order.
  std::vector<std::size_t> NumbersChangedSince(const Moment& moment) const;

  /// Returns the number of bodies that were removed so far, also in order to be replaced.
  int num_removals() const { return num_removals_; }

  bool is_at_rest() const;
  void WakeAll();

  /// Adds the objects with their contacts to the snapshot: the bodies' states to their entries, and
  /// all others to `state`.
  void Save(Snapshot* snapshot, ByteWriter* state);
  /// Restores the states of all objects, which are those of the snapshot, and their contacts.
  /// Bodies that are in the snapshot's state stay as they are, left out or not.
  /// @throws std::invalid_argument if the states do not fit.
  void RestoreState(const Snapshot& snapshot, ByteReader* in);
  void AddTo(StateHash* hash) const;

  /// Changes that turn these objects into those of a snapshot.
  struct Replacement {
    std::vector<std::unique_ptr<Articulation>> fresh_articulations;
    std::vector<std::unique_ptr<Body>> fresh_bodies;
    std::vector<BodyId> gone;  ///< replaced or removed, by id
    std::uint32_t next_id = 1;

    bool is_empty() const {
      return fresh_articulations.empty() && fresh_bodies.empty() && gone.empty();
    }
  };
  /// Checks a snapshot and computes the changes without applying them.
  /// @throws std::invalid_argument if the snapshot is not sound, lacks an articulation of this
  /// world, or contains
  ///         a definition that is not possible.
  Replacement ReplacementFor(const Snapshot& snapshot) const;
  void Apply(Replacement replacement);

 private:
  btCollisionObject* FindObject(int order) const;
  int OwnerOf(const btCollisionObject* a, const btCollisionObject* b) const;
  std::vector<OwnedManifold> ManifoldsOf(std::span<const std::size_t> bodies) const;
  std::vector<std::size_t> NumbersThatMayDifferFrom(const Snapshot& snapshot) const;
  std::vector<std::size_t> NumbersOfBodiesToRestore(const Snapshot& snapshot) const;
  void NumberBodiesFrom(std::size_t first);
  void Insert(std::unique_ptr<Body> body);
  void Insert(std::unique_ptr<Articulation> articulation);
  void Erase(const Body& body);
  void WakeTouching(const Body& body);
  void WakeNear(const Body& body);

  const WorldConfig& config_;
  Engine& engine_;
  std::uint32_t next_id_ = 1;  ///< bodies and links share one counter: it orders everything
  int num_removals_ = 0;       ///< not part of the state
  std::vector<std::unique_ptr<Articulation>> articulations_;
  std::vector<std::unique_ptr<Body>> bodies_;
  /// Entries of the bodies in the last snapshot, and when that was; none after a body came or went.
  SharedList<Snapshot::BodyEntry> entries_;
  Moment entries_moment_;
};

}  // namespace smile::physics

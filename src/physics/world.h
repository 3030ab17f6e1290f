#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/articulation.h"
#include "physics/body.h"
#include "physics/definitions.h"

namespace smile::mechanics {
class CollisionExemptions;
}

namespace smile::physics {

class ExemptPairs;
class HeldBodies;
class JointSet;
class WorldObjects;
struct Engine;

/// Rigid bodies and articulations under gravity, stepped at a fixed rate.
///
/// Deterministic: results depend only on the calls and the state they found, never on addresses,
/// time or threads. Save() and Restore() are exact, contacts included. Not thread-safe; any number
/// of worlds may exist in different threads if their `sleep_after_seconds` are equal.
class World {
 public:
  explicit World(const WorldConfig& config = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const WorldConfig& config() const { return config_; }

  /// Adds a body. Without solids it passes through everything and floats.
  /// @throws std::invalid_argument if a number is not finite or a mass negative.
  BodyId AddBody(const BodySpec& spec);
  /// Removes a body and its joints, and wakes the bodies that it touched.
  void RemoveBody(BodyId id);
  ArticulationId AddArticulation(const scene::ArticulationSpec& spec);
  /// Changes the form of a body in place; it keeps its velocity, its joints and whether it is
  /// carried. Wakes it and nearby bodies.
  /// @throws std::invalid_argument like AddBody(), or if the body would become static or cease to
  /// be
  ///         static.
  void ChangeForm(BodyId id, const std::vector<scene::Solid>& solids,
                  const scene::MassProperties& mass);

  /// Adds a joint and wakes its bodies. A body held by a weld becomes carried.
  /// @throws std::invalid_argument if a number is not finite, limits are the wrong way round, or
  ///         both bodies are static or the same; std::logic_error if one does not exist.
  JointId AddJoint(const JointSpec& spec);
  /// Removes a joint and wakes its bodies; a body held by a weld is no longer carried.
  void RemoveJoint(JointId id);
  /// Returns all bodies connected with this one through joints other than welds, not through static
  /// bodies, by id. The body itself is included, static ones are not.
  /// @param without  a joint to leave out.
  std::vector<BodyId> Assembly(BodyId id, JointId without = {}) const;
  /// Returns true if a joint other than `without` ties its assembly to a static body.
  bool IsAnchored(BodyId id, JointId without = {}) const;
  /// Moves a body to a pose at once, at rest, and its assembly with it.
  void MoveAssembly(BodyId id, const RigidTransform& X_WB);

  /// Ends collisions between two bodies until they overlap by at most 0.5 mm: for a body that was
  /// inside the other when its joint ended. Until they no longer overlap at all they are a close
  /// fit, like a screw in a hole of its own radius: contacts between them then begin to bear 0.5 mm
  /// deeper, so that the screw rests in its hole and slides out of it.
  void IgnoreCollisionUntilSeparated(BodyId a, BodyId b);
  /// Returns the objects that this body would overlap by more than `depth` [m] at `X_WB`, without
  /// those that it may pass through.
  Overlaps OverlapsAt(BodyId id, const RigidTransform& X_WB, double depth) const;
  /// Returns the objects that a body of these solids would overlap by more than `depth` [m] at
  /// `X_WB`.
  Overlaps OverlapsOf(const std::vector<scene::Solid>& solids, const RigidTransform& X_WB,
                      double depth) const;

  bool Has(BodyId id) const;
  Body& body(BodyId id);  ///< @throws std::logic_error if there is no such body
  const Body& body(BodyId id) const;
  Articulation& articulation(ArticulationId id);
  const Articulation& articulation(ArticulationId id) const;
  const std::vector<Joint>& joints() const;

  /// Returns the contacts of bodies with a link, by body. Contacts up to 0.1 mm apart count.
  std::vector<LinkContact> ContactsWith(ArticulationId id, int link) const;
  /// Returns the pushes on these bodies in the last step, in the order of its contacts, with an
  /// impulse above 0. Contacts between objects that sleep or never move are left out.
  /// @param ids  in ascending order.
  std::vector<Push> PushesOn(std::span<const BodyId> ids) const;
  /// Returns all bodies that touch this one, including static ones, by id: those up to 0.1 mm
  /// apart, and those that bounced off it in the last step.
  std::vector<BodyId> BodiesTouching(BodyId id) const;

  /// Returns the bodies that are awake, by id. Takes a time that does not depend on the others.
  std::vector<BodyId> awake_bodies() const;
  /// Returns the present moment, for BodiesChangedSince() and HasRemovedSince().
  Moment now() const;
  /// Returns the bodies that may have changed since a moment, by id; those that were added since
  /// are among them, and those that were removed are not. Takes a time that does not depend on the
  /// others, apart from the static ones.
  std::vector<BodyId> BodiesChangedSince(const Moment& moment) const;
  /// Returns true if bodies were removed since a moment, even if they have returned.
  bool HasRemovedSince(const Moment& moment) const;
  /// Returns true if all bodies sleep and no articulation moves: a step would change nothing.
  bool is_at_rest() const;

  /// Wakes all bodies; needed after an object was put among them at once.
  void WakeAll();
  /// Advances the world by config().step_seconds; does nothing at rest.
  void Step();

  /// Returns a hash of all poses, velocities and sleep states, of articulations' positions, targets
  /// and references, of joints with their state, and of the pairs that pass through each other or
  /// fit closely. It excludes definitions of bodies and contact points; those are in Save().
  std::uint64_t state_hash() const;

  /// Returns the complete state.
  Snapshot Save() const;
  /// Restores the complete state.
  /// @throws std::invalid_argument if the snapshot's objects or joints contradict themselves or
  ///         lack an articulation of this world: the world is then unchanged. The same if its
  ///         `state` does not fit its objects: the world then has these objects, but no valid state
  ///         until it is restored from another snapshot.
  void Restore(const Snapshot& snapshot);

 private:
  void ApplyGravity();
  template <class Part>
  Part& Changing(const std::unique_ptr<Part>& part);

  WorldConfig config_;
  std::unique_ptr<Engine> engine_;  ///< Bullet's objects; outlives the members below
  std::unique_ptr<WorldObjects> objects_;
  std::unique_ptr<HeldBodies> held_bodies_;
  std::unique_ptr<JointSet> joints_;
  std::unique_ptr<ExemptPairs> exempt_pairs_;
  std::unique_ptr<mechanics::CollisionExemptions> exemptions_;
};

}  // namespace smile::physics

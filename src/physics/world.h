#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "physics/articulation.h"
#include "physics/body.h"
#include "physics/contact.h"
#include "physics/joint.h"
#include "physics/snapshot.h"
#include "physics/world_config.h"

namespace smile::physics {

class CollisionExemptions;
class HeldBodies;
class JointSet;
class WorldObjects;
struct Engine;

/// Rigid bodies and articulations under gravity, stepped at a fixed rate.
///
/// Same calls, same bits: results depend only on the calls made and the state they found, never on
/// addresses, time or threads. Save() and Restore() are exact, contacts included. Not thread-safe;
/// any number of worlds may live in different threads, with equal `sleep_after_seconds`.
class World {
 public:
  explicit World(const WorldConfig& config = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const WorldConfig& config() const { return config_; }

  /// A body without solids passes through everything, and floats.
  /// @throws std::invalid_argument if a number is not finite or a mass negative.
  BodyId AddBody(const BodySpec& spec);
  /// Wakes what it touched; ends the joints it was part of.
  void RemoveBody(BodyId id);
  ArticulationId AddArticulation(const scene::ArticulationSpec& spec);
  /// Gives a body another form in its place; it keeps its velocity, its joints and who carries it.
  /// Wakes it and what is near.
  /// @throws std::invalid_argument like AddBody(), or if it would become static or cease to be.
  void ChangeForm(BodyId id, const std::vector<scene::Solid>& solids,
                  const scene::MassProperties& mass);

  /// Starts to hold bodies together. What a weld holds becomes carried. Wakes the bodies.
  /// @throws std::invalid_argument if a number is not finite, limits are the wrong way round, or
  ///         both bodies are static or the same; std::logic_error if one does not exist.
  JointId AddJoint(const JointSpec& spec);
  /// Ends a joint and wakes its bodies; what a weld held is no longer carried.
  void RemoveJoint(JointId id);
  /// Returns all bodies that hang together with this one through joints other than welds, not
  /// through static bodies; static ones are not among them, the body itself is. By id.
  /// @param without  a joint that does not count.
  std::vector<BodyId> Assembly(BodyId id, JointId without = {}) const;
  /// True when a joint other than `without` ties its assembly to a static body.
  bool IsAnchored(BodyId id, JointId without = {}) const;
  /// Moves a body to a pose at once, at rest, and all that hangs together with it likewise.
  void MoveAssembly(BodyId id, const RigidTransform& X_WB);

  /// Lets two bodies pass through each other until they overlap by at most 0.5 mm: for what was in
  /// the other when its joint ended. Until they no longer overlap at all they are a close fit, as a
  /// screw in a hole of its own radius: contacts between them then begin to bear 0.5 mm deeper, so
  /// that the screw rests in its hole and slides out of it.
  void IgnoreCollisionUntilSeparated(BodyId a, BodyId b);
  /// Returns what this body would overlap by more than `depth` [m] if it stood there, without what
  /// it may pass through.
  Overlaps OverlapsAt(BodyId id, const RigidTransform& X_WB, double depth) const;
  /// Returns what a body of these solids would overlap by more than `depth` [m] there.
  Overlaps OverlapsOf(const std::vector<scene::Solid>& solids, const RigidTransform& X_WB,
                      double depth) const;

  bool Has(BodyId id) const;
  Body& body(BodyId id);  ///< @throws std::logic_error if there is no such body
  const Body& body(BodyId id) const;
  Articulation& articulation(ArticulationId id);
  const Articulation& articulation(ArticulationId id) const;
  const std::vector<Joint>& joints() const;

  /// Returns the contacts of bodies with a link, by body. Contacts up to 0.1 mm apart count.
  std::vector<Contact> ContactsWith(ArticulationId id, int link) const;
  /// Returns all bodies that touch this one, static ones too, by id: those up to 0.1 mm apart, and
  /// those that bounced off it in the last step.
  std::vector<BodyId> BodiesTouching(BodyId id) const;

  /// True when every body sleeps and no articulation moves: a step would change nothing.
  bool is_at_rest() const;

  /// Wakes all bodies, as is needed after something was put among them at once.
  void WakeAll();
  /// Advances by config().step_seconds.
  void Step();

  /// Returns a hash of all poses, velocities and sleep states, of articulations' positions, targets
  /// and references, of joints with their state, and of the pairs that pass through each other or
  /// fit closely. Not of what bodies are, nor of contact points: those are in Save().
  std::uint64_t state_hash() const;

  Snapshot Save() const;
  /// @throws std::invalid_argument if the snapshot's objects or joints contradict themselves or
  ///         lack an articulation of this world: the world is then unchanged. The same if its
  ///         `state` does not fit its objects: the world then has these objects, but in no state
  ///         to go on from, until it is restored from another snapshot.
  void Restore(const Snapshot& snapshot);

 private:
  void ApplyGravity();

  WorldConfig config_;
  std::unique_ptr<Engine> engine_;  ///< Bullet's objects; outlives what follows
  std::unique_ptr<WorldObjects> objects_;
  std::unique_ptr<HeldBodies> held_bodies_;
  std::unique_ptr<JointSet> joints_;
  std::unique_ptr<CollisionExemptions> exemptions_;
};

}  // namespace smile::physics

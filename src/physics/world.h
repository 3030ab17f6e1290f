#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "physics/articulation.h"
#include "physics/body.h"
#include "physics/joint.h"
#include "physics/snapshot.h"

class btCollisionObject;
class btMultiBodyFixedConstraint;
class btTransform;

namespace smile::physics {

class JointConstraint;
class JointGroups;

/// The numbers of the simulation; how they were found stands in docs/decisions/physics.md.
struct WorldConfig {
  double step_seconds = 1.0 / 480;
  double gravity = 9.81;  ///< along -z [m/s2]
  int solver_iterations = 20;
  double sleep_after_seconds = 1.0;  ///< at rest for this long, an island falls asleep
  double sleep_linear_speed = 0.03;  ///< below this it counts as at rest [m/s]
  double sleep_angular_speed = 0.3;  ///< [rad/s]
  double damping = 0.2;              ///< share of a velocity lost per second
  /// False: what comes free in a hole of its own size jams, as in recordings of physics version 1.
  bool eases_close_fits = true;
  MotorConfig motor;

  bool operator==(const WorldConfig&) const = default;
};

/// A point where two things touch.
struct Contact {
  BodyId body;              ///< the other one
  Vector3 p_WQ;             ///< on the link's surface [m]
  Vector3 normal_in_world;  ///< unit, pointing from the body to the link
  double distance = 0;      ///< [m], negative when they overlap
};

/// What a body overlaps.
struct Overlaps {
  std::vector<BodyId> bodies;      ///< static ones too, by id
  bool with_articulation = false;  ///< a link or the base of one

  bool operator==(const Overlaps&) const = default;
};

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

  /// Starts to hold together. What a weld holds becomes carried. Wakes the bodies.
  /// @throws std::invalid_argument if a number is not finite, limits are the wrong way round, or
  ///         both bodies are static or the same; std::logic_error if one does not exist.
  JointId AddJoint(const JointSpec& spec);
  /// Ends it, and wakes the bodies; what a weld held is no longer carried.
  void RemoveJoint(JointId id);
  /// All bodies that hang together with this one through joints other than welds, not through
  /// static bodies; static ones are not among them, the body itself is. By id.
  /// @param without  a joint that does not count.
  std::vector<BodyId> Assembly(BodyId id, JointId without = {}) const;
  /// True when a joint other than `without` ties its assembly to a static body.
  bool IsAnchored(BodyId id, JointId without = {}) const;
  /// Puts a body there at once, at rest, and all that hangs together with it likewise.
  void MoveAssembly(BodyId id, const RigidTransform& X_WB);

  /// Lets the two pass through each other until they overlap by at most 0.5 mm: for what was inside
  /// the other when its joint ended. Until they no longer overlap at all they are a close fit, as a
  /// screw in a hole of its own radius: contacts between them then begin to bear 0.5 mm deeper, so
  /// that the screw rests in its hole and slides out of it.
  void LetPass(BodyId a, BodyId b);
  /// What this body would overlap by more than `depth` [m] if it stood there. Not what it may pass
  /// through.
  Overlaps OverlapsAt(BodyId id, const RigidTransform& X_WB, double depth) const;
  /// What a body of these solids would overlap by more than `depth` [m] if it were added there.
  Overlaps OverlapsOf(const std::vector<scene::Solid>& solids, const RigidTransform& X_WB,
                      double depth) const;

  bool Has(BodyId id) const;
  Body& body(BodyId id);  ///< @throws std::logic_error if there is no such body
  const Body& body(BodyId id) const;
  Articulation& articulation(ArticulationId id);
  const Articulation& articulation(ArticulationId id) const;
  const std::vector<Joint>& joints() const;

  /// Everything that touches a link now, nearest ids first. Contacts up to 0.1 mm apart count.
  std::vector<Contact> ContactsWith(ArticulationId id, int link) const;
  /// All bodies that touch this one, static ones too, by id: those up to 0.1 mm apart, and those
  /// that bounced off it in the last step.
  std::vector<BodyId> BodiesTouching(BodyId id) const;

  /// True when every body sleeps and no articulation moves: a step would change nothing.
  bool is_at_rest() const;

  /// Lets every body look around again, after something was put among them at once.
  void WakeAll();
  /// Advances by config().step_seconds.
  void Step();

  /// Of all poses, velocities and sleep states, of articulations' positions, targets and
  /// references, of joints with what they remember, and of who passes through whom. Not of what
  /// bodies are, nor of contact points: those are in Save().
  std::uint64_t state_hash() const;

  Snapshot Save() const;
  /// @throws std::invalid_argument if the snapshot's objects or joints contradict themselves or
  ///         lack an articulation of this world: the world is then unchanged. The same if its
  ///         `state` does not fit its objects: the world then has these objects, but in no state
  ///         to go on from, until it is restored from another snapshot.
  void Restore(const Snapshot& snapshot);

 private:
  struct Engine;

  void Insert(std::unique_ptr<Body> body);
  void Insert(std::unique_ptr<Articulation> articulation);
  void Erase(Body& body);
  void WakeTouching(const Body& body);
  void WakeNear(const Body& body);

  void CheckJoint(const JointSpec& spec) const;
  void Insert(const Joint& joint);
  void ExcludeLinks(const WeldSpec& weld);
  std::unique_ptr<btMultiBodyFixedConstraint> MakeBulletWeld(const WeldSpec& spec);
  std::unique_ptr<JointConstraint> MakeBulletJoint(const Joint& joint);
  void RejoinBullet(BodyId id);
  void WakeJoined(const JointSpec& spec);
  /// Itself and those that hang on it through joints, up to and with static ones; by id.
  std::vector<BodyId> BodiesJoinedWith(BodyId id, JointId without) const;
  /// Sets what gravity does to bodies in the next step.
  void PullDown();
  bool IsLed(const WeldSpec& weld) const {
    return articulation(weld.articulation).spec().is_kinematic;
  }
  void SetLed(BodyId id, bool is_led);
  /// Gives what kinematic articulations hold its velocity for the next step.
  void LeadHeldBodies();
  /// And its place after it.
  void PlaceHeldBodies();
  /// A carried body moves what hangs on it as if it had the mass of all of it; see the decisions.
  void LoadCarriedBodies();
  void DampSliders();
  std::vector<double> InverseMassesOf(const JointGroups& rigid) const;

  template <class IsOver>
  void EndPassing(IsOver is_over);
  void EndPassingOf(BodyId id);
  /// Turns those that hardly overlap any more into close fits, and ends these when they are apart.
  void EndPassingApart();
  void EndCloseFitsApart();
  void EndAllPassing();
  Overlaps OverlapsOf(const Body& body, const RigidTransform& X_WB, double depth) const;
  double OverlapDepth(const Body& a, const btTransform& X_WAcm, const btCollisionObject& b) const;
  double OverlapDepth(const std::pair<BodyId, BodyId>& pair) const;
  bool IsAnyAwake(const std::pair<BodyId, BodyId>& pair) const;

  void MatchObjects(const Snapshot& snapshot);

  WorldConfig config_;
  std::unique_ptr<Engine> engine_;  ///< Bullet's objects; outlives what follows
  std::uint32_t next_id_ = 1;       ///< bodies and links share one counter: it orders everything
  std::uint32_t next_joint_id_ = 1;
  std::vector<std::unique_ptr<Articulation>> articulations_;
  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<Joint> joints_;                          ///< by id
  std::vector<std::pair<BodyId, BodyId>> passing_;     ///< sorted, the smaller id first
  std::vector<std::pair<BodyId, BodyId>> close_fits_;  ///< likewise; see LetPass()
};

}  // namespace smile::physics

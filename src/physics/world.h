#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physics/articulation.h"
#include "physics/body.h"
#include "physics/joint.h"
#include "physics/snapshot.h"

namespace smile::physics {

/// The numbers of the simulation; how they were found stands in docs/decisions/physics.md.
struct WorldConfig {
  double step_seconds = 1.0 / 480;
  double gravity = 9.81;  ///< along -z [m/s2]
  int solver_iterations = 20;
  double sleep_after_seconds = 1.0;  ///< at rest for this long, an island falls asleep
  double sleep_linear_speed = 0.03;  ///< below this it counts as at rest [m/s]
  double sleep_angular_speed = 0.3;  ///< [rad/s]
  double damping = 0.2;              ///< share of a velocity lost per second
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

  /// @throws std::invalid_argument if a number is not finite, a mass negative or there is no solid.
  BodyId AddBody(const BodySpec& spec);
  /// Wakes what it touched; ends the joints it was part of.
  void RemoveBody(BodyId id);
  ArticulationId AddArticulation(const ArticulationSpec& spec);
  /// Starts to hold `spec.body`; it becomes carried.
  JointId AddWeld(const WeldSpec& spec);
  /// Ends it; the body is no longer carried.
  void RemoveJoint(JointId id);

  bool Has(BodyId id) const;
  Body& body(BodyId id);  ///< @throws std::logic_error if there is no such body
  const Body& body(BodyId id) const;
  Articulation& articulation(ArticulationId id);
  const Articulation& articulation(ArticulationId id) const;
  const std::vector<Joint>& joints() const;

  /// Everything that touches a link now, nearest ids first. Contacts up to 0.1 mm apart count.
  std::vector<Contact> ContactsWith(ArticulationId id, int link) const;

  /// True when every body sleeps and no articulation moves: a step would change nothing.
  bool is_at_rest() const;

  /// Lets every body look around again, after something was put among them at once.
  void WakeAll();
  /// Advances by config().step_seconds.
  void Step();

  /// Of all poses, velocities, sleep states, joint positions and targets.
  std::uint64_t state_hash() const;

  Snapshot Save() const;
  /// @throws std::invalid_argument if the snapshot contradicts itself; the world is then unchanged
  ///         unless its bodies had to be rebuilt.
  void Restore(const Snapshot& snapshot);

 private:
  struct Engine;

  void Insert(std::unique_ptr<Body> body);
  void Insert(std::unique_ptr<Articulation> articulation);
  void Erase(Body& body);
  void AddBulletWeld(const Joint& joint);
  void MatchObjects(const Snapshot& snapshot);

  WorldConfig config_;
  std::unique_ptr<Engine> engine_;  ///< Bullet's objects; outlives what follows
  std::uint32_t next_id_ = 1;       ///< bodies and links share one counter: it orders everything
  std::uint32_t next_joint_id_ = 1;
  std::vector<std::unique_ptr<Articulation>> articulations_;
  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<Joint> joints_;
};

}  // namespace smile::physics

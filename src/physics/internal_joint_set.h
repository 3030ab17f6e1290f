#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "physics/definitions.h"
#include "physics/internal_held_bodies.h"
#include "physics/internal_joint_constraint.h"
#include "physics/internal_world_objects.h"

namespace smile::physics {

/// Joints of a World, by id. Joints between bodies are constraints of Bullet's world; welds are
/// passed on to HeldBodies.
class JointSet {
 public:
  /// All must outlive it.
  JointSet(const WorldObjects& objects, HeldBodies& held_bodies, Engine& engine);
  ~JointSet();
  JointSet(const JointSet&) = delete;
  JointSet& operator=(const JointSet&) = delete;

  const std::vector<Joint>& joints() const { return joints_; }
  /// Returns true if there is a joint other than a weld.
  bool has_constraints() const { return !constraints_.empty(); }
  /// Calls visit(const Joint&, JointConstraint&) for each joint between bodies, by id, except those
  /// of dormant islands.
  template <class Visit>
  void ForEachPresent(Visit visit) const {
    for (btTypedConstraint* present : engine_.world.joints()) {
      const JointId id{static_cast<std::uint32_t>(present->getUserConstraintId())};
      visit(*std::ranges::lower_bound(joints_, id, {}, &Joint::id),
            static_cast<JointConstraint&>(*present));
    }
  }

  /// See World. All of these wake the bodies.
  JointId Add(const JointSpec& spec);
  void Remove(JointId id);
  void RemoveAllOf(BodyId id);
  void RemoveAll();
  /// Makes the joints of a body whose form changed again for the new one, each in its place in the
  /// order.
  void Rejoin(BodyId id);

  /// Adds the joints to the snapshot, and their states to `state`.
  void Save(Snapshot* snapshot, ByteWriter* state) const;
  /// Returns true if the joints are those of the snapshot, apart from their states.
  bool AreThoseOf(const Snapshot& snapshot) const { return joints_ == snapshot.joints; }
  /// Makes the joints of a snapshot of the same objects. Call RemoveAll() before, unless they are
  /// its joints already.
  void Restore(const Snapshot& snapshot);
  void RestoreState(ByteReader* in);
  void AddTo(StateHash* hash) const;

 private:
  void Check(const JointSpec& spec) const;
  /// Adds a joint whose id is greater than all others.
  void Insert(const Joint& joint);
  void Wake(const std::pair<BodyId, BodyId>& pair);
  std::unique_ptr<JointConstraint> MakeConstraint(const Joint& joint) const;

  const WorldObjects& objects_;
  HeldBodies& held_bodies_;
  Engine& engine_;
  std::uint32_t next_id_ = 1;
  std::vector<Joint> joints_;  ///< by id
  std::map<JointId, std::unique_ptr<JointConstraint>> constraints_;
};

}  // namespace smile::physics

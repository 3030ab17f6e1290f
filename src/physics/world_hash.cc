#include <string_view>

#include "base/bytes.h"
#include "base/state_hash.h"
#include "physics/internal_engine.h"
#include "physics/internal_joint_bytes.h"
#include "physics/world.h"

namespace smile::physics {

std::uint64_t World::state_hash() const {
  StateHash hash;
  const auto add_vector = [&hash](const btVector3& v) {
    for (int i = 0; i < 3; ++i) hash.Add(static_cast<double>(v[i]));
  };
  for (const auto& body : bodies_) {
    const btRigidBody& bullet = *body->bullet_;
    hash.Add(std::uint64_t{body->id().value});
    for (int row = 0; row < 3; ++row) add_vector(bullet.getWorldTransform().getBasis()[row]);
    add_vector(bullet.getWorldTransform().getOrigin());
    add_vector(bullet.getLinearVelocity());
    add_vector(bullet.getAngularVelocity());
    hash.Add(static_cast<std::uint64_t>(bullet.getActivationState()));
    hash.Add(static_cast<double>(bullet.getDeactivationTime()));
  }
  for (const auto& articulation : articulations_) {
    hash.Add(std::uint64_t{articulation->id().value});
    hash.Add(articulation->positions());
    hash.Add(articulation->velocities());
    hash.Add(articulation->velocity_targets_);
    hash.Add(articulation->position_references_);
  }
  for (const Joint& joint : joints_) {
    ByteWriter bytes;
    PutJoint(joint, &bytes);
    const auto bullet = engine_->joints.find(joint.id);
    if (bullet != engine_->joints.end()) bullet->second->Save(&bytes);
    hash.Add(std::string_view(reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size()));
  }
  for (const auto& [a, b] : passing_) {
    hash.Add(std::uint64_t{a.value});
    hash.Add(std::uint64_t{b.value});
  }
  // Nothing is added without them: hashes of worlds that never had any stay as they were.
  if (!close_fits_.empty()) hash.Add("close fits");
  for (const auto& [a, b] : close_fits_) {
    hash.Add(std::uint64_t{a.value});
    hash.Add(std::uint64_t{b.value});
  }
  return hash.value();
}

}  // namespace smile::physics

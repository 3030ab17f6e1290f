#include "mechanics/rigid_masses.h"

namespace smile::mechanics {
namespace {

JointGroups RigidGroupsOf(std::span<const RigidMasses::Member> members,
                          std::span<const Joint> joints) {
  std::vector<JointGroups::Member> bodies;
  for (const RigidMasses::Member& one : members) bodies.push_back({one.body, one.is_static});
  return {bodies, joints, /*only_fixed=*/true};
}

}  // namespace

RigidMasses::RigidMasses(std::span<const Member> members, std::span<const Joint> joints)
    : groups_(RigidGroupsOf(members, joints)), inverse_masses_(members.size(), 0.0) {
  for (const Member& one : members) inverse_masses_[groups_.group_of(one.body)] += one.mass;
  for (std::size_t i = 0; i < inverse_masses_.size(); ++i) {
    // Infinite mass: the other side takes all of the change.
    double& mass = inverse_masses_[i];
    mass = groups_.is_anchored(static_cast<int>(i)) ? 0 : 1 / mass;
  }
}

}  // namespace smile::mechanics

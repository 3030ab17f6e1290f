#include "mechanics/carried_load.h"

#include "mechanics/joint_graph.h"

namespace smile::mechanics {
namespace {

/// Returns the moment of inertia [kg m2] that another body adds to a carried one, as if the two
/// were one rigid body: an upper bound for all axes (parallel axis theorem).
double MomentAbout(const LoadMember& carried, const LoadMember& other) {
  const Vector3 arm = other.p_WBcm - carried.p_WBcm;
  // The moment about any axis is at most half the trace: the largest principal moment is at most
  // the sum of the other two.
  return other.mass->inertia.trace() / 2 + other.mass->mass * arm.squaredNorm();
}

}  // namespace

std::vector<CarriedLoad> CarriedLoads(std::span<const LoadMember> members,
                                      std::span<const Joint> joints) {
  std::vector<JointGroups::Member> bodies;
  for (const LoadMember& member : members) bodies.push_back({member.body, member.is_static});
  const JointGroups groups(bodies, joints, /*only_fixed=*/false);
  std::vector<std::vector<std::size_t>> carried_in(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].is_carried) carried_in[groups.group_of(members[i].body)].push_back(i);
  }
  std::vector<CarriedLoad> loads(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const LoadMember& one = members[i];
    if (one.is_static) continue;
    for (const std::size_t carried : carried_in[groups.group_of(one.body)]) {
      loads[i].is_with_carried = true;
      if (carried == i) continue;
      loads[carried].mass += one.mass->mass;
      loads[carried].moment += MomentAbout(members[carried], one);
    }
  }
  return loads;
}

}  // namespace smile::mechanics

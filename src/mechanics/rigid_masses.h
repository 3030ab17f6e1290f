#pragma once

#include <span>
#include <vector>

#include "mechanics/joint_graph.h"

namespace smile::mechanics {

/// Masses of the groups that fixed joints make of bodies.
class RigidMasses {
 public:
  struct Member {
    BodyId body;
    bool is_static = false;
    double mass = 0;  ///< with its load [kg]
  };
  /// @param members  by id.
  RigidMasses(std::span<const Member> members, std::span<const Joint> joints);

  /// Returns the inverse mass of all that is fixed to a body [1/kg]; 0 if one is static.
  double InverseMassOf(BodyId id) const { return inverse_masses_[groups_.group_of(id)]; }

 private:
  JointGroups groups_;
  std::vector<double> inverse_masses_;  ///< by group
};

}  // namespace smile::mechanics

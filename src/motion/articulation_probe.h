#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/solid_probe.h"
#include "scene/articulation_spec.h"

namespace smile::motion {

/// Number that stands for the environment where links are numbered; -1 is the base.
inline constexpr int kEnvironment = -2;

/// Two links that overlap.
struct LinkOverlap {
  int link = -1;     ///< the one with the larger number
  int other = -1;    ///< -1: the base; or kEnvironment
  double depth = 0;  ///< [m]

  bool operator==(const LinkOverlap&) const = default;
};

/// Collision checker for planners: reports whether an articulation overlaps itself or its
/// environment at any configuration, without a world. Results depend on the inputs only, not on
/// earlier calls. For one thread at a time.
class ArticulationProbe {
 public:
  /// @param environment  static solids around it; Solid::X_BS is X_WS. The base may touch them.
  explicit ArticulationProbe(const scene::ArticulationSpec& spec,
                             const std::vector<scene::Solid>& environment = {});

  /// Returns the first two links, in their order, that overlap by more than `depth` and are not in
  /// `never_collide`; nullopt if there are none.
  ///
  /// @param q      one value per link [rad or m].
  /// @param depth  tolerance [m]; links that only touch overlap by rounding.
  /// @throws std::invalid_argument if `q` has the wrong size or is not finite.
  std::optional<LinkOverlap> FirstOverlap(std::span<const double> q, double depth = 0.0005);

  /// Returns all pairs of links that overlap by more than `depth` and are not in `never_collide`,
  /// the smaller number first, in ascending order, each once.
  std::vector<std::pair<int, int>> AllOverlaps(std::span<const double> q, double depth = 0.0005);

 private:
  /// A link L, the base or the environment: convex pieces that move together.
  struct Body {
    int link;
    std::vector<RigidTransform> X_LP;  ///< of its pieces P
    std::size_t first_piece;           ///< in the probe
    Vector3 p_LQ;                      ///< center of a ball around them
    double radius;                     ///< of that ball [m]
    RigidTransform X_WL;               ///< where it is now
    Vector3 p_WQ;
    std::int64_t num_moves = 0;
  };
  /// Two bodies that may collide.
  struct Pair {
    std::size_t body, other;
    /// When they were last found not to overlap by more than `clear_depth`.
    std::pair<std::int64_t, std::int64_t> clear_at_moves{-1, -1};
    double clear_depth = 0;  ///< [m]
  };

  void AddBody(int link, const std::vector<scene::Solid>& solids, const RigidTransform& X_WL);
  /// Puts the links where they are at a configuration.
  void Pose(std::span<const double> q);
  /// Returns the depth of an overlap of two bodies that is deeper than `depth`; 0 if there is none.
  double DepthOf(Pair& pair, double depth);

  std::vector<scene::LinkSpec> links_;
  RigidTransform X_WBase_;
  std::vector<Body> bodies_;   ///< the environment, the base, and the links, in this order
  std::vector<Pair> pairs_;    ///< in the order of bodies
  physics::SolidProbe probe_;  ///< of the pieces
};

}  // namespace smile::motion

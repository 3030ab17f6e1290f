#pragma once

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
  /// A convex solid S, fixed to a link L.
  struct Piece {
    int link;
    RigidTransform X_LS;
  };

  /// Puts the pieces where their links are at a configuration.
  void Pose(std::span<const double> q);

  std::vector<scene::LinkSpec> links_;
  RigidTransform X_WBase_;
  std::vector<Piece> pieces_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< indexes of pieces that may collide
  physics::SolidProbe probe_;                               ///< of the pieces
};

}  // namespace smile::motion

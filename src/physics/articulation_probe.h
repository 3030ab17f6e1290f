#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/articulation_spec.h"

namespace smile::physics {

/// Stands for what surrounds an articulation, where links are numbered; -1 is its base.
inline constexpr int kEnvironment = -2;

/// Two that reach into each other.
struct LinkOverlap {
  int link = -1;     ///< the one with the larger number
  int other = -1;    ///< -1: the base; kEnvironment
  double depth = 0;  ///< [m]

  bool operator==(const LinkOverlap&) const = default;
};

/// Tells whether an articulation touches itself or what stands around it, at any configuration and
/// without a world: what a planner asks many times. Same inputs give the same answer, whatever was
/// asked before. To be used from one thread at a time.
class ArticulationProbe {
 public:
  /// @param environment  what is static around it; Solid::X_BS is X_WS. The base may touch it.
  explicit ArticulationProbe(const scene::ArticulationSpec& spec,
                             const std::vector<scene::Solid>& environment = {});
  ~ArticulationProbe();
  ArticulationProbe(ArticulationProbe&&) noexcept;
  ArticulationProbe& operator=(ArticulationProbe&&) noexcept;

  /// The first two, in the order of links, that overlap by more than `depth` and are not in
  /// `never_collide`; nullopt when all is free.
  ///
  /// @param q      one value per link [rad or m].
  /// @param depth  what merely touches overlaps by rounding [m].
  /// @throws std::invalid_argument if `q` has the wrong size or is not finite.
  std::optional<LinkOverlap> FirstOverlap(std::span<const double> q, double depth = 0.0005);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace smile::physics

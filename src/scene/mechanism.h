#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "math/color.h"
#include "math/rigid_transform.h"

namespace smile::scene {

struct ObjectSpec;

/// Slider: two objects, of which the second slides along a rail of the first, as a drawer does,
/// without turning or moving sideways.
///
/// The rail is the x axis of frame J. The offset is the distance of the second object's reference
/// point from the first's, counted along **-x**; `initial_offset` is where it starts.
struct SliderSpec {
  std::string id;  ///< as in the file; may be empty
  RigidTransform X_WJ;
  RigidTransform X_JA;           ///< the first object A as written
  RigidTransform X_JB;           ///< the second object B as written, at offset 0
  std::size_t first_object = 0;  ///< A in SceneSpec::objects; B is the next
  double min_offset = 0, max_offset = 0.1, initial_offset = 0;  ///< [m]
  bool do_members_collide = false;
  /// Fraction of the sliding speed lost in a second: 0 slides freely, 1 stays where it is put.
  /// While one of the two is held, the other is free.
  double damping = 0;
  double restitution = 0.7;  ///< fraction of the speed kept when it bounces off its limits
  /// Fraction of the range from the middle to a limit that is free; beyond it the resistance
  /// increases. 1: a hard stop.
  double softness = 1;

  RigidTransform pose_of_first() const { return X_WJ * X_JA; }
  RigidTransform pose_of_second() const {
    return X_WJ * (RigidTransform(Vector3(-initial_offset, 0, 0)) * X_JB);
  }
  bool operator==(const SliderSpec&) const = default;
};

/// Chain of links between two fixed ends. Each link is an object of its own.
struct ChainSpec {
  std::string id;                     ///< unique; those of its pieces begin with it
  std::string start_id, end_id;       ///< of the fixed end pieces
  std::vector<std::string> link_ids;  ///< one per link, from start to end; at least one
  Color color;                        ///< of the links
  Vector3 p_WStart = Vector3::Zero(), p_WEnd = Vector3::Zero();  ///< [m]
  Vector3 link_size{0.01, 0.1, 0.01};                            ///< y: along the chain [m]
  double link_padding = 0.005;   ///< by which a link is drawn longer at both ends [m]
  double link_mass = 1;          ///< [kg]
  bool can_be_cut = true;        ///< tools that cut can part it between any two pieces
  std::size_t first_object = 0;  ///< its start in SceneSpec::objects; then its end, then its links

  bool operator==(const ChainSpec&) const = default;
};

/// Returns the pieces of a chain as objects: start, end, links. Ends are static white cubes of one
/// tenth of a unit; a link's local y points from start to end, its z as far up as possible.
std::vector<ObjectSpec> PiecesOf(const ChainSpec& chain, double meters_per_unit);

}  // namespace smile::scene

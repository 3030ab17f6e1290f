#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/shared_list.h"
#include "mechanics/body_spec.h"
#include "mechanics/joint.h"
#include "scene/articulation_spec.h"

namespace smile::mechanics {

/// Complete state of a World: restored into the same world, a fresh one, or one in another process,
/// the next steps give the same bits.
///
/// States are numbers field by field (no padding): per body and link the poses, velocities, sleep
/// state and bounds; per articulation q, v, references and targets; all joints and contact points
/// with the impulses they start from. Definitions of bodies are kept by reference to their
/// unchanging specs. The states of bodies are kept by reference, too: snapshots between which
/// nothing happened to a body share its state, and most of their lists of bodies.
struct Snapshot {
  struct BodyEntry {
    BodyId id;
    std::shared_ptr<const BodySpec> spec;
    /// Its motion and its contacts with links, static bodies, and bodies that can move and came
    /// before it.
    std::shared_ptr<const std::vector<std::byte>> state;
  };
  struct ArticulationEntry {
    ArticulationId id;
    std::shared_ptr<const scene::ArticulationSpec> spec;
  };

  std::uint32_t next_id = 1;
  std::uint32_t next_joint_id = 1;
  SharedList<BodyEntry> bodies;
  std::vector<ArticulationEntry> articulations;
  std::vector<Joint> joints;
  /// Pairs that pass through each other, and close fits; see
  /// World::IgnoreCollisionUntilSeparated().
  std::vector<std::pair<BodyId, BodyId>> passing, close_fits;
  std::vector<std::byte> state;  ///< of all but the bodies
};

/// Writes a joint as Serialize() does.
void PutJoint(const Joint& joint, ByteWriter* out);

/// Returns a self-contained byte string, for a file or another process of the same build.
std::vector<std::byte> Serialize(const Snapshot& snapshot);

/// Returns the snapshot that Serialize() wrote.
/// @throws std::runtime_error if the bytes are not a whole snapshot of this format version.
Snapshot ParseSnapshot(std::span<const std::byte> bytes);

}  // namespace smile::mechanics

#pragma once

#include "base/bytes.h"
#include "physics/joint.h"

namespace smile::physics {

/// Writes a joint as in a serialized snapshot.
void PutJoint(const Joint& joint, ByteWriter* out);

}  // namespace smile::physics

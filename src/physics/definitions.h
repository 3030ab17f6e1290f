#pragma once

#include "mechanics/body_spec.h"
#include "mechanics/ids.h"
#include "mechanics/joint.h"
#include "mechanics/snapshot.h"

namespace smile::physics {

// What a World is made of, as data: these are words of this room, too.
using mechanics::ArticulationId;
using mechanics::BallJointSpec;
using mechanics::BodyId;
using mechanics::BodySpec;
using mechanics::FixedJointSpec;
using mechanics::Joint;
using mechanics::JointId;
using mechanics::JointSpec;
using mechanics::SliderJointSpec;
using mechanics::Snapshot;
using mechanics::WeldSpec;

}  // namespace smile::physics

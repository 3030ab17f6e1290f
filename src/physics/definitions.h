#pragma once

#include "mechanics/body_spec.h"
#include "mechanics/contact.h"
#include "mechanics/ids.h"
#include "mechanics/joint.h"
#include "mechanics/moment.h"
#include "mechanics/snapshot.h"
#include "mechanics/world_config.h"

namespace smile::physics {

// What a World is made of and tells, as data: these are words of this room, too.
using mechanics::ArticulationId;
using mechanics::BallJointSpec;
using mechanics::BodyId;
using mechanics::BodySpec;
using mechanics::FixedJointSpec;
using mechanics::Joint;
using mechanics::JointId;
using mechanics::JointSpec;
using mechanics::LinkContact;
using mechanics::Moment;
using mechanics::MotorConfig;
using mechanics::Overlaps;
using mechanics::Push;
using mechanics::SliderJointSpec;
using mechanics::Snapshot;
using mechanics::WeldSpec;
using mechanics::WorldConfig;

}  // namespace smile::physics

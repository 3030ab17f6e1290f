#pragma once

#include "mechanics/joint.h"

namespace smile::mechanics {

/// Returns the fraction of its speed that a slider keeps in a step, for its damping and softness.
/// @param offset  of the slider [m].
/// @param speed  of the offset [m/s].
/// @param is_carried  true if a hand carries one of its bodies: then it has no damping.
/// @param seconds  duration of the step.
double FractionKept(const SliderJointSpec& slider, double offset, double speed, bool is_carried,
                    double seconds);

}  // namespace smile::mechanics

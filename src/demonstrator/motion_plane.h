#pragma once

#include <optional>

#include "demonstrator/demonstrator.h"

namespace smile::demonstrator {

/// Plane in which a hand moves with a mouse, through the hand's goal.
struct MotionPlane {
  double angle_deg = 0;  ///< of a vertical one: from the x axis, counterclockwise seen from above
  bool is_level = false;
};

/// Returns the point [m] where a ray meets a plane of a hand that holds something; nullopt with the
/// reason in `refusal` if it meets none.
std::optional<Vector3> MeetPlane(HandName name, const Hand& hand, const MotionPlane& plane,
                                 const Ray& ray, Refusal* refusal);

}  // namespace smile::demonstrator

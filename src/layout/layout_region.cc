#include "layout/layout_region.h"

#include <cmath>

#include "math/angles.h"

namespace smile::layout {
namespace {

// The robot's eye, as in sim/eye.h: its position above the robot's default place, its tilt, and its
// field of view, less one percent.
constexpr double kEyeDepth = -0.20 + 0.18832, kEyeHeight = 0.20 + 0.95921;  // [m]
const double kEyeTiltCos = std::cos(DegreesToRadians(56.05));
const double kEyeTiltSin = std::sin(DegreesToRadians(56.05));
constexpr double kVerticalShare = 0.99 * 0.577350269;  // tan of 30 degrees
constexpr double kHorizontalShare = kVerticalShare * 4 / 3;

/// Returns true if the eye sees a point: sideways x, depth, and height z above the table [m].
bool IsInView(double x, double depth, double z) {
  // Coordinates along and across the eye's optical axis. The eye tilts about the horizontal x axis
  // only, so sideways distances stay as they are.
  const double away = depth - kEyeDepth, below = kEyeHeight - z;
  const double forward = away * kEyeTiltCos + below * kEyeTiltSin;
  const double down = below * kEyeTiltCos - away * kEyeTiltSin;
  return std::abs(x) <= forward * kHorizontalShare && std::abs(down) <= forward * kVerticalShare;
}

}  // namespace

Footprint LayoutRegion::StripOn(const scene::TableSpec& table) const {
  return {.center = {0, -table.y_span / 2 + (strip_near + strip_far) / 2},
          .half_size = {strip_half_width, (strip_far - strip_near) / 2}};
}

LayoutRegion LayoutRegion::ShrunkBy(double rim) const {
  LayoutRegion shrunk = *this;
  shrunk.reach -= rim;
  shrunk.reach_margin += rim;
  return shrunk;
}

bool LayoutRegion::Reaches(const scene::TableSpec& table, const Vector2& center) const {
  if (reach_map) {
    return reach_map->Contains({center.x(), center.y() + table.y_span / 2}, reach_margin);
  }
  // Both arms are alike: the nearer shoulder decides.
  const double x = std::abs(center.x()), depth = center.y() + table.y_span / 2;
  if (std::hypot(x - shoulder_x, depth - shoulder_depth) > reach) return false;
  return x <= most_x && depth >= least_depth && depth <= most_depth;
}

bool LayoutRegion::Holds(const scene::TableSpec& table, const Footprint& footprint,
                         double top) const {
  if (!Reaches(table, footprint.center)) return false;
  // The bottom and the top of each corner must be in the picture: a high object may be cut off at
  // the top although its foot is seen.
  const double edge = -table.y_span / 2;
  for (const Vector2& corner : footprint.corners()) {
    if (std::abs(corner.x()) > table.x_span / 2 - table_rim) return false;
    if (std::abs(corner.y()) > table.y_span / 2 - table_rim) return false;
    if (!has_standard_eye) continue;
    if (!IsInView(corner.x(), corner.y() - edge, 0)) return false;
    if (!IsInView(corner.x(), corner.y() - edge, top)) return false;
  }
  return true;
}

}  // namespace smile::layout

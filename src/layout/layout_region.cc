#include "layout/layout_region.h"

#include <cmath>

#include "math/angles.h"

namespace smile::layout {
namespace {

// Baxter's eye, as in model/eye.cc: its position above the robot's default place, its tilt, and the
// field of view of all eyes, less one percent.
constexpr double kEyeDepth = -0.20 + 0.18832, kEyeHeight = 0.20 + 0.95921;  // [m]
constexpr double kVerticalShare = 0.99 * 0.577350269;                       // tan of 30 degrees
constexpr double kHorizontalShare = kVerticalShare * 4 / 3;

/// Returns true if a point in the frame of an eye is in its picture.
bool IsInView(const Vector3& p_CQ) {
  return std::abs(p_CQ.x()) <= p_CQ.z() * kHorizontalShare &&
         std::abs(p_CQ.y()) <= p_CQ.z() * kVerticalShare;
}

}  // namespace

RigidTransform LayoutRegion::StandardEye() {
  const double tilt = DegreesToRadians(56.05), c = std::cos(tilt), s = std::sin(tilt);
  Matrix3 R_EC;
  R_EC << 1, 0, 0,  //
      0, -s, c,     //
      0, -c, -s;
  return {R_EC, Vector3(0, kEyeDepth, kEyeHeight)};
}

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
  const RigidTransform X_CE = X_EC.inverse();
  for (const Vector2& corner : footprint.corners()) {
    if (std::abs(corner.x()) > table.x_span / 2 - table_rim) return false;
    if (std::abs(corner.y()) > table.y_span / 2 - table_rim) return false;
    for (const double z : {0.0, top}) {
      if (!IsInView(X_CE * Vector3(corner.x(), corner.y() - edge, z))) return false;
    }
  }
  if (!touches_at_start) return true;
  Footprint from_edge = footprint;
  from_edge.center.y() -= edge;
  return !touches_at_start(from_edge, top);
}

}  // namespace smile::layout

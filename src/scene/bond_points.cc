#include "scene/bond_points.h"

namespace smile::scene {
namespace {

const RigidTransform& PoseOf(const GuestPoint& guest) { return guest.X_PG; }
const RigidTransform& PoseOf(const HostPoint& host) { return host.X_PH; }

/// Appends the points of a part and then of its children, with poses in the frame B of the object.
template <class Point>
void AppendPoints(const Part& part, std::vector<Point> Composite::*points,
                  const RigidTransform& X_BE, std::vector<PlacedPoint<Point>>* placed) {
  const auto* composite = std::get_if<Composite>(&part.shape);
  if (composite == nullptr) return;
  // The order is that of the file, parents first: indices of hosts and guests depend on it.
  for (const Point& point : composite->*points) placed->push_back({&point, X_BE * PoseOf(point)});
  for (const Part& child : composite->parts) {
    AppendPoints(child, points, X_BE * child.X_PE, placed);
  }
}

}  // namespace

std::vector<PlacedPoint<GuestPoint>> GuestsOf(const Part& whole) {
  std::vector<PlacedPoint<GuestPoint>> guests;
  AppendPoints(whole, &Composite::guests, RigidTransform(), &guests);
  return guests;
}

std::vector<PlacedPoint<HostPoint>> HostsOf(const Part& whole) {
  std::vector<PlacedPoint<HostPoint>> hosts;
  AppendPoints(whole, &Composite::hosts, RigidTransform(), &hosts);
  return hosts;
}

}  // namespace smile::scene

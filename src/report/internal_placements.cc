#include "report/internal_placements.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "math/angles.h"
#include "mesh/primitives.h"
#include "report/internal_plots.h"
#include "report/wording.h"
#include "scene/units.h"
#include "scene/visual_model.h"

namespace smile::report {
namespace {

using Point = Eigen::Vector2d;
using Outline = std::vector<Point>;

/// Returns the pose X_WB of an object in a result: its position in units of the scene, its rotation
/// as angles about fixed axes [degrees].
RigidTransform PoseIn(const Json& object, double meters_per_unit) {
  const auto vector_in = [&object](const char* name) {
    const Json& list = object.at(name);
    return Vector3(list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>());
  };
  return {Quaternion(RotationFromFixedAxes(vector_in("rotation"))),
          scene::FromFileUnits(vector_in("position"), meters_per_unit)};
}

/// Returns twice the signed area of a triangle; positive if it is counter-clockwise.
double Cross(const Point& a, const Point& b, const Point& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Returns the convex hull of points in the plane (Andrew's monotone chain algorithm).
Outline HullOf(Outline points) {
  // From left to right, and upwards where x is equal.
  std::ranges::sort(points, [](const Point& a, const Point& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Outline hull;
  // Lower chain, then upper chain; the last point of each begins the other one.
  for (int pass = 0; pass < 2; ++pass) {
    // Points of the other chain must not be removed.
    const std::size_t begin = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= begin + 2 && Cross(hull[hull.size() - 2], hull.back(), point) <= 0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

/// Projects a point orthogonally along the view direction of a side.
Point Seen(const Vector3& p_W, ViewDirection direction) {
  return direction == ViewDirection::kTop ? Point(p_W.x(), p_W.y()) : Point(p_W.x(), p_W.z());
}

/// Piece of an object, seen from one side.
struct Patch {
  Outline outline;
  Color color;
  double nearness = 0;  ///< to the viewer [m]
};

/// Returns the outlines of an object's visible pieces: convex hulls, an approximation for meshes.
std::vector<Patch> PatchesOf(const scene::Part& whole, const RigidTransform& X_WB,
                             ViewDirection direction) {
  std::vector<Patch> patches;
  for (const scene::Visual& visual : scene::VisualsOf(whole)) {
    // Controls are drawn in their first state.
    if (visual.choice >= 0 && visual.variant != 0) continue;
    const RigidTransform X_WV = X_WB * visual.X_FV;
    // All vertices; their hull is the outline of a convex piece.
    Outline points;
    double nearness = -1e9;
    for (const Eigen::Vector3f& corner : mesh::MeshOf(visual.shape).positions) {
      const Vector3 p_W = X_WV * Vector3(corner.cast<double>());
      points.push_back(Seen(p_W, direction));
      nearness = std::max(nearness, direction == ViewDirection::kTop ? p_W.z() : -p_W.y());
    }
    if (points.size() >= 3) patches.push_back({HullOf(points), visual.color, nearness});
  }
  return patches;
}

/// Transform from meters to the drawing, in which y points down.
class Frame {
 public:
  explicit Frame(Eigen::AlignedBox2d bounds) {
    constexpr double kMostHeight = 300;
    // Small scenes are shown with some surroundings.
    const Point middle = bounds.center();
    bounds.extend(middle - Point(0.3, 0.15)).extend(middle + Point(0.3, 0.15));
    // The smaller scale of both directions, so that everything fits and nothing is distorted.
    const Point size = bounds.sizes();
    scale_ = std::min((kPlotWidth - 2 * kEdge) / size.x(), kMostHeight / size.y());
    left_ = (kPlotWidth - scale_ * size.x()) / 2 - scale_ * bounds.min().x();
    // The drawing's y points down, that of the scene up: its largest y is at the top.
    top_ = kEdge + scale_ * bounds.max().y();
    height_ = scale_ * size.y() + 2 * kEdge;
  }
  double height() const { return height_; }
  double x(double meters) const { return left_ + scale_ * meters; }
  double y(double meters) const { return top_ - scale_ * meters; }
  double Length(double meters) const { return scale_ * meters; }

 private:
  static constexpr double kEdge = 8;
  double scale_ = 1, left_ = 0, top_ = 0, height_ = 0;
};

std::string PointsText(const Outline& outline, const Frame& frame) {
  std::string points;
  for (const Point& point : outline) {
    points += At(frame.x(point.x())) + "," + At(frame.y(point.y())) + " ";
  }
  return points;
}

std::string RgbText(const Color& color) {
  const auto part = [](double value) { return Fixed(255 * std::clamp(value, 0.0, 1.0), 0); };
  return "rgb(" + part(color.red) + " " + part(color.green) + " " + part(color.blue) + ")";
}

/// Returns a scale bar of 10 cm.
Markup Ruler(const Frame& frame) {
  constexpr double kRuler = 0.1;  // [m]
  const double y = frame.height() + 12, left = 8, right = left + frame.Length(kRuler);
  Markup drawing = SvgLine(left, y, right, y, "axis");
  for (double end : {left, right}) drawing += SvgLine(end, y - 3, end, y + 3, "axis");
  drawing += SvgText(right + 6, y + 4, "", "10 cm");
  return drawing;
}

}  // namespace

std::vector<Placement> PlacementsOf(const Json& result, double meters_per_unit) {
  std::vector<Placement> placements;
  const Json errors = result.value("errors", Json::object());
  const Json& final_objects = result.at("final").at("objects");
  for (const auto& [id, goal] : result.at("goal").at("objects").items()) {
    // The goal names objects of the demonstration; the imitation may have used others for them.
    Placement placement{.object = result.at("match").value(id, id)};
    placement.X_WWanted = PoseIn(goal, meters_per_unit);
    if (final_objects.contains(placement.object)) {
      placement.X_WReached = PoseIn(final_objects.at(placement.object), meters_per_unit);
      placement.error_mm =
          1000 * (placement.X_WReached->translation() - placement.X_WWanted.translation()).norm();
    }
    if (errors.contains(id)) placement.error_degrees = errors.at(id).at("degrees").get<double>();
    placements.push_back(std::move(placement));
  }
  return placements;
}

Markup ErrorBars(const std::vector<Placement>& placements, double tolerance_mm) {
  constexpr double kRow = 22, kLabels = 100, kValues = 46, kBar = 12;
  // The axis includes the tolerance even if all errors are smaller.
  double most = tolerance_mm;
  for (const Placement& placement : placements) {
    most = std::max(most, placement.error_mm.value_or(0));
  }
  const Axis axis(0, most, kLabels, kPlotWidth - kValues);
  const double bottom = kRow * static_cast<double>(placements.size()) + 6;
  Markup drawing = axis.Draw(0, bottom, "distance from the wanted position [mm]");
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const Placement& placement = placements[i];
    const double y = kRow * static_cast<double>(i) + 5;
    drawing += SvgText(kLabels - 6, y + 10, "value end", placement.object.substr(0, 16));
    const double end = axis.x(placement.error_mm.value_or(0));
    drawing += SvgRect(kLabels, y, std::max(1.0, end - kLabels), kBar,
                       placement.IsWithin(tolerance_mm) ? "yes" : "no");
    drawing += SvgText(end + 4, y + 10, "value",
                       placement.error_mm ? Fixed(placement.error_mm, 1) : "missing");
  }
  const double limit = axis.x(tolerance_mm);
  drawing += SvgLine(limit, 0, limit, bottom, "limit");
  return Drawing(kPlotWidth, bottom + 32, "Error of each object of the structure", drawing);
}

Markup DrawPlacements(const scene::SceneSpec& scene, const Json& result,
                      const std::vector<Placement>& placements, ViewDirection direction) {
  std::map<std::string, const scene::Part*> parts;
  std::vector<Patch> reached, wanted;
  for (const scene::ObjectSpec& object : scene.objects) {
    parts[object.id()] = &object.whole;
    const Json& objects = result.at("final").at("objects");
    if (!objects.contains(object.id())) continue;
    const RigidTransform X_WB = PoseIn(objects.at(object.id()), scene.meters_per_unit);
    for (Patch& patch : PatchesOf(object.whole, X_WB, direction))
      reached.push_back(std::move(patch));
  }
  for (const Placement& placement : placements) {
    if (!parts.contains(placement.object)) continue;
    for (Patch& patch : PatchesOf(*parts.at(placement.object), placement.X_WWanted, direction)) {
      wanted.push_back(std::move(patch));
    }
  }
  Eigen::AlignedBox2d bounds;
  for (const auto* patches : {&reached, &wanted}) {
    for (const Patch& patch : *patches) {
      for (const Point& point : patch.outline) bounds.extend(point);
    }
  }
  // Of wanted and reached poses together, so that neither is cut off.
  const Frame frame(bounds);
  // Painter's algorithm: nearer pieces are drawn over farther ones.
  std::ranges::stable_sort(reached, {}, &Patch::nearness);
  Markup drawing;
  if (direction == ViewDirection::kFront) {
    drawing += SvgLine(0, frame.y(0), kPlotWidth, frame.y(0), "axis");
  }
  for (const Patch& patch : reached) {
    drawing += Element("polygon",
                       {{"class", "reached"},
                        {"points", PointsText(patch.outline, frame)},
                        {"fill", RgbText(patch.color)}},
                       Markup());
  }
  for (const Patch& patch : wanted) {
    drawing += Element(
        "polygon", {{"class", "wanted"}, {"points", PointsText(patch.outline, frame)}}, Markup());
  }
  drawing += Ruler(frame);
  return Drawing(
      kPlotWidth, frame.height() + 24,
      direction == ViewDirection::kTop ? "The table from above" : "The table from the front",
      drawing);
}

}  // namespace smile::report

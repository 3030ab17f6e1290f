#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "base/overloaded.h"
#include "scene/internal_lights.h"
#include "scene/solid.h"
#include "scene/visual_model.h"

namespace smile::scene {
namespace {

/// Collects the visible pieces. Most are the collision shapes; meshes and lights differ from these.
class VisualCollector {
 public:
  void Append(const Part& part, Visual place) {
    // Parts without an id belong to the innermost part that has one.
    if (!part.id.empty()) place.part_id = part.id;
    std::visit(
        Overloaded{[&](const Composite& composite) { AppendAll(composite.parts, place); },
                   // Drawn as its exact surface, while collisions use convex pieces.
                   [&](const Custom& custom) {
                     place.shape = DrawnMesh{custom.mesh, custom.scale};
                     place.color = part.color;
                     visuals_.push_back(place);
                   },
                   // Lights and the parts of a custom control are visible only in their
                   // state.
                   [&](const IndicatorLights& lights) {
                     place.choice = num_controls_++;
                     for (std::size_t variant = 0; variant < lights.states.size(); ++variant) {
                       place.variant = static_cast<int>(variant);
                       AppendLights(lights, lights.states[variant], place);
                     }
                   },
                   [&](const CustomControl& control) {
                     place.choice = num_controls_++;
                     for (std::size_t variant = 0; variant < control.states.size(); ++variant) {
                       place.variant = static_cast<int>(variant);
                       AppendAll(control.states[variant].parts, place);
                     }
                   },
                   [&](const ToggleSwitch&) {
                     const int number = num_controls_++;
                     AppendAsFelt(part, place, number);
                   },
                   [&](const auto&) { AppendAsFelt(part, place, place.choice); }},
        part.shape);
  }

  std::vector<Visual> Take() { return std::move(visuals_); }

 private:
  void AppendAll(const std::vector<Part>& parts, const Visual& place) {
    for (const Part& child : parts) {
      // Children inherit choice, variant and part from the element around them.
      Visual there = place;
      there.X_FV = place.X_FV * child.X_PE;
      Append(child, there);
    }
  }

  /// Appends the part's own solids; a switch has a variant for each of its positions.
  void AppendAsFelt(const Part& part, const Visual& place, int choice) {
    for (const Solid& solid : SolidsOf(part)) {
      Visual visual = place;
      visual.shape = VisualShapeOf(solid.shape);
      visual.color = solid.color;
      visual.X_FV = place.X_FV * solid.X_BS;
      visual.choice = choice;
      if (solid.control >= 0) visual.variant = solid.variant;
      // The button's id is made of that of the switch.
      if (!part.id.empty()) visual.button = solid.button;
      visuals_.push_back(visual);
    }
  }

  void AppendLights(const IndicatorLights& lights, const IndicatorLights::State& state,
                    const Visual& place) {
    for (const Light& light : state.lights) {
      Visual visual = place;
      visual.shape = DiscOf(lights);
      visual.color = light.color;
      visual.glows = true;
      visual.X_FV = place.X_FV * PoseOfLight(lights, light.number);
      visuals_.push_back(visual);
    }
  }

  std::vector<Visual> visuals_;
  int num_controls_ = 0;
};

/// Height of the painted pattern above a table [m]: high enough that no camera confuses it with the
/// table beneath, low enough that no depth shows it.
constexpr double kPaint = 0.0002;
/// Limit of stripes or squares along a side of the table; narrower ones are drawn wider.
constexpr double kMaxTiles = 64;

/// Interval of a tile along one axis [m].
struct Tile {
  double middle = 0, span = 0;
};

/// Divides a side of the table into tiles, from its low end on; the last one may be narrower.
std::vector<Tile> TilesAlong(double side, double span) {
  span = std::max(span, side / kMaxTiles);
  std::vector<Tile> tiles;
  // The tolerance absorbs rounding: no sliver remains at the end.
  for (double low = 0; low < side - 1e-6 * span; low += span) {
    const double high = std::min(low + span, side);
    tiles.push_back({.middle = (low + high) / 2 - side / 2, .span = high - low});
  }
  return tiles;
}

/// Appends the upper side of a tile: it has no rim, which would show in pixels beside it.
void AppendTile(const Tile& column, const Tile& row, SurfaceMesh* surface) {
  const auto first = static_cast<std::uint32_t>(surface->vertices.size());
  for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const Vector3 corner(column.middle + x * column.span, row.middle + y * row.span, kPaint);
    surface->vertices.push_back(corner.cast<float>());
  }
  surface->triangles.push_back({first, first + 1, first + 2});
  surface->triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

VisualShape VisualShapeOf(const SolidShape& shape) {
  return std::visit([](const auto& solid) { return VisualShape(solid); }, shape);
}

std::vector<Visual> VisualsOf(const Part& whole) {
  VisualCollector collector;
  collector.Append(whole, {});
  return collector.Take();
}

std::vector<Visual> VisualsOf(const TableSpec& table) {
  const Solid solid = TableSolid(table);
  std::vector<Visual> visuals{
      {.shape = VisualShapeOf(solid.shape), .color = solid.color, .X_FV = solid.X_BS}};
  if (table.pattern == TablePattern::kPlain) return visuals;
  const std::vector<Tile> columns = TilesAlong(table.x_span, table.pattern_span);
  // A stripe is a column that is as long as the table.
  const std::vector<Tile> rows = table.pattern == TablePattern::kStripes
                                     ? std::vector<Tile>{{.span = table.y_span}}
                                     : TilesAlong(table.y_span, table.pattern_span);
  const auto painted = std::make_shared<CustomMesh>();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    // Only every second tile is painted: there are no seams through which one could look.
    for (std::size_t j = (i + 1) % 2; j < rows.size(); j += 2) {
      AppendTile(columns[i], rows[j], &painted->surface);
    }
  }
  if (painted->surface.triangles.empty()) return visuals;
  visuals.push_back(
      {.shape = DrawnMesh{.mesh = painted}, .color = table.pattern_color, .casts_shadow = false});
  return visuals;
}

}  // namespace smile::scene

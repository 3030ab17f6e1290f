#include "layout/reach_map.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace smile::layout {

int ReachMap::num_columns() const { return static_cast<int>(std::lround(2 * most_x / cell)); }

int ReachMap::num_rows() const { return static_cast<int>(std::lround(most_depth / cell)); }

Vector2 ReachMap::MiddleOf(int column, int row) const {
  return {(column + 0.5) * cell - most_x, (row + 0.5) * cell};
}

bool ReachMap::Contains(const Vector2& point, double margin) const {
  const auto is_at = [this](const Vector2& p) {
    const int column = static_cast<int>(std::floor((p.x() + most_x) / cell));
    const int row = static_cast<int>(std::floor(p.y() / cell));
    if (column < 0 || column >= num_columns() || row < 0 || row >= num_rows()) return false;
    return static_cast<bool>(
        is_reached[static_cast<std::size_t>(row) * static_cast<std::size_t>(num_columns()) +
                   static_cast<std::size_t>(column)]);
  };
  if (!is_at(point)) return false;
  // Points of the circle closer together than cells.
  const int num_points = static_cast<int>(std::ceil(2 * std::numbers::pi * margin / cell));
  for (int i = 0; i < num_points; ++i) {
    const double angle = 2 * std::numbers::pi * i / num_points;
    if (!is_at(point + margin * Vector2(std::cos(angle), std::sin(angle)))) return false;
  }
  return true;
}

}  // namespace smile::layout

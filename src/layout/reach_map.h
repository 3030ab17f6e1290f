#pragma once

#include <vector>

#include "layout/footprint.h"

namespace smile::layout {

/// Places of a table that a robot reaches, on a grid of square cells. Depths count from the table's
/// near edge, sideways distances from its middle, as in LayoutRegion.
struct ReachMap {
  double cell = 0.04;            ///< edge of a cell [m]
  double most_x = 1.0;           ///< the map extends so far to either side [m]
  double most_depth = 1.0;       ///< and from depth 0 to this [m]
  std::vector<bool> is_reached;  ///< row by row, from depth 0 and the least x; num_cells()

  int num_columns() const;
  int num_rows() const;
  /// Returns the middle of a cell.
  Vector2 MiddleOf(int column, int row) const;
  /// Returns true if the robot reaches a point and a circle about it [m].
  bool Contains(const Vector2& point, double margin = 0) const;

  bool operator==(const ReachMap&) const = default;
};

}  // namespace smile::layout

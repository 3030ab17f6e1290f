#include "mesh/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/internal_lattice_hull.h"
#include "mesh/internal_lattice_solid.h"

namespace smile::mesh {
namespace {

// Shares of a hull that may be filled where the solid is not.
constexpr double kConvexExcess = 0.01;   // of the whole: then it counts as convex
constexpr double kPieceExcess = 0.04;    // of a piece
constexpr double kLeastExcess = 0.0005;  // of the whole: smaller ones are not worth a cut

constexpr double kExactTolerance = 3;  // [steps], what rounding may do
constexpr double kTolerance = 0.001 * static_cast<double>(kLatticeSteps);
constexpr std::int64_t kThinnest = kLatticeSteps / 200;  // [steps] between two cuts
constexpr int kCutsPerAxis = 8, kRoughCorners = 48;
constexpr std::size_t kMaxTrianglesToCut = 20'000;
constexpr std::size_t kMaxWork = 60'000'000;  // triangles looked at: seconds

using Points = std::vector<LatticePoint>;

/// A box of the lattice and the solid within.
struct Cell {
  LatticeBox box;
  LatticeSolid::Numbers touching, above;
  LatticeHull hull;
  double volume = 0;  // of the solid

  double excess() const { return hull.volume - volume; }
};

class Decomposition {
 public:
  Decomposition(LatticeSolid solid, const PieceLimits& limits)
      : solid_(std::move(solid)), limits_(limits) {}

  /// @param whole  the hull of the solid.
  std::vector<LatticeHull> Run(LatticeHull whole) {
    least_excess_ = kLeastExcess * whole.volume;
    cells_.push_back(
        {solid_.bounds(), solid_.All(), solid_.All(), std::move(whole), solid_.volume()});
    while (cells_.size() < limits_.max_pieces && solid_.work() < kMaxWork) {
      const auto worst = Worst();
      if (!worst) break;
      Split(*worst);
    }
    Join();
    std::vector<LatticeHull> pieces;
    for (Cell& cell : cells_) pieces.push_back(std::move(cell.hull));
    return pieces;
  }

 private:
  struct Plane {
    int axis;
    std::int64_t place;
  };

  bool IsWorthACut(const Cell& cell) const {
    return cell.excess() > std::max(kPieceExcess * cell.hull.volume, least_excess_) &&
           (cell.box.high - cell.box.low).maxCoeff() > 2 * kThinnest;
  }

  std::optional<std::size_t> Worst() const {
    std::optional<std::size_t> worst;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!IsWorthACut(cells_[i])) continue;
      if (!worst || cells_[i].excess() > cells_[*worst].excess()) worst = i;
    }
    return worst;
  }

  void Split(std::size_t number) {
    const Cell cell = std::move(cells_[number]);
    cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(number));
    const Plane plane = BestPlane(cell);
    for (const bool is_high : {false, true}) {
      LatticeBox box = cell.box;
      (is_high ? box.low : box.high)[plane.axis] = plane.place;
      if (std::optional<Cell> half = MakeCell(box, cell)) cells_.push_back(*std::move(half));
    }
  }

  std::optional<Cell> MakeCell(LatticeBox box, const Cell& parent) const {
    LatticeSolid::Numbers touching = solid_.Touching(box, parent.touching);
    LatticeSolid::Numbers above = solid_.Above(box, parent.above);
    Points points;
    solid_.AppendSurface(box, touching, &points);
    for (int corner = 0; corner < 8; ++corner) {
      if (solid_.Fills(box, corner, above)) points.push_back(CornerOf(box, corner));
    }
    std::optional<LatticeHull> hull = HullOf(std::move(points), limits_.max_corners, kTolerance);
    if (!hull) return std::nullopt;
    const double volume = solid_.VolumeWithin(box, above);
    return Cell{box, std::move(touching), std::move(above), *std::move(hull), volume};
  }

  /// Places to cut at: in each of some equal parts the place with the most vertices, since there
  /// the solid's own faces are.
  std::vector<std::int64_t> PlacesToCut(const Cell& cell, int axis) const {
    const std::int64_t low = cell.box.low[axis], high = cell.box.high[axis];
    if (high - low < 2 * kThinnest) return {};
    std::vector<std::int64_t> vertices;
    for (const std::uint32_t i : cell.touching) {
      for (const LatticePoint& corner : solid_.triangles()[i]) {
        if (corner[axis] > low && corner[axis] < high) vertices.push_back(corner[axis]);
      }
    }
    std::sort(vertices.begin(), vertices.end());
    // The middle is the first of them, so that it wins where all are as good.
    std::vector<std::int64_t> places;
    auto vertex = vertices.begin();
    for (int part = 0; part < kCutsPerAxis; ++part) {
      const std::int64_t begin = low + (high - low) * part / kCutsPerAxis;
      const std::int64_t end = low + (high - low) * (part + 1) / kCutsPerAxis;
      std::int64_t best = (begin + end) / 2;
      std::ptrdiff_t most = 0;
      while (vertex != vertices.end() && *vertex < end) {
        const auto next = std::upper_bound(vertex, vertices.end(), *vertex);
        if (next - vertex > most) {
          most = next - vertex;
          best = *vertex;
        }
        vertex = next;
      }
      const std::int64_t before = places.empty() ? low : places.back();
      if (best - before >= kThinnest && high - best >= kThinnest) places.push_back(best);
    }
    return places;
  }

  /// The plane whose two sides have the smallest hulls together; of those that are alike, the one
  /// that cuts most evenly.
  Plane BestPlane(const Cell& cell) const {
    constexpr double kEvenness = 0.03;
    Plane best{.axis = 0, .place = 0};
    (cell.box.high - cell.box.low).maxCoeff(&best.axis);
    best.place = (cell.box.low[best.axis] + cell.box.high[best.axis]) / 2;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<std::int64_t> places = PlacesToCut(cell, axis);
      const auto volumes = HullVolumes(cell, axis, places);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto [low, high] = volumes[i];
        const double cost = low + high + kEvenness * std::abs(low - high);
        if (cost >= least) continue;
        least = cost;
        best = {.axis = axis, .place = places[i]};
      }
    }
    return best;
  }

  /// Of what lies on the two sides of each place, nearly: slab by slab, each added to those before.
  std::vector<std::pair<double, double>> HullVolumes(
      const Cell& cell, int axis, const std::vector<std::int64_t>& places) const {
    // What the corners of the slabs are tested with: along each edge of the cell the same few.
    std::array<LatticeSolid::Numbers, 8> near;
    for (int corner = 0; corner < 8 && !places.empty(); ++corner) {
      if (corner >> axis & 1) continue;
      LatticeBox edge = LatticeSolid::SmallBoxAt(corner, cell.box);
      edge.low[axis] = cell.box.low[axis];
      edge.high[axis] = cell.box.high[axis];
      near[corner] = near[corner | 1 << axis] = solid_.Above(edge, cell.above);
    }
    std::vector<Points> slabs;
    for (std::size_t i = 0; i <= places.size(); ++i) {
      LatticeBox box = cell.box;
      if (i > 0) box.low[axis] = places[i - 1];
      if (i < places.size()) box.high[axis] = places[i];
      slabs.push_back(SpanOf(box, cell.touching, near));
    }
    std::vector<std::pair<double, double>> volumes(places.size());
    Points low, high;
    for (std::size_t i = 0; i < places.size(); ++i) {
      volumes[i].first = Add(slabs[i], &low);
      const std::size_t j = places.size() - 1 - i;
      volumes[j].second = Add(slabs[j + 1], &high);
    }
    return volumes;
  }

  /// The corners of the hull of the solid within a box.
  Points SpanOf(const LatticeBox& box, const LatticeSolid::Numbers& touching,
                const std::array<LatticeSolid::Numbers, 8>& near) const {
    Points points;
    solid_.AppendSurface(box, solid_.Touching(box, touching), &points);
    for (int corner = 0; corner < 8; ++corner) {
      if (solid_.Fills(box, corner, near[corner])) points.push_back(CornerOf(box, corner));
    }
    if (auto hull = HullOf(points, kRoughCorners, kTolerance)) return std::move(hull->corners);
    return points;
  }

  /// @returns the volume of the hull of both.
  static double Add(const Points& more, Points* points) {
    points->insert(points->end(), more.begin(), more.end());
    auto hull = HullOf(*points, kRoughCorners, kTolerance);
    if (!hull) return 0;
    *points = std::move(hull->corners);
    return hull->volume;
  }

  /// Cuts go all the way through a cell, so there are pieces that were better left whole.
  void Join() {
    while (cells_.size() > 1) {
      std::optional<std::pair<std::size_t, std::size_t>> best;
      // Not more than the pieces fill too much already, and a little.
      double least = 0.01;
      LatticeHull joined;
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        for (std::size_t j = i + 1; j < cells_.size(); ++j) {
          if (!DoTouch(cells_[i].box, cells_[j].box)) continue;
          auto hull = HullOfBoth(cells_[i].hull, cells_[j].hull);
          if (!hull) continue;
          const double filled = cells_[i].hull.volume + cells_[j].hull.volume;
          const double excess = (hull->volume - filled) / hull->volume;
          if (excess >= least) continue;
          least = excess;
          best = {i, j};
          joined = *std::move(hull);
        }
      }
      if (!best) return;
      Cell& kept = cells_[best->first];
      const Cell& gone = cells_[best->second];
      kept.hull = std::move(joined);
      kept.volume += gone.volume;
      kept.box = {kept.box.low.cwiseMin(gone.box.low), kept.box.high.cwiseMax(gone.box.high)};
      cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(best->second));
    }
  }

  static bool DoTouch(const LatticeBox& a, const LatticeBox& b) {
    return ((a.low - b.high).array() <= 0).all() && ((b.low - a.high).array() <= 0).all();
  }

  std::optional<LatticeHull> HullOfBoth(const LatticeHull& a, const LatticeHull& b) const {
    Points points = a.corners;
    points.insert(points.end(), b.corners.begin(), b.corners.end());
    return HullOf(std::move(points), limits_.max_corners, kTolerance);
  }

  LatticeSolid solid_;
  PieceLimits limits_;
  double least_excess_ = 0;
  std::vector<Cell> cells_;
};

/// With its faces, in the mesh's units, without corners that are in the middle of faces.
scene::Hull Finish(const LatticeHull& hull, const LatticeSolid& solid) {
  scene::Polyhedron polyhedron{.faces = FacesOf(hull)};
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(hull.corners.size(), kUnused);
  for (scene::Polyhedron::Face& face : polyhedron.faces) {
    for (std::uint32_t& corner : face) {
      std::uint32_t& number = numbers[corner];
      if (number == kUnused) {
        number = static_cast<std::uint32_t>(polyhedron.corners.size());
        polyhedron.corners.push_back(solid.PlaceOf(hull.corners[corner]));
      }
      corner = number;
    }
  }
  return scene::Hull(std::move(polyhedron));
}

Points VerticesOf(const LatticeSolid& solid) {
  Points points;
  for (const LatticeSolid::Triangle& triangle : solid.triangles()) {
    points.insert(points.end(), triangle.begin(), triangle.end());
  }
  return points;
}

}  // namespace

std::vector<scene::Hull> ConvexPieces(const scene::SurfaceMesh& mesh, const PieceLimits& limits) {
  if (mesh.triangles.size() > limits.max_triangles) {
    throw std::invalid_argument("found " + std::to_string(mesh.triangles.size()) +
                                " triangles, expected at most " +
                                std::to_string(limits.max_triangles) + " to make convex pieces of");
  }
  const LatticeSolid solid(mesh);
  std::optional<LatticeHull> whole = HullOf(VerticesOf(solid), limits.max_corners, kExactTolerance);
  if (!whole) {
    throw std::invalid_argument("found all triangles in a plane, expected a body with a volume");
  }
  constexpr double kNothing = 1e-4;
  const bool has_inside = solid.is_closed() && solid.volume() > kNothing * whole->volume;
  std::vector<LatticeHull> pieces;
  if (!has_inside || whole->volume - solid.volume() <= kConvexExcess * whole->volume) {
    pieces.push_back(*std::move(whole));
  } else {
    pieces = Decomposition(solid.Simplified(kMaxTrianglesToCut), limits).Run(*std::move(whole));
  }
  std::vector<scene::Hull> hulls;
  for (const LatticeHull& piece : pieces) hulls.push_back(Finish(piece, solid));
  return hulls;
}

}  // namespace smile::mesh

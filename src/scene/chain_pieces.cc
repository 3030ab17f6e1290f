#include <string>

#include "base/wording.h"
#include "scene/mechanism.h"
#include "scene/scene_spec.h"
#include "scene/units.h"

// The pieces of a chain as ordinary objects: two static ends and the links between them. They are
// derived from the chain whenever a scene is read, so a scene file contains only the chain.

namespace smile::scene {
namespace {

/// Returns the rotation of the pieces: y from start to end, x horizontal, z as far up as possible.
/// `along` must not be zero.
Matrix3 Orientation(const Vector3& along) {
  const Vector3 y = along.normalized();
  Vector3 x = y.cross(Vector3::UnitZ());
  // A vertical chain has no preferred x: takes the world's, made perpendicular to y.
  if (x.norm() < 1e-9) x = Vector3::UnitX() - y * y.x();
  x.normalize();
  Matrix3 R;
  R << x, y, x.cross(y);
  return R;
}

void Describe(const std::string& shape, const Vector3& size_units, ObjectSpec* piece) {
  piece->descriptions = {{"shape", shape},
                         {"xspan", NumberText(size_units.x())},
                         {"yspan", NumberText(size_units.y())},
                         {"zspan", NumberText(size_units.z())}};
}

}  // namespace

std::vector<ObjectSpec> PiecesOf(const ChainSpec& chain, double meters_per_unit) {
  constexpr double kEndUnits = 0.1;
  const Vector3 along = chain.p_WEnd - chain.p_WStart;
  const Matrix3 R_WPiece = Orientation(along);
  std::vector<ObjectSpec> pieces;

  const auto add_end = [&](const std::string& id, const Vector3& p_WPiece) {
    ObjectSpec end;
    end.whole = {.id = id,
                 .X_PE = {R_WPiece, p_WPiece},
                 .color = {1, 1, 1},
                 .shape = Block{FromFileUnits(Vector3::Constant(kEndUnits), meters_per_unit)}};
    // The ends cannot move: they hang the chain up.
    end.mass = 0;
    Describe("chain-endpoint", Vector3::Constant(kEndUnits), &end);
    pieces.push_back(end);
  };
  add_end(chain.start_id, chain.p_WStart);
  add_end(chain.end_id, chain.p_WEnd);

  const auto num_links = static_cast<double>(chain.link_ids.size());
  for (std::size_t i = 0; i < chain.link_ids.size(); ++i) {
    // The centers divide the line evenly, whatever the length of a link.
    const double share = (static_cast<double>(i) + 0.5) / num_links;
    ObjectSpec link;
    link.whole = {.id = chain.link_ids[i],
                  .X_PE = {R_WPiece, chain.p_WStart + along * share},
                  .color = chain.color,
                  .shape = Block{chain.link_size}};
    link.mass = chain.link_mass;
    Describe("chain-link", ToFileUnits(chain.link_size, meters_per_unit), &link);
    link.descriptions.push_back({"color", ToString(chain.color)});
    pieces.push_back(link);
  }
  return pieces;
}

}  // namespace smile::scene

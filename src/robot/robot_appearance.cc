#include "robot/robot_appearance.h"

#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/files.h"
#include "base/wording.h"
#include "mesh/import_pieces.h"

// Shipped appearances: meshes that are nicer than those of the description and replace none of its
// collision shapes. A glTF file has one node per link; `mood` in a node's extras makes it visible
// with one face expression only.

namespace smile::robot {
namespace {

/// Piece of a link in one color.
struct AppearancePiece {
  std::string link;
  Color color;
  std::shared_ptr<const scene::CustomMesh> mesh;
  std::optional<FaceExpression> face_expression;  ///< visible only with this face expression
};
using Appearance = std::vector<AppearancePiece>;

/// Returns the face expression in a node's extras, if any.
std::optional<FaceExpression> FaceExpressionOf(const mesh::MeshPiece& piece) {
  const auto it = piece.extras.find("mood");
  if (it == piece.extras.end()) return std::nullopt;
  const auto face_expression = ParseFaceExpression(it->get<std::string>());
  if (!face_expression)
    throw std::runtime_error("an appearance has the unknown face expression " + Quoted(it->dump()));
  return face_expression;
}

Appearance LoadAppearance(const std::string& name) {
  Appearance appearance;
  for (mesh::MeshPiece& piece :
       mesh::ImportPieces(DataFile("robots/appearance/" + name + ".glb"))) {
    appearance.push_back({piece.node, piece.color, std::move(piece.mesh), FaceExpressionOf(piece)});
  }
  return appearance;
}

/// Returns an appearance, loaded on first use.
const Appearance& AppearanceNamed(std::string_view name) {
  // Initialization of a static is thread-safe, and its contents never change afterwards.
  static const std::map<std::string, Appearance, std::less<>> kAppearances = {
      {"baxter", LoadAppearance("baxter")}, {"classic", LoadAppearance("classic")}};
  return kAppearances.at(std::string(name));
}

}  // namespace

void AddAppearance(std::string_view name, const std::string& prefix, RobotModel* model) {
  for (const AppearancePiece& piece : AppearanceNamed(name)) {
    const auto frame = FindFrame(*model, prefix + piece.link);
    if (!frame) {
      throw std::invalid_argument("the robot has no link " + Quoted(prefix + piece.link));
    }
    const Frame& at = model->frames[*frame];
    model->visuals.push_back({.link = at.link,
                              .shape = scene::DrawnMesh{piece.mesh},
                              .color = piece.color,
                              .X_LV = at.X_LF,
                              .face_expression = piece.face_expression});
  }
}

}  // namespace smile::robot

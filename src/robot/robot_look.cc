#include "robot/robot_look.h"

#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/files.h"
#include "base/wording.h"
#include "mesh/import_pieces.h"

namespace smile::robot {
namespace {

/// Piece of a link in one color.
struct LookPiece {
  std::string link;
  Color color;
  std::shared_ptr<const scene::CustomMesh> mesh;
  std::optional<FaceExpression> face_expression;  ///< visible only with this face expression
};
using Look = std::vector<LookPiece>;

/// Returns the face expression in a node's extras, if any.
std::optional<FaceExpression> FaceExpressionOf(const mesh::MeshPiece& piece) {
  const auto it = piece.extras.find("mood");
  if (it == piece.extras.end()) return std::nullopt;
  const auto face_expression = ParseFaceExpression(it->get<std::string>());
  if (!face_expression)
    throw std::runtime_error("a look shows the unknown mood " + Quoted(it->dump()));
  return face_expression;
}

Look LoadLook(const std::string& name) {
  Look look;
  for (mesh::MeshPiece& piece : mesh::ImportPieces(DataFile("robots/looks/" + name + ".glb"))) {
    look.push_back({piece.node, piece.color, std::move(piece.mesh), FaceExpressionOf(piece)});
  }
  return look;
}

/// Returns a look, loaded on first use.
const Look& LookNamed(std::string_view name) {
  static const std::map<std::string, Look, std::less<>> kLooks = {{"baxter", LoadLook("baxter")},
                                                                  {"classic", LoadLook("classic")}};
  return kLooks.at(std::string(name));
}

}  // namespace

void AddLook(std::string_view name, const std::string& prefix, RobotModel* model) {
  for (const LookPiece& piece : LookNamed(name)) {
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

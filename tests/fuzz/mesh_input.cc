#include "mesh_input.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "base/diagnostic.h"
#include "mesh/convex_pieces.h"
#include "mesh/import_mesh.h"

namespace smile::fuzz {
namespace {

constexpr std::array<std::string_view, 5> kExtensions{"stl", "obj", "dae", "gltf", "glb"};
constexpr mesh::MeshLimits kLimits{
    .max_file_bytes = 1u << 17, .max_triangles = 2000, .max_vertices = 2000};
// Pieces of more would take the time of a thousand other inputs.
constexpr std::size_t kMaxFeltTriangles = 40;
constexpr mesh::PieceLimits kPieceLimits{
    .max_triangles = kMaxFeltTriangles, .max_pieces = 4, .max_corners = 16};

std::string_view ExtensionOf(std::string_view bytes) {
  return kExtensions[static_cast<unsigned char>(bytes.front() - '0') % kExtensions.size()];
}

/// What a glTF file finds beside it: corners, numbers of corners, whatever it takes them for.
std::string Neighbour(const std::string&, std::size_t max_bytes) {
  constexpr std::array<float, 9> kCorners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string bytes(reinterpret_cast<const char*>(kCorners.data()), sizeof kCorners);
  bytes.resize(std::min(bytes.size(), max_bytes));
  return bytes;
}

std::string ShapeFaultOf(const scene::SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return "a mesh without a triangle";
  if (mesh.triangles.size() > kLimits.max_triangles || mesh.vertices.size() > kLimits.max_vertices)
    return "a mesh above the limits";
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "a vertex that is no place";
  }
  for (const scene::SurfaceMesh::Triangle& triangle : mesh.triangles) {
    for (std::uint32_t corner : triangle) {
      if (corner >= mesh.vertices.size()) return "a triangle with a corner that does not exist";
    }
  }
  return {};
}

std::string RoundTripFaultOf(const scene::SurfaceMesh& mesh) {
  // With the usual limits: an STL file is larger than others of the same mesh.
  try {
    if (mesh::ParseMesh(mesh::StlOf(mesh), "stl") != mesh)
      return "a written mesh reads differently";
  } catch (const InputError& error) {
    return "a written mesh is refused: " + std::string(error.what());
  }
  return {};
}

std::string PiecesFaultOf(const scene::SurfaceMesh& mesh) {
  if (mesh.triangles.size() > kMaxFeltTriangles) return {};
  std::vector<scene::Hull> pieces;
  try {
    pieces = mesh::ConvexPieces(mesh, kPieceLimits);
  } catch (const std::invalid_argument&) {
    return {};  // it is flat
  }
  if (pieces.empty() || pieces.size() > kPieceLimits.max_pieces) {
    return std::to_string(pieces.size()) + " pieces";
  }
  for (const scene::Hull& piece : pieces) {
    if (piece.polyhedron().corners.size() < 4) return "a piece of fewer than four corners";
  }
  return {};
}

}  // namespace

scene::SurfaceMesh ImportHostileMesh(std::string_view bytes) {
  if (bytes.empty()) throw InputError({"fuzzed", 0, "", "found nothing, expected a format"});
  return mesh::ParseMesh(bytes.substr(1), ExtensionOf(bytes), kLimits, "fuzzed", Neighbour);
}

std::string FaultWithMesh(std::string_view bytes) {
  scene::SurfaceMesh mesh;
  try {
    mesh = ImportHostileMesh(bytes);
  } catch (const InputError& error) {
    const auto& found = error.diagnostics();
    const bool has_reason = !found.empty() && found.front().file == "fuzzed";
    return has_reason && !found.front().message.empty() ? "" : "refused without a reason";
  }
  if (std::string fault = ShapeFaultOf(mesh); !fault.empty()) return fault;
  if (std::string fault = RoundTripFaultOf(mesh); !fault.empty()) return fault;
  return PiecesFaultOf(mesh);
}

}  // namespace smile::fuzz

#include "interchange/mesh_files.h"

#include <array>

#include "base/bytes.h"

namespace smile::interchange {
namespace {

void PutVector(const Vector3& v, ByteWriter* bytes) {
  for (const double coordinate : v) bytes->Put(static_cast<float>(coordinate));
}

}  // namespace

std::string ToStl(const NamedMesh& mesh) {
  ByteWriter bytes(84 + 50 * mesh.triangles.size());
  // Readers take a file that begins with `solid` for the format's text form.
  std::array<char, 80> title{'m', 'e', 's', 'h'};
  bytes.PutBytes(std::as_bytes(std::span(title)));
  bytes.Put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 &p = mesh.corners[a], &q = mesh.corners[b], &r = mesh.corners[c];
    // A triangle without area has no direction: it gets a normal of 0, as the format allows.
    PutVector((q - p).cross(r - p).normalized(), &bytes);
    for (const Vector3* corner : {&p, &q, &r}) PutVector(*corner, &bytes);
    bytes.Put(std::uint16_t{0});
  }
  const auto all = bytes.bytes();
  return {reinterpret_cast<const char*>(all.data()), all.size()};
}

std::string MeshFileName(const std::string& folder, const std::string& mesh) {
  return folder + "/" + mesh + ".stl";
}

std::vector<std::pair<std::string, std::string>> MeshFilesOf(const MeshTable& meshes,
                                                             const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const NamedMesh& mesh : meshes.meshes()) {
    files.emplace_back(MeshFileName(folder, mesh.name), ToStl(mesh));
  }
  return files;
}

}  // namespace smile::interchange

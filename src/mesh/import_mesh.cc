// Entry to all mesh formats. A file comes from anywhere, so each reader reports faults as BadMesh,
// without the file's name; only this file knows where the bytes are from and turns them into an
// InputError. The readers open nothing themselves.

#include "mesh/import_mesh.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "mesh/internal_mesh_formats.h"
#include "mesh/internal_words.h"

namespace smile::mesh {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kExtensions{"stl", "obj", "dae", "gltf", "glb"};

/// Chooses the reader by extension.
void ReadInto(std::string_view bytes, std::string_view extension, const OpenNeighbour& open,
              const MeshLimits& limits, TriangleSoup* soup) {
  const auto is = [&](std::string_view known) { return IsSameWord(extension, known); };
  if (is("stl")) return ReadStl(bytes, soup);
  if (is("obj")) return ReadObj(bytes, soup);
  if (is("dae")) return ReadCollada(bytes, soup);
  if (is("gltf") || is("glb")) return ReadGltf(bytes, open, limits.max_file_bytes, soup);
  throw BadMesh("found the extension " + Quoted(extension) + ", expected " + OneOf(kExtensions));
}

/// Returns true for a file name without folders.
bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= 255 && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
}

/// Reads a file from the folder of a mesh file. Links are followed first, so that they cannot lead
/// out of it.
std::string ReadNeighbour(const fs::path& mesh_file, const std::string& name,
                          std::size_t max_bytes) {
  // A glTF names its buffers. Only plain names are accepted, and the canonical folder of the result
  // must be that of the mesh: neither `..` nor a link leads elsewhere.
  std::error_code error;
  const fs::path folder = fs::canonical(mesh_file, error).parent_path();
  const fs::path file =
      error || !IsPlainName(name) ? fs::path() : fs::canonical(folder / name, error);
  if (error || file.empty() || file.parent_path() != folder) {
    throw BadMesh("found the uri " + Quoted(name) +
                  ", expected the name of a file beside the mesh");
  }
  return ReadFile(file, max_bytes);
}

std::string ExtensionOf(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension.empty() ? extension : extension.substr(1);
}

bool IsKnown(std::string_view extension) {
  return std::ranges::any_of(kExtensions,
                             [&](std::string_view known) { return IsSameWord(known, extension); });
}

}  // namespace

scene::SurfaceMesh ParseMesh(std::string_view bytes, std::string_view extension,
                             const MeshLimits& limits, const std::string& name,
                             const OpenNeighbour& open, MeshAxes axes) {
  try {
    if (bytes.size() > limits.max_file_bytes) {
      throw BadMesh("is larger than " + std::to_string(limits.max_file_bytes) + " bytes");
    }
    // The soup enforces the limits while triangles arrive, so a small file cannot fill the memory.
    TriangleSoup soup(limits, axes);
    ReadInto(bytes, extension, open, limits, &soup);
    return soup.Take();
  } catch (const BadMesh& error) {
    throw InputError({name, 0, "", error.what()});
  }
}

scene::SurfaceMesh ImportMesh(const fs::path& path, const MeshLimits& limits) {
  const std::string extension = ExtensionOf(path);
  // Do not read files with other extensions at all.
  const std::string bytes = IsKnown(extension) ? ReadFile(path, limits.max_file_bytes) : "";
  return ParseMesh(bytes, extension, limits, path.string(),
                   [&](const std::string& name, std::size_t max_bytes) {
                     return ReadNeighbour(path, name, max_bytes);
                   });
}

}  // namespace smile::mesh

// STL in both forms. Binary: 80 bytes of text, u32 number of triangles, and per triangle a normal
// and three corners of three floats and u16, little-endian. Normals are ignored: programs write
// them wrongly too often, and the corners define the same.

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "base/files.h"
#include "base/wording.h"
#include "mesh/internal_mesh_formats.h"
#include "mesh/internal_words.h"

namespace smile::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

// Layout of binary STL.
constexpr std::size_t kHeaderBytes = 84;    // 80 arbitrary bytes and the number of triangles
constexpr std::size_t kTriangleBytes = 50;  // a normal, three corners and 2 arbitrary bytes

/// Returns the number of triangles in the header.
std::uint32_t CountIn(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes - sizeof count, sizeof count);
  return count;
}

/// Returns true if the size matches the number of triangles in the header.
bool IsBinaryOfRightSize(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() - kHeaderBytes == kTriangleBytes * std::size_t{CountIn(bytes)};
}

/// Reads binary STL; the size must match the number of triangles.
void ReadBinary(std::string_view bytes, TriangleSoup* soup) {
  if (bytes.size() < kHeaderBytes) {
    throw BadMesh("found " + std::to_string(bytes.size()) +
                  " bytes, expected an STL file: it is truncated or has another format");
  }
  const std::size_t count = CountIn(bytes), expected = kHeaderBytes + kTriangleBytes * count;
  if (bytes.size() != expected) {
    throw BadMesh("found " + std::to_string(bytes.size()) + " bytes, expected " +
                  std::to_string(expected) + " for the " + std::to_string(count) +
                  " triangles given in its header" +
                  (bytes.size() < expected ? ": it is truncated or not an STL file" : ""));
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::array<TriangleSoup::Corner, 4> rows;  // the first is the normal
    // Without the 2 bytes of attributes at the end.
    static_assert(sizeof rows == 48);
    std::memcpy(rows.data(), bytes.data() + kHeaderBytes + kTriangleBytes * i, sizeof rows);
    soup->Add(rows[1], rows[2], rows[3]);
  }
}

/// Reads a word that must follow here.
void Expect(std::string_view word, Words* words) {
  const std::string_view found = words->Next();
  if (IsSameWord(found, word)) return;
  words->Fail(found.empty() ? "the end" : Quoted(found), std::string(word));
}

TriangleSoup::Corner ReadCorner(Words* words) {
  TriangleSoup::Corner corner;
  for (float& coordinate : corner) coordinate = words->Number(words->Next());
  return corner;
}

/// Reads text STL up to `endsolid`.
void ReadText(std::string_view bytes, TriangleSoup* soup) {
  Words words(bytes);
  Expect("solid", &words);
  words.NextLine();  // the solid's name
  while (true) {
    const std::string_view word = words.Next();
    if (IsSameWord(word, "endsolid")) return;
    if (word.empty()) words.Fail("the end", "facet or endsolid: it is truncated");
    if (!IsSameWord(word, "facet")) words.Fail(Quoted(word), "facet or endsolid");
    Expect("normal", &words);
    for (int i = 0; i < 3; ++i) words.Next();  // the normal; some programs write "nan" here
    Expect("outer", &words);
    Expect("loop", &words);
    std::array<TriangleSoup::Corner, 3> corners;
    for (TriangleSoup::Corner& corner : corners) {
      Expect("vertex", &words);
      corner = ReadCorner(&words);
    }
    Expect("endloop", &words);
    Expect("endfacet", &words);
    soup->Add(corners[0], corners[1], corners[2]);
  }
}

/// Appends a vector as three floats in the file's axes.
void Append(const Eigen::Vector3f& v, std::string* bytes) {
  const std::array<float, 3> row{v.x(), v.z(), -v.y()};  // inverse of MeshAxes::kStanding
  bytes->append(reinterpret_cast<const char*>(row.data()), sizeof row);
}

}  // namespace

void ReadStl(std::string_view bytes, TriangleSoup* soup) {
  // Binary files may also begin with "solid", so the size decides.
  if (!IsBinaryOfRightSize(bytes) && IsSameWord(Words(bytes.substr(0, 200)).Next(), "solid")) {
    return ReadText(bytes, soup);
  }
  ReadBinary(bytes, soup);
}

std::string StlOf(const scene::SurfaceMesh& mesh) {
  // Must not begin with "solid", which some readers take for the text form.
  std::string bytes = "SMILE mesh";
  bytes.resize(kHeaderBytes - sizeof(std::uint32_t), ' ');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const scene::SurfaceMesh::Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3f &a = mesh.vertices.at(triangle[0]), &b = mesh.vertices.at(triangle[1]),
                          &c = mesh.vertices.at(triangle[2]);
    // The normal is in the mesh's axes; Append() converts it.
    const Eigen::Vector3d normal = (b - a).cast<double>().cross((c - a).cast<double>());
    Append(normal.normalized().cast<float>(), &bytes);
    for (const Eigen::Vector3f& corner : {a, b, c}) Append(corner, &bytes);
    bytes.append(2, '\0');
  }
  return bytes;
}

void WriteStl(const scene::SurfaceMesh& mesh, const std::filesystem::path& path) {
  WriteFile(path, StlOf(mesh));
}

}  // namespace smile::mesh

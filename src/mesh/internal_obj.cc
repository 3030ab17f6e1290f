// OBJ, of which only `v` and `f` are read; normals, textures, groups and materials do not change
// the surface. The format has no header and no counts, so limits apply while reading.

#include <charconv>
#include <vector>

#include "base/wording.h"
#include "mesh/internal_mesh_formats.h"
#include "mesh/internal_words.h"

namespace smile::mesh {
namespace {

// Upper bound of listed vertices, whether faces name them or not.
constexpr std::size_t kMaxListed = 1'000'000;
constexpr std::size_t kMaxFaceCorners = 1000;

/// Returns the vertex index of a word such as `7`, `7/1`, `7//2` or `-1`: the number before a
/// slash, where negative numbers count back from the last vertex so far.
std::size_t CornerNumber(std::string_view word, std::size_t num_vertices, const Words& words) {
  long long number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  // Indices of texture and normal may follow after slashes.
  const bool is_number =
      error == std::errc() && (end == word.data() + word.size() || *end == '/') && number != 0;
  const auto count = static_cast<long long>(num_vertices);
  if (!is_number || number > count || number < -count) {
    words.Fail("corner " + Quoted(word),
               "the number of a vertex, 1 to " + std::to_string(num_vertices));
  }
  return static_cast<std::size_t>(number > 0 ? number - 1 : count + number);
}

}  // namespace

void ReadObj(std::string_view bytes, TriangleSoup* soup) {
  Words words(bytes);
  std::vector<TriangleSoup::Corner> vertices;
  // A line that is continued by a backslash is not supported; unknown kinds of lines are skipped.
  do {
    const std::string_view kind = words.NextInLine();
    if (kind == "v") {
      TriangleSoup::Corner& corner = vertices.emplace_back();
      for (float& coordinate : corner) coordinate = words.Number(words.NextInLine());
      if (vertices.size() > kMaxListed) {
        throw BadMesh("found more than " + std::to_string(kMaxListed) +
                      " vertices, expected fewer");
      }
    } else if (kind == "f") {
      std::vector<std::size_t> face;
      for (auto word = words.NextInLine(); !word.empty(); word = words.NextInLine()) {
        face.push_back(CornerNumber(word, vertices.size(), words));
        if (face.size() > kMaxFaceCorners) words.Fail("a face of more corners", "at most 1000");
      }
      if (face.size() < 3) words.Fail("a face of fewer corners", "at least 3");
      // Faces are assumed to be convex.
      for (std::size_t k = 2; k < face.size(); ++k) {
        soup->Add(vertices[face[0]], vertices[face[k - 1]], vertices[face[k]]);
      }
    }
  } while (words.NextLine());
}

}  // namespace smile::mesh

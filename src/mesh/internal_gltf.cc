// glTF 2.0, text or binary: JSON that describes typed views (accessors) of byte buffers. Two uses:
// geometry of a mesh file as a soup of triangles, and the pieces of shipped robots with colors and
// links. Only the subset that carries geometry is read; required extensions are refused, as they
// change the meaning of the rest.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "base/wording.h"
#include "mesh/import_pieces.h"
#include "mesh/internal_mesh_formats.h"

namespace smile::mesh {
namespace {

// Constants of the format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;
constexpr int kTriangles = 4, kStrip = 5, kFan = 6;
constexpr int kMaxDepth = 64;

/// Returns a little-endian 32-bit number.
std::uint32_t WordAt(std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(std::uint32_t)) {
    throw BadMesh("found the end of the file within a number: it is truncated");
  }
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// The JSON of a file and, for a GLB, its binary chunk.
struct Container {
  std::string_view json;
  std::optional<std::string_view> binary;
};

/// Splits a GLB into its chunks; any other file is all JSON.
Container Open(std::string_view bytes) {
  if (bytes.size() < 4 || WordAt(bytes, 0) != kMagic) return {bytes, std::nullopt};
  if (WordAt(bytes, 4) != 2) {
    throw BadMesh("found version " + std::to_string(WordAt(bytes, 4)) + " of GLB, expected 2");
  }
  // Bytes 0 to 11: magic, version, total length, each a little-endian word.
  if (WordAt(bytes, 8) != bytes.size()) {
    throw BadMesh("found " + std::to_string(bytes.size()) + " bytes, expected the " +
                  std::to_string(WordAt(bytes, 8)) + " given in its header");
  }
  Container container;
  // After the header of 12 bytes: chunks, each with its size and kind. Unknown kinds are skipped;
  // the first JSON chunk counts, and the first binary one.
  for (std::size_t offset = 12; offset < bytes.size();) {
    const std::size_t size = WordAt(bytes, offset);
    const std::uint32_t kind = WordAt(bytes, offset + 4);
    offset += 8;
    if (size > bytes.size() - offset) throw BadMesh("found a truncated chunk");
    if (kind == kJsonChunk && container.json.empty()) container.json = bytes.substr(offset, size);
    if (kind == kBinaryChunk && !container.binary) container.binary = bytes.substr(offset, size);
    offset += size;
  }
  return container;
}

/// Decodes base64 up to its padding.
/// @throws BadMesh for any other letter.
std::string FromBase64(std::string_view text) {
  std::string bytes;
  // Old bits are shifted out at the top; the lowest `num_bits` of `bits` are still to be written.
  std::uint32_t bits = 0;
  int num_bits = 0;
  for (const char letter : text) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t digit = kDigits.find(letter);
    if (letter == '=') break;
    if (digit == std::string_view::npos) throw BadMesh("found a data uri that is not base64");
    // Six bits per letter; a byte is complete when eight have accumulated.
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    num_bits += 6;
    if (num_bits < 8) continue;
    num_bits -= 8;
    bytes.push_back(static_cast<char>(bits >> num_bits & 0xff));
  }
  return bytes;
}

/// Reads the geometry of a glTF file. All offsets, counts and indices are checked before use.
class GltfReader {
 public:
  GltfReader(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes)
      : open_(open), bytes_left_(max_bytes - std::min(max_bytes, bytes.size())) {
    const Container container = Open(bytes);
    json_ = ParseJson(container.json);
    binary_ = container.binary;
    if (const auto it = json_.find("extensionsRequired"); it != json_.end()) {
      for (const Json& name : *it) {
        throw BadMesh("found the required extension " + Quoted(name.get<std::string>()) +
                      ", expected plain glTF 2.0");
      }
    }
  }

  /// Adds the triangles of all meshes in the scene, each in its place.
  void ReadInto(TriangleSoup* soup) {
    is_used_.resize(List("nodes").size());
    for (const Json& node : RootNodes()) {
      Visit(node.get<std::size_t>(), Eigen::Affine3d::Identity(), 0, soup);
    }
  }

  /// Returns the pieces of the scene's root nodes; a mesh that several nodes use is read once.
  std::vector<MeshPiece> ReadPieces() {
    std::vector<MeshPiece> pieces;
    std::map<std::size_t, std::vector<MeshPiece>> pieces_of_mesh;
    for (const Json& number : RootNodes()) {
      const Json& node = At("nodes", number.get<std::size_t>());
      // Shipped pieces are in the frames of their links, so transforms are not supported.
      for (const char* key : {"matrix", "translation", "rotation", "scale", "children"}) {
        if (node.contains(key)) {
          throw BadMesh("found a node with " + Quoted(key) + ", expected a mesh and its link only");
        }
      }
      const auto mesh = node.at("mesh").get<std::size_t>();
      const auto [known, is_new] = pieces_of_mesh.try_emplace(mesh);
      if (is_new) known->second = PiecesOf(At("meshes", mesh));
      for (MeshPiece piece : known->second) {
        piece.node = node.value("name", "");
        piece.extras = node.value("extras", Json::object());
        pieces.push_back(std::move(piece));
      }
    }
    return pieces;
  }

 private:
  /// Returns a top-level list, empty if it is missing.
  const Json& List(const char* name) const {
    static const Json kNothing = Json::array();
    const auto it = json_.find(name);
    return it == json_.end() ? kNothing : *it;
  }

  const Json& At(const char* name, std::size_t index) const {
    const Json& list = List(name);
    if (list.is_array() && index < list.size()) return list[index];
    throw BadMesh("found number " + std::to_string(index) + " of \"" + name +
                  "\", expected one of " + std::to_string(list.size()));
  }

  const Json& RootNodes() const {
    static const Json kNone = Json::array();
    if (List("scenes").empty()) throw BadMesh("found no scene, expected one");
    // The default scene; files without scenes are libraries of parts, which are refused.
    const Json& scene = At("scenes", json_.value("scene", std::size_t{0}));
    const auto it = scene.find("nodes");
    return it == scene.end() ? kNone : *it;
  }

  std::vector<MeshPiece> PiecesOf(const Json& mesh) {
    std::vector<MeshPiece> pieces;
    for (const Json& primitive : mesh.at("primitives")) {
      if (primitive.value("mode", kTriangles) != kTriangles || !primitive.contains("indices")) {
        throw BadMesh("found a primitive of another kind, expected triangles with indices");
      }
      scene::SurfaceMesh surface;
      for (const TriangleSoup::Corner& p : PositionsOf(primitive, Eigen::Affine3d::Identity())) {
        surface.vertices.emplace_back(p[0], p[1], p[2]);
        if (!surface.vertices.back().allFinite())
          throw BadMesh("found a position that is not a number");
      }
      // Indices() checks them against the number of vertices.
      const auto order =
          Indices(primitive.at("indices").get<std::size_t>(), surface.vertices.size());
      ExpectWholeTriangles(order.size());
      for (std::size_t k = 0; k < order.size(); k += 3) {
        surface.triangles.push_back({order[k], order[k + 1], order[k + 2]});
      }
      pieces.push_back({.color = ColorOf(primitive),
                        .mesh = std::make_shared<const scene::CustomMesh>(
                            scene::CustomMesh{.surface = std::move(surface)})});
    }
    return pieces;
  }

  /// Returns the base color. glTF's colors are linear, those of the project sRGB (IEC 61966-2-1).
  Color ColorOf(const Json& primitive) const {
    const Json& material = At("materials", primitive.at("material").get<std::size_t>());
    // Factors are required here, as there is no texture to fall back to.
    const auto linear =
        material.at("pbrMetallicRoughness").at("baseColorFactor").get<std::array<double, 4>>();
    const auto on_screen = [](double channel) {
      if (!(channel >= 0 && channel <= 1)) throw BadMesh("found a color outside 0 to 1");
      return channel <= 0.0031308 ? 12.92 * channel : 1.055 * std::pow(channel, 1 / 2.4) - 0.055;
    };
    return {on_screen(linear[0]), on_screen(linear[1]), on_screen(linear[2])};
  }

  void Visit(std::size_t number, const Eigen::Affine3d& X_SP, int depth, TriangleSoup* soup) {
    const Json& node = At("nodes", number);
    // The format demands a tree; shared nodes could multiply without bound.
    if (is_used_[number]) {
      throw BadMesh("found node " + std::to_string(number) + " in two places, expected one");
    }
    is_used_[number] = true;
    // Visit() is recursive; a chain of nodes could exhaust the stack.
    if (depth >= kMaxDepth) throw BadMesh("found nodes more than 64 deep, expected fewer");
    const Eigen::Affine3d X_SN = X_SP * PlaceOf(node);
    if (node.contains("mesh")) {
      for (const Json& primitive :
           At("meshes", node.at("mesh").get<std::size_t>()).at("primitives")) {
        Add(primitive, X_SN, soup);
      }
    }
    if (!node.contains("children")) return;
    for (const Json& child : node.at("children")) {
      Visit(child.get<std::size_t>(), X_SN, depth + 1, soup);
    }
  }

  /// Returns the transform of a node in its parent.
  static Eigen::Affine3d PlaceOf(const Json& node) {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (const auto it = node.find("matrix"); it != node.end()) {
      // A matrix replaces the three separate properties; the format allows only one of both.
      const auto numbers = it->get<std::array<double, 16>>();  // column by column
      place.affine() = Eigen::Map<const Eigen::Matrix4d>(numbers.data()).topRows<3>();
      return place;
    }
    const auto moved = node.value("translation", std::array<double, 3>{0, 0, 0});
    const auto turned = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
    const auto scaled = node.value("scale", std::array<double, 3>{1, 1, 1});
    // glTF applies scale first, then rotation, then translation.
    place.translate(Eigen::Vector3d(moved[0], moved[1], moved[2]));
    place.rotate(Eigen::Quaterniond(turned[3], turned[0], turned[1], turned[2]).normalized());
    place.scale(Eigen::Vector3d(scaled[0], scaled[1], scaled[2]));
    return place;
  }

  void Add(const Json& primitive, const Eigen::Affine3d& X_SN, TriangleSoup* soup) {
    const int mode = primitive.value("mode", kTriangles);
    if (mode != kTriangles && mode != kStrip && mode != kFan) return;  // points and lines
    const auto corners = PositionsOf(primitive, X_SN);
    std::vector<std::uint32_t> order;
    if (const auto it = primitive.find("indices"); it != primitive.end()) {
      order = Indices(it->get<std::size_t>(), corners.size());
    } else {
      for (std::uint32_t i = 0; i < corners.size(); ++i) order.push_back(i);
    }
    if (mode == kTriangles) ExpectWholeTriangles(order.size());
    const bool is_mirrored = X_SN.linear().determinant() < 0;
    // One loop for all modes, by the last corner of each triangle. A list advances by three; a
    // strip and a fan make a triangle with each further corner.
    for (std::size_t k = 2; k < order.size(); k += mode == kTriangles ? 3 : 1) {
      std::uint32_t a = order[mode == kFan ? 0 : k - 2], b = order[k - 1];
      // Every second triangle of a strip runs the other way, and so do all triangles of a mirrored
      // node.
      if (is_mirrored != (mode == kStrip && k % 2 == 1)) std::swap(a, b);
      soup->Add(corners[a], corners[b], corners[order[k]]);
    }
  }

  static void ExpectWholeTriangles(std::size_t num_corners) {
    if (num_corners % 3 == 0) return;
    throw BadMesh("found " + std::to_string(num_corners) +
                  " corners of triangles, expected three for each");
  }

  std::vector<TriangleSoup::Corner> PositionsOf(const Json& primitive,
                                                const Eigen::Affine3d& X_SN) {
    return Positions(primitive.at("attributes").at("POSITION").get<std::size_t>(), X_SN);
  }

  /// Elements of an accessor: `count` of them, `stride` bytes apart.
  struct Elements {
    const char* begin;
    std::size_t stride, count;
    int type;
  };

  /// Returns the elements of an accessor after checking that all of them lie within their buffer.
  Elements Access(std::size_t number, std::string_view shape, std::size_t components) {
    const Json& accessor = At("accessors", number);
    if (accessor.at("type") != shape || accessor.contains("sparse") ||
        !accessor.contains("bufferView")) {
      throw BadMesh("found accessor " + std::to_string(number) + " of another kind, expected " +
                    std::string(shape) + " out of a buffer, not sparse");
    }
    const int type = accessor.at("componentType");
    // Other types count as four bytes; callers reject those that they do not read.
    const std::size_t size = components * (type == kByte ? 1 : type == kShort ? 2 : 4);
    const Json& view = At("bufferViews", accessor.at("bufferView").get<std::size_t>());
    const std::string_view all = Buffer(view.at("buffer").get<std::size_t>());
    const std::size_t view_begin = view.value("byteOffset", std::size_t{0});
    const std::size_t view_size = view.at("byteLength").get<std::size_t>();
    const std::size_t stride = view.value("byteStride", size);
    const std::size_t begin = accessor.value("byteOffset", std::size_t{0});
    const std::size_t count = accessor.at("count").get<std::size_t>();
    // Comparisons are written as subtractions, so that no sum can overflow. The view must lie in
    // its buffer, and the last element of the accessor in its view.
    const bool fits_view = view_begin <= all.size() && view_size <= all.size() - view_begin;
    if (!fits_view || stride < size || stride > 4096 || count > all.size() || begin > view_size ||
        (count > 0 && (count - 1) * stride + size > view_size - begin)) {
      throw BadMesh("found accessor " + std::to_string(number) +
                    " that extends beyond its buffer, expected it inside: it is truncated");
    }
    return {all.data() + view_begin + begin, stride, count, type};
  }

  std::vector<TriangleSoup::Corner> Positions(std::size_t number, const Eigen::Affine3d& X_SN) {
    const Elements elements = Access(number, "VEC3", 3);
    if (elements.type != kFloat) throw BadMesh("found positions of another type, expected floats");
    CountWork(elements.count);
    std::vector<TriangleSoup::Corner> corners;
    for (std::size_t i = 0; i < elements.count; ++i) {
      Eigen::Vector3f p;
      std::memcpy(p.data(), elements.begin + i * elements.stride, 3 * sizeof(float));
      // In double, so that a chain of transforms is rounded once.
      p = (X_SN * p.cast<double>()).cast<float>();
      corners.push_back({p.x(), p.y(), p.z()});
    }
    return corners;
  }

  std::vector<std::uint32_t> Indices(std::size_t number, std::size_t num_corners) {
    const Elements elements = Access(number, "SCALAR", 1);
    if (elements.type != kByte && elements.type != kShort && elements.type != kInt) {
      throw BadMesh("found corner indices of another type, expected integers");
    }
    CountWork(elements.count);
    const std::size_t size = elements.type == kByte ? 1 : elements.type == kShort ? 2 : 4;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < elements.count; ++i) {
      // Little-endian: the low bytes come first, so a shorter type fills the low part of the word.
      std::uint32_t index = 0;
      std::memcpy(&index, elements.begin + i * elements.stride, size);
      if (index >= num_corners) {
        throw BadMesh("found corner " + std::to_string(index) + ", expected one below " +
                      std::to_string(num_corners));
      }
      indices.push_back(index);
    }
    return indices;
  }

  /// Limits the number of elements read in all: many nodes may name the same accessor.
  void CountWork(std::size_t count) {
    constexpr std::size_t kMaxRead = 4'000'000;
    num_read_ += count;
    if (num_read_ > kMaxRead) throw BadMesh("found more than 4000000 corners, expected fewer");
  }

  /// Returns the bytes of a buffer, loaded once.
  std::string_view Buffer(std::size_t number) {
    const Json& buffer = At("buffers", number);
    if (buffers_.size() <= number) buffers_.resize(number + 1);
    if (!buffer.contains("uri")) {
      if (number == 0 && binary_) return *binary_;
      throw BadMesh("found a buffer without uri, expected one");
    }
    if (!buffers_[number]) buffers_[number] = Load(buffer.at("uri").get<std::string>());
    return *buffers_[number];
  }

  std::string Load(const std::string& uri) {
    if (uri.starts_with("data:")) {
      // Text before it is a media type, which does not matter.
      const std::size_t comma = uri.find(";base64,");
      if (comma == std::string::npos) throw BadMesh("found a data uri that is not base64");
      return FromBase64(std::string_view(uri).substr(comma + 8));
    }
    if (!open_) throw BadMesh("found the uri " + Quoted(uri) + ", expected all in one file");
    // All buffers together stay within the limit of the file.
    std::string bytes = open_(uri, bytes_left_);
    bytes_left_ -= bytes.size();
    return bytes;
  }

  Json json_;
  std::optional<std::string_view> binary_;
  const OpenNeighbour& open_;
  std::size_t bytes_left_;
  std::vector<bool> is_used_;
  std::vector<std::optional<std::string>> buffers_;
  std::size_t num_read_ = 0;
};

}  // namespace

namespace {

/// Runs `read` with a reader of the file; JSON errors become BadMesh.
template <class Read>
auto WithReader(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes,
                const Read& read) {
  try {
    GltfReader reader(bytes, open, max_bytes);
    return read(reader);
  } catch (const Json::exception& error) {  // a key is missing or of another type
    throw BadMesh(std::string("is not a readable glTF: ") + error.what());
  } catch (const std::invalid_argument& error) {  // no JSON at all
    throw BadMesh(std::string("is not glTF: ") + error.what());
  }
}

}  // namespace

void ReadGltf(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes,
              TriangleSoup* soup) {
  WithReader(bytes, open, max_bytes, [soup](GltfReader& reader) { reader.ReadInto(soup); });
}

std::vector<MeshPiece> ImportPieces(const std::filesystem::path& path, const MeshLimits& limits) {
  const std::string bytes = ReadFile(path, limits.max_file_bytes);
  try {
    return WithReader(bytes, {}, limits.max_file_bytes,
                      [](GltfReader& reader) { return reader.ReadPieces(); });
  } catch (const BadMesh& error) {
    throw InputError({path.string(), 0, "", error.what()});
  }
}

}  // namespace smile::mesh

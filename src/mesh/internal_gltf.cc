#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "base/json.h"
#include "base/wording.h"
#include "mesh/internal_mesh_formats.h"

namespace smile::mesh {
namespace {

// Numbers of the format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;
constexpr int kTriangles = 4, kStrip = 5, kFan = 6;
constexpr int kMaxDepth = 64;

std::uint32_t WordAt(std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(std::uint32_t)) {
    throw BadMesh("found the end in the middle of a number: it is cut short");
  }
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// The JSON of a file and, of a GLB, the bytes that came with it.
struct Container {
  std::string_view json;
  std::optional<std::string_view> binary;
};

Container Open(std::string_view bytes) {
  if (bytes.size() < 4 || WordAt(bytes, 0) != kMagic) return {bytes, std::nullopt};
  if (WordAt(bytes, 4) != 2) {
    throw BadMesh("found version " + std::to_string(WordAt(bytes, 4)) + " of GLB, expected 2");
  }
  if (WordAt(bytes, 8) != bytes.size()) {
    throw BadMesh("found " + std::to_string(bytes.size()) + " bytes, expected the " +
                  std::to_string(WordAt(bytes, 8)) + " it says it has");
  }
  Container container;
  for (std::size_t offset = 12; offset < bytes.size();) {
    const std::size_t size = WordAt(bytes, offset);
    const std::uint32_t kind = WordAt(bytes, offset + 4);
    offset += 8;
    if (size > bytes.size() - offset) throw BadMesh("found a chunk that is cut short");
    if (kind == kJsonChunk && container.json.empty()) container.json = bytes.substr(offset, size);
    if (kind == kBinaryChunk && !container.binary) container.binary = bytes.substr(offset, size);
    offset += size;
  }
  return container;
}

std::string FromBase64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int num_bits = 0;
  for (const char letter : text) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t digit = kDigits.find(letter);
    if (letter == '=') break;
    if (digit == std::string_view::npos) throw BadMesh("found a data uri that is not base64");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    num_bits += 6;
    if (num_bits < 8) continue;
    num_bits -= 8;
    bytes.push_back(static_cast<char>(bits >> num_bits & 0xff));
  }
  return bytes;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes,
             TriangleSoup* soup)
      : open_(open), bytes_left_(max_bytes - std::min(max_bytes, bytes.size())), soup_(*soup) {
    const Container container = Open(bytes);
    json_ = ParseJson(container.json);
    binary_ = container.binary;
  }

  void Read() {
    if (const auto it = json_.find("extensionsRequired"); it != json_.end()) {
      for (const Json& name : *it) {
        throw BadMesh("found the required extension " + Quoted(name.get<std::string>()) +
                      ", expected plain glTF 2.0");
      }
    }
    is_used_.resize(List("nodes").size());
    const Json& scenes = List("scenes");
    if (scenes.empty()) throw BadMesh("found no scene, expected one");
    const Json& scene = At("scenes", json_.value("scene", std::size_t{0}));
    if (!scene.contains("nodes")) return;
    for (const Json& node : scene.at("nodes")) {
      Visit(node.get<std::size_t>(), Eigen::Affine3d::Identity(), 0);
    }
  }

 private:
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

  void Visit(std::size_t number, const Eigen::Affine3d& X_SP, int depth) {
    const Json& node = At("nodes", number);
    if (is_used_[number]) {
      throw BadMesh("found node " + std::to_string(number) + " in two places, expected one");
    }
    is_used_[number] = true;
    if (depth >= kMaxDepth) throw BadMesh("found nodes more than 64 deep, expected fewer");
    const Eigen::Affine3d X_SN = X_SP * PlaceOf(node);
    if (node.contains("mesh")) {
      for (const Json& primitive :
           At("meshes", node.at("mesh").get<std::size_t>()).at("primitives")) {
        Add(primitive, X_SN);
      }
    }
    if (!node.contains("children")) return;
    for (const Json& child : node.at("children")) {
      Visit(child.get<std::size_t>(), X_SN, depth + 1);
    }
  }

  static Eigen::Affine3d PlaceOf(const Json& node) {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (const auto it = node.find("matrix"); it != node.end()) {
      const auto numbers = it->get<std::array<double, 16>>();  // column by column
      place.affine() = Eigen::Map<const Eigen::Matrix4d>(numbers.data()).topRows<3>();
      return place;
    }
    const auto moved = node.value("translation", std::array<double, 3>{0, 0, 0});
    const auto turned = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
    const auto scaled = node.value("scale", std::array<double, 3>{1, 1, 1});
    place.translate(Eigen::Vector3d(moved[0], moved[1], moved[2]));
    place.rotate(Eigen::Quaterniond(turned[3], turned[0], turned[1], turned[2]).normalized());
    place.scale(Eigen::Vector3d(scaled[0], scaled[1], scaled[2]));
    return place;
  }

  void Add(const Json& primitive, const Eigen::Affine3d& X_SN) {
    const int mode = primitive.value("mode", kTriangles);
    if (mode != kTriangles && mode != kStrip && mode != kFan) return;  // points and lines
    const auto corners =
        Positions(primitive.at("attributes").at("POSITION").get<std::size_t>(), X_SN);
    std::vector<std::uint32_t> order;
    if (const auto it = primitive.find("indices"); it != primitive.end()) {
      order = Indices(it->get<std::size_t>(), corners.size());
    } else {
      for (std::uint32_t i = 0; i < corners.size(); ++i) order.push_back(i);
    }
    if (mode == kTriangles && order.size() % 3 != 0) {
      throw BadMesh("found " + std::to_string(order.size()) +
                    " corners of triangles, expected three for each");
    }
    const bool is_mirrored = X_SN.linear().determinant() < 0;
    for (std::size_t k = 2; k < order.size(); k += mode == kTriangles ? 3 : 1) {
      std::uint32_t a = order[mode == kFan ? 0 : k - 2], b = order[k - 1];
      if (is_mirrored != (mode == kStrip && k % 2 == 1)) std::swap(a, b);
      soup_.Add(corners[a], corners[b], corners[order[k]]);
    }
  }

  /// The bytes of an accessor's elements, one after the other `stride` apart.
  struct Elements {
    const char* begin;
    std::size_t stride, count;
    int type;
  };

  Elements Access(std::size_t number, std::string_view shape, std::size_t components) {
    const Json& accessor = At("accessors", number);
    if (accessor.at("type") != shape || accessor.contains("sparse") ||
        !accessor.contains("bufferView")) {
      throw BadMesh("found accessor " + std::to_string(number) + " of another kind, expected " +
                    std::string(shape) + " out of a buffer, not sparse");
    }
    const int type = accessor.at("componentType");
    const std::size_t size = components * (type == kByte ? 1 : type == kShort ? 2 : 4);
    const Json& view = At("bufferViews", accessor.at("bufferView").get<std::size_t>());
    const std::string_view all = Buffer(view.at("buffer").get<std::size_t>());
    const std::size_t view_begin = view.value("byteOffset", std::size_t{0});
    const std::size_t view_size = view.at("byteLength").get<std::size_t>();
    const std::size_t stride = view.value("byteStride", size);
    const std::size_t begin = accessor.value("byteOffset", std::size_t{0});
    const std::size_t count = accessor.at("count").get<std::size_t>();
    const bool fits_view = view_begin <= all.size() && view_size <= all.size() - view_begin;
    if (!fits_view || stride < size || stride > 4096 || count > all.size() || begin > view_size ||
        (count > 0 && (count - 1) * stride + size > view_size - begin)) {
      throw BadMesh("found accessor " + std::to_string(number) +
                    " that reaches beyond its buffer, expected it within: it is cut short");
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
      p = (X_SN * p.cast<double>()).cast<float>();
      corners.push_back({p.x(), p.y(), p.z()});
    }
    return corners;
  }

  std::vector<std::uint32_t> Indices(std::size_t number, std::size_t num_corners) {
    const Elements elements = Access(number, "SCALAR", 1);
    if (elements.type != kByte && elements.type != kShort && elements.type != kInt) {
      throw BadMesh("found corner numbers of another type, expected whole ones");
    }
    CountWork(elements.count);
    const std::size_t size = elements.type == kByte ? 1 : elements.type == kShort ? 2 : 4;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < elements.count; ++i) {
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

  /// Many nodes may name the same numbers: what is read for them all is limited.
  void CountWork(std::size_t count) {
    constexpr std::size_t kMaxRead = 4'000'000;
    num_read_ += count;
    if (num_read_ > kMaxRead) throw BadMesh("found more than 4000000 corners, expected fewer");
  }

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
      const std::size_t comma = uri.find(";base64,");
      if (comma == std::string::npos) throw BadMesh("found a data uri that is not base64");
      return FromBase64(std::string_view(uri).substr(comma + 8));
    }
    if (!open_) throw BadMesh("found the uri " + Quoted(uri) + ", expected all in one file");
    std::string bytes = open_(uri, bytes_left_);
    bytes_left_ -= bytes.size();
    return bytes;
  }

  Json json_;
  std::optional<std::string_view> binary_;
  const OpenNeighbour& open_;
  std::size_t bytes_left_;
  TriangleSoup& soup_;
  std::vector<bool> is_used_;
  std::vector<std::optional<std::string>> buffers_;
  std::size_t num_read_ = 0;
};

}  // namespace

void ReadGltf(std::string_view bytes, const OpenNeighbour& open, std::size_t max_bytes,
              TriangleSoup* soup) {
  try {
    GltfReader(bytes, open, max_bytes, soup).Read();
  } catch (const Json::exception& error) {  // a key is missing or of another type
    throw BadMesh(std::string("is no glTF we can read: ") + error.what());
  } catch (const std::invalid_argument& error) {  // no JSON at all
    throw BadMesh(std::string("is no glTF: ") + error.what());
  }
}

}  // namespace smile::mesh

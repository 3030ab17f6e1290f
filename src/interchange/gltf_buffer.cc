#include <algorithm>

#include "interchange/internal_gltf_buffer.h"

namespace smile::interchange {
namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125;

const char* TypeOf(int per_element) {
  constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
  return kTypes[static_cast<std::size_t>(per_element - 1)];
}

}  // namespace

int GltfBuffer::AddView(std::size_t offset, int target) {
  Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes_.size() - offset}};
  if (target != 0) view["target"] = target;
  views_.push_back(std::move(view));
  return static_cast<int>(views_.size()) - 1;
}

int GltfBuffer::AddFloats(const std::vector<float>& values, int per_element, bool has_range,
                          int target) {
  const std::size_t offset = bytes_.size();
  bytes_.PutBytes(std::as_bytes(std::span(values)));
  const auto width = static_cast<std::size_t>(per_element);
  Json accessor{{"bufferView", AddView(offset, target)},
                {"componentType", kFloat},
                {"count", values.size() / width},
                {"type", TypeOf(per_element)}};
  if (has_range) {
    std::vector<float> least(values.begin(), values.begin() + per_element), greatest = least;
    for (std::size_t i = 0; i < values.size(); ++i) {
      least[i % width] = std::min(least[i % width], values[i]);
      greatest[i % width] = std::max(greatest[i % width], values[i]);
    }
    accessor["min"] = std::vector<double>(least.begin(), least.end());
    accessor["max"] = std::vector<double>(greatest.begin(), greatest.end());
  }
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::AddIndices(const std::vector<std::uint32_t>& indices) {
  const std::size_t offset = bytes_.size();
  bytes_.PutBytes(std::as_bytes(std::span(indices)));
  accessors_.push_back({{"bufferView", AddView(offset, kIndices)},
                        {"componentType", kUnsignedInt},
                        {"count", indices.size()},
                        {"type", "SCALAR"}});
  return static_cast<int>(accessors_.size()) - 1;
}

std::string ToGlb(const Json& document, const std::vector<std::byte>& buffer) {
  // Chunks have a length that is a multiple of 4; the buffer consists of values of 4 bytes.
  std::string json = ToText(document);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t total = 12 + 8 + json.size() + 8 + buffer.size();
  ByteWriter bytes(total);
  for (const std::uint32_t word :
       {0x46546C67u /* glTF */, 2u, static_cast<std::uint32_t>(total),
        static_cast<std::uint32_t>(json.size()), 0x4E4F534Au /* JSON */}) {
    bytes.Put(word);
  }
  bytes.PutBytes(std::as_bytes(std::span(json)));
  bytes.Put(static_cast<std::uint32_t>(buffer.size()));
  bytes.Put(0x004E4942u /* BIN */);
  bytes.PutBytes(buffer);
  const auto all = bytes.bytes();
  return {reinterpret_cast<const char*>(all.data()), all.size()};
}

}  // namespace smile::interchange

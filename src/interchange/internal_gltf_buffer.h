#pragma once

#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/json.h"
#include "math/rigid_transform.h"

namespace smile::interchange {

/// The binary buffer of a glTF file, and the accessors that describe its contents.
class GltfBuffer {
 public:
  /// Append values and return the index of their accessor.
  /// @param has_range  whether the accessor contains the smallest and the greatest values, as those
  ///                   of positions and times need to.
  int AddFloats(const std::vector<float>& values, int per_element, bool has_range, int target = 0);
  int AddIndices(const std::vector<std::uint32_t>& indices);

  const Json& accessors() const { return accessors_; }
  const Json& views() const { return views_; }
  std::vector<std::byte> Take() { return bytes_.Take(); }
  std::size_t size() const { return bytes_.size(); }

 private:
  int AddView(std::size_t offset, int target);

  ByteWriter bytes_;
  Json accessors_ = Json::array(), views_ = Json::array();
};

/// Returns a binary glTF file of a document and its buffer.
std::string ToGlb(const Json& document, const std::vector<std::byte>& buffer);

/// What the specification calls the uses of buffers.
inline constexpr int kVertices = 34962, kIndices = 34963;

}  // namespace smile::interchange

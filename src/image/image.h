#pragma once

#include <cstdint>
#include <vector>

namespace smile {

/// Image of a camera. Row 0 is the top row; pixels row by row from left to right. Channels that
/// were not requested are empty.
struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> color;  ///< height x width x 3: red, green, blue (sRGB)
  std::vector<float> depth;  ///< height x width: distance along the camera's z [m]; 0 = no hit
  std::vector<std::uint32_t> ids;  ///< height x width: object id; 0 = background

  bool operator==(const Image&) const = default;
};

}  // namespace smile

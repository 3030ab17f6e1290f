#include "interchange/linear_color.h"

#include <cmath>

namespace smile::interchange {

std::array<double, 3> LinearOf(const Color& color) {
  const auto linear = [](double shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
  };
  return {linear(color.red), linear(color.green), linear(color.blue)};
}

}  // namespace smile::interchange

#include "brain/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace smile::brain {
namespace {

/// Kind of sensor; part of the seed, so that two sensors never share their noise.
enum class Measurement : std::uint64_t { kJoints, kColor, kDepth };

/// Least noisy depth, since 0 stands for background [units].
constexpr float kNearest = 1e-6F;

/// SplitMix64 generator. Small and seekable: any seed gives an independent sequence. Source: G.
/// Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators" (2014).
class Generator {
 public:
  explicit Generator(std::uint64_t state) : state_(state) {}

  std::uint64_t Next() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// Returns a uniform number in (0, 1]; never 0, so that its logarithm exists.
  double Share() { return (static_cast<double>(Next() >> 11) + 1) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

/// Generator of normal deviates with mean 0 and standard deviation 1. Source: G. Box, M. Muller, "A
/// note on the generation of random normal deviates" (1958).
class Gaussian {
 public:
  Gaussian(std::uint64_t seed, std::uint64_t tick, Measurement what, std::uint64_t which)
      : generator_(0) {
    // Hashes seed, tick and sensor: noise depends on nothing else, so it does not change with other
    // sensors or undo.
    std::uint64_t state = seed;
    for (const std::uint64_t part : {tick, static_cast<std::uint64_t>(what), which}) {
      state = Generator(state ^ part).Next();
    }
    generator_ = Generator(state);
  }

  // Box-Muller gives two independent deviates for two uniform numbers; the second is kept for the
  // next call.
  double Next() {
    has_spare_ = !has_spare_;
    if (!has_spare_) return spare_;
    const double radius = std::sqrt(-2 * std::log(generator_.Share()));
    const double angle = 2 * std::numbers::pi * generator_.Share();
    spare_ = radius * std::sin(angle);
    return radius * std::cos(angle);
  }

 private:
  Generator generator_;
  double spare_ = 0;
  bool has_spare_ = false;
};

void AddToColors(double deviation, Gaussian gaussian, std::span<std::uint8_t> colors) {
  for (std::uint8_t& color : colors) {
    // Clamped like a real sensor that saturates. Rounding to nearest keeps the mean.
    const double noisy = color + 255 * deviation * gaussian.Next();
    color = static_cast<std::uint8_t>(std::lround(std::clamp(noisy, 0.0, 255.0)));
  }
}

void AddToDepths(double deviation, Gaussian gaussian, std::span<float> depths) {
  for (float& depth : depths) {
    // Drawn for every pixel, so that the noise of one does not depend on the others' visibility.
    const double error = deviation * gaussian.Next();
    if (depth > 0) depth = std::max(kNearest, static_cast<float>(depth + error));
  }
}

}  // namespace

void AddNoise(const SensorNoise& noise, std::uint64_t tick, Sensor* sensor) {
  // `which` is the index of the picture in this step: each camera has noise of its own.
  const auto gaussian = [&](Measurement what, std::uint64_t which) {
    return Gaussian(noise.seed, tick, what, which);
  };
  if (noise.joints > 0) {
    Gaussian errors = gaussian(Measurement::kJoints, 0);
    for (ArmSensor& arm : sensor->arms) {
      for (double& joint : arm.joints) joint += noise.joints * errors.Next();
    }
  }
  for (std::size_t k = 0; k < sensor->pictures.size(); ++k) {
    Image& image = sensor->pictures[k].image;
    if (noise.image > 0) AddToColors(noise.image, gaussian(Measurement::kColor, k), image.color);
    if (noise.depth > 0) AddToDepths(noise.depth, gaussian(Measurement::kDepth, k), image.depth);
  }
}

}  // namespace smile::brain

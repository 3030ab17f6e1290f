#include "brain/sensor_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "classic_arms.h"

namespace smile::brain {
namespace {

/// A picture in the middle of all ranges, its left half without depth.
Sensor GraySensor() {
  Image image{.width_px = 200, .height_px = 100};
  image.color.assign(200 * 100 * 3, 128);
  image.depth.assign(200 * 100, 10.0F);
  for (int v = 0; v < 100; ++v) std::fill_n(image.depth.begin() + v * 200, 100, 0.0F);
  return Classic(Sensor{.pictures = {{.image = image}, {.image = image, .name = "overhead"}}});
}

Sensor Noisy(const SensorNoise& noise, std::uint64_t tick) {
  Sensor sensor = GraySensor();
  AddNoise(noise, tick, &sensor);
  return sensor;
}

/// How far values are from `mean`, as a standard deviation.
template <class Values>
double Deviation(const Values& values, double mean) {
  double sum = 0;
  for (const auto value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(SensorNoise, HasTheRequestedDeviations) {
  const SensorNoise noise{.joints = 0.01, .image = 0.05, .depth = 0.2, .seed = 3};
  std::vector<double> angles;
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    Sensor sensor = Classic(Sensor());
    AddNoise(noise, tick, &sensor);
    for (const ArmSensor& arm : sensor.arms) {
      angles.insert(angles.end(), arm.joints.begin(), arm.joints.end());
    }
  }
  EXPECT_NEAR(Deviation(angles, 0), 0.01, 2e-4);
  const Image image = Noisy(noise, 0).pictures[0].image;
  EXPECT_NEAR(Deviation(image.color, 128) / 255, 0.05, 1e-3);
  std::vector<float> hits;
  for (const float depth : image.depth) {
    if (depth > 0) hits.push_back(depth);
  }
  EXPECT_EQ(hits.size(), image.depth.size() / 2) << "where nothing is, there is no noise";
  EXPECT_NEAR(Deviation(hits, 10), 0.2, 5e-3);
}

TEST(SensorNoise, DependsOnSeedTickAndSensorAlone) {
  const SensorNoise noise{.joints = 0.01, .image = 0.05, .seed = 3};
  const Sensor sensor = Noisy(noise, 7);
  EXPECT_EQ(JointsOf(Noisy(noise, 7)), JointsOf(sensor));
  EXPECT_EQ(Noisy(noise, 7).pictures[1].image, sensor.pictures[1].image);
  EXPECT_NE(sensor.pictures[1].image, sensor.pictures[0].image);
  EXPECT_NE(JointsOf(Noisy(noise, 8)), JointsOf(sensor));
  SensorNoise other = noise;
  other.seed = 4;
  EXPECT_NE(JointsOf(Noisy(other, 7)), JointsOf(sensor));
  other = noise;
  other.image = 0;
  EXPECT_EQ(JointsOf(Noisy(other, 7)), JointsOf(sensor)) << "sensors share no noise";
}

TEST(SensorNoise, IsZeroByDefault) {
  const Sensor sensor = Noisy({.seed = 9}, 1);
  EXPECT_EQ(sensor.pictures[0].image, GraySensor().pictures[0].image);
  EXPECT_TRUE(JointsOf(sensor).isZero());
}

}  // namespace
}  // namespace smile::brain

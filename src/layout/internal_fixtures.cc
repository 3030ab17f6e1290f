#include "layout/internal_fixtures.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "base/uniform.h"
#include "layout/footprint.h"
#include "layout/internal_object_group.h"
#include "layout/layout.h"
#include "math/angles.h"
#include "scene/bounds.h"
#include "scene/solid.h"

namespace smile::layout {
namespace {

/// Poses that are tried for a fixture, each nearer to its place in the scene than the last.
constexpr int kFixtureTries = 100;

/// Displacement of a fixture: a rotation about its middle, then a translation.
struct FixtureMotion {
  Vector2 middle = Vector2::Zero(), offset = Vector2::Zero();  ///< [m]
  double yaw_deg = 0;

  RigidTransform transform() const {
    const RigidTransform X_about(Vector3(middle.x(), middle.y(), 0));
    const RigidTransform X_turned(RotationFromFixedAxes({0, 0, yaw_deg}),
                                  Vector3(middle.x() + offset.x(), middle.y() + offset.y(), 0));
    return X_turned * X_about.inverse();
  }
  /// Returns the moved pose. Angles are added up as numbers, so that files stay readable.
  RigidTransform operator*(const RigidTransform& X_WB) const {
    Vector3 angles_deg = FixedAxesAngles(X_WB.rotation());
    angles_deg.z() += yaw_deg;
    return RigidTransform(RotationFromFixedAxes(angles_deg), transform() * X_WB.translation());
  }
};

Footprint FootprintNow(const scene::ObjectSpec& object) {
  return FootprintOf(object, object.pose_in_world());
}

double TopOf(const scene::ObjectSpec& object) {
  return scene::BoundsOf(scene::SolidsOf(object.whole), object.pose_in_world()).high.z();
}

/// Moves the objects of a fixture, and the sliders and chains that consist of them.
void Move(const std::vector<std::size_t>& fixture, const FixtureMotion& motion,
          scene::SceneSpec* scene) {
  const auto has = [&](std::size_t i) { return std::ranges::binary_search(fixture, i); };
  for (std::size_t i : fixture) {
    RigidTransform& X_WB = scene->objects[i].whole.X_PE;
    X_WB = motion * X_WB;
  }
  for (scene::SliderSpec& slider : scene->sliders) {
    if (!has(slider.first_object)) continue;
    slider.X_WJ = motion * slider.X_WJ;
    scene->objects[slider.first_object].whole.X_PE = slider.pose_of_first();
    scene->objects[slider.first_object + 1].whole.X_PE = slider.pose_of_second();
  }
  for (scene::ChainSpec& chain : scene->chains) {
    if (!has(chain.first_object)) continue;
    chain.p_WStart = motion.transform() * chain.p_WStart;
    chain.p_WEnd = motion.transform() * chain.p_WEnd;
    const std::vector<scene::ObjectSpec> pieces = PiecesOf(chain, scene->meters_per_unit);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      scene->objects[chain.first_object + i].whole.X_PE = pieces[i].pose_in_world();
    }
  }
}

/// Returns true if a fixture of a scene keeps its distance from others, and no object of it left
/// the region in which it was `before`.
bool IsWellPlaced(const std::vector<std::size_t>& fixture, const LayoutRegion& region,
                  const scene::SceneSpec& before, const scene::SceneSpec& scene,
                  const std::vector<std::size_t>& others) {
  return std::ranges::all_of(fixture, [&](std::size_t i) {
    const scene::ObjectSpec& object = scene.objects[i];
    const Footprint was = FootprintNow(before.objects[i]), now = FootprintNow(object);
    const double top = TopOf(object);
    if (region.Holds(scene.table, was, top) && !region.Holds(scene.table, now, top)) return false;
    return std::ranges::all_of(others, [&](std::size_t k) {
      const double gap = GapBetween(now, FootprintNow(scene.objects[k]));
      return gap >= std::min(kFingerGap, GapBetween(was, FootprintNow(before.objects[k])));
    });
  });
}

FixtureMotion RandomMotion(const Vector2& middle, double fraction, std::mt19937_64* random) {
  const auto draw = [&](double most, double parts) {
    return std::round(Uniform(random, -most, most) * fraction * parts) / parts;
  };
  // Whole millimeters and tenths of a degree. The order of these draws is part of each layout.
  const double x = draw(kFixtureOffset, 1000), y = draw(kFixtureOffset, 1000);
  return {.middle = middle, .offset = {x, y}, .yaw_deg = draw(kFixtureTurnDeg, 10)};
}

}  // namespace

std::vector<std::vector<std::size_t>> FixturesOf(const scene::SceneSpec& scene,
                                                 const std::vector<std::size_t>& loose) {
  // Each object begins as a fixture of its own, named after its first object; joined fixtures take
  // the lower name.
  std::vector<std::size_t> names(scene.objects.size());
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = i;
  const auto join = [&](std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(names[a], names[b]);
    const std::size_t to = low, from = high;
    std::ranges::replace(names, from, to);
  };
  for (const scene::SliderSpec& slider : scene.sliders) {
    join(slider.first_object, slider.first_object + 1);
  }
  for (const scene::ChainSpec& chain : scene.chains) {
    for (std::size_t i = 0; i <= chain.link_ids.size(); ++i) {
      join(chain.first_object, chain.first_object + 1 + i);
    }
  }
  std::vector<bool> is_loose(scene.objects.size());
  for (std::size_t i : loose) is_loose[i] = true;
  std::vector<Footprint> footprints;
  for (const scene::ObjectSpec& object : scene.objects) footprints.push_back(FootprintNow(object));
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (is_loose[i] || is_loose[k] || names[i] == names[k]) continue;
      if (GapBetween(footprints[i], footprints[k]) == 0) join(i, k);
    }
  }
  std::vector<std::vector<std::size_t>> fixtures(scene.objects.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_loose[i]) fixtures[names[i]].push_back(i);
  }
  std::erase_if(fixtures, [](const auto& fixture) { return fixture.empty(); });
  return fixtures;
}

void MoveFixtures(std::uint64_t seed, const std::vector<std::size_t>& loose,
                  const LayoutRegion& region, scene::SceneSpec* scene) {
  const std::vector<std::vector<std::size_t>> fixtures = FixturesOf(*scene, loose);
  for (const std::vector<std::size_t>& fixture : fixtures) {
    std::vector<std::size_t> others;
    for (const auto& other : fixtures) {
      if (&other != &fixture) others.insert(others.end(), other.begin(), other.end());
    }
    std::mt19937_64 random = StreamOf(seed, 0, "fixture " + scene->objects[fixture.front()].id());
    const Vector2 middle = FootprintNow(scene->objects[fixture.front()]).center;
    for (int i = 0; i < kFixtureTries; ++i) {
      const double fraction = 1 - static_cast<double>(i) / kFixtureTries;
      scene::SceneSpec moved = *scene;
      Move(fixture, RandomMotion(middle, fraction, &random), &moved);
      if (!IsWellPlaced(fixture, region, *scene, moved, others)) continue;
      *scene = std::move(moved);
      break;
    }
  }
}

}  // namespace smile::layout

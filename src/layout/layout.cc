// Rejection sampling: groups of objects are placed one after another, large ones first, at random
// poses that satisfy all rules. If that fails, the next attempt starts over with other random
// numbers, and later ones with smaller distances, finally without a free strip.

#include "layout/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/uniform.h"
#include "layout/internal_fixtures.h"
#include "layout/internal_object_group.h"
#include "math/angles.h"
#include "scene/bounds.h"
#include "scene/solid.h"

namespace smile::layout {
namespace {

/// Distances between objects, tried in this order [m].
constexpr std::array kGaps{0.10, 0.06, 0.05, kFingerGap};
static_assert(kGaps.back() == kFingerGap);
/// Attempts per distance, and poses per group and attempt.
constexpr int kAttempts = 80, kTries = 200;
/// An object within this distance of the region's boundary counts as at the rim [m].
constexpr double kRim = 0.08;
constexpr int kNumDistractors = 3;

bool HasDistractors(LayoutLevel level) {
  return level == LayoutLevel::kDistractors || level == LayoutLevel::kMixed;
}
bool HasEdges(LayoutLevel level) {
  return level == LayoutLevel::kEdges || level == LayoutLevel::kMixed;
}

/// Appends footprints of a slider's second object along its range.
void AppendSweptSpace(const scene::SceneSpec& scene, const scene::SliderSpec& slider,
                      std::vector<Footprint>* footprints) {
  // The obstacle is where the drawer or lid can be, not only where it is.
  constexpr int kParts = 10;
  for (int i = 0; i <= kParts; ++i) {
    const double offset = slider.min_offset + (slider.max_offset - slider.min_offset) * i / kParts;
    const RigidTransform X_WB =
        slider.X_WJ * (RigidTransform(Vector3(-offset, 0, 0)) * slider.X_JB);
    footprints->push_back(FootprintOf(scene.objects[slider.first_object + 1], X_WB));
  }
}

/// Returns the footprints of all objects that stay in place.
std::vector<Footprint> ObstaclesOf(const scene::SceneSpec& scene,
                                   const std::vector<std::size_t>& loose) {
  std::vector<Footprint> obstacles;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (std::ranges::find(loose, i) != loose.end()) continue;
    obstacles.push_back(FootprintOf(scene.objects[i], scene.objects[i].pose_in_world()));
  }
  for (const scene::SliderSpec& slider : scene.sliders) AppendSweptSpace(scene, slider, &obstacles);
  return obstacles;
}

/// Returns an id that no object has.
std::string FreeId(const scene::SceneSpec& scene, std::string id) {
  const auto is_taken = [&] {
    return std::ranges::any_of(scene.objects, [&](const auto& o) { return o.id() == id; });
  };
  while (is_taken()) id += "x";
  return id;
}

/// Returns colors that the scene does not use; not white like the table, nor black, whose sides
/// look alike.
std::vector<Color> StrangeColors(const scene::SceneSpec& scene) {
  std::vector<Color> used{*ParseColor("white"), *ParseColor("black")};
  for (const scene::ObjectSpec& object : scene.objects) {
    for (const scene::Solid& solid : scene::SolidsOf(object.whole)) used.push_back(solid.color);
  }
  std::vector<Color> strange;
  for (std::string_view name : ColorNames()) {
    const Color color = *ParseColor(name);
    if (std::ranges::find(used, color) == used.end()) strange.push_back(color);
  }
  return strange;
}

/// Returns sides of cubes that a gripper can take and that no block of the scene has [m].
std::vector<double> StrangeSides(const scene::SceneSpec& scene) {
  std::vector<double> sides{0.06, 0.07, 0.13, 0.14};
  for (const scene::ObjectSpec& object : scene.objects) {
    const auto* block = std::get_if<scene::Block>(&object.whole.shape);
    if (!block) continue;
    std::erase_if(sides, [&](double side) {
      return (block->size - Vector3::Constant(side)).cwiseAbs().maxCoeff() < 0.005;
    });
  }
  return sides;
}

template <class T>
const T& AnyOf(const std::vector<T>& choice, std::mt19937_64* random) {
  return choice[(*random)() % choice.size()];
}

/// Adds blocks that no task uses: alternately of a new color, and of a new size with a color of the
/// scene.
/// @returns their indices.
std::vector<std::size_t> AddDistractors(std::uint64_t seed, const std::vector<std::size_t>& loose,
                                        scene::SceneSpec* scene) {
  // Colors and sides that the task does not use, before anything is added: a distractor differs
  // from all objects in color or in size.
  const std::vector<Color> colors = StrangeColors(*scene);
  const std::vector<double> sides = StrangeSides(*scene);
  std::vector<std::size_t> added;
  for (int i = 0; i < kNumDistractors; ++i) {
    const std::string id = FreeId(*scene, "Distractor" + std::to_string(i + 1));
    std::mt19937_64 random = StreamOf(seed, 0, id);
    // Alternately; if a scene uses all sizes or all colors, the other kind takes over.
    const bool is_strange_color = sides.empty() || (i % 2 == 0 && !colors.empty());
    const double side = is_strange_color ? scene::kMetersPerUnit : AnyOf(sides, &random);
    const Color color =
        is_strange_color && !colors.empty()
            ? AnyOf(colors, &random)
            : scene::SolidsOf(scene->objects[AnyOf(loose, &random)].whole).front().color;
    added.push_back(scene->objects.size());
    scene->objects.push_back({.whole = {.id = id,
                                        .X_PE = RigidTransform(Vector3(0, 0, side / 2)),
                                        .color = color,
                                        .shape = scene::Block{Vector3::Constant(side)}},
                              .descriptions = {{"shape", "block"}}});
  }
  return added;
}

/// Conditions for the places of an attempt.
struct LayoutRules {
  scene::TableSpec table;
  LayoutRegion region;
  std::vector<Footprint> obstacles;
  double gap = kFingerGap;
  bool keeps_strip_free = true;
};

/// Returns true if a footprint, grown by the rim, does not fit into the region reduced by it.
bool IsAtRim(const LayoutRules& rules, const Footprint& footprint, double top) {
  // Smaller reach and a grown footprint together: near the boundary of the arm's circle, of the
  // table, or of the picture.
  const LayoutRegion inner = rules.region.ShrunkBy(kRim);
  Footprint grown = footprint;
  grown.half_size.array() += kRim;
  return !inner.Holds(rules.table, grown, top);
}

/// Returns true if the robot reaches the center of each member: a row may be longer than the margin
/// of the arm.
bool AreMembersReached(const LayoutRules& rules, const ObjectGroup& group, const Footprint& place) {
  const Eigen::Rotation2Dd R_WK(DegreesToRadians(place.yaw_deg));
  return std::ranges::all_of(group.members, [&](const GroupMember& member) {
    return rules.region.Reaches(rules.table, place.center + R_WK * member.center);
  });
}

bool IsFree(const LayoutRules& rules, const std::vector<Footprint>& taken,
            const Footprint& footprint) {
  const auto is_near = [&](const Footprint& other) {
    // A cheap test first: most circles about the footprints are apart.
    const double most = other.half_size.norm() + footprint.half_size.norm() + rules.gap;
    return (other.center - footprint.center).squaredNorm() < most * most &&
           GapBetween(other, footprint) < rules.gap;
  };
  if (std::ranges::any_of(taken, is_near)) return false;
  if (std::ranges::any_of(rules.obstacles, is_near)) return false;
  return !rules.keeps_strip_free || rules.region.strip_half_width == 0 ||
         GapBetween(rules.region.StripOn(rules.table), footprint) > 0;
}

/// Returns a random pose in whole millimeters and tenths of a degree, so that files stay readable.
Footprint Somewhere(const LayoutRules& rules, const Vector2& half_size, std::mt19937_64* random) {
  const LayoutRegion& region = rules.region;
  const double edge = -rules.table.y_span / 2;
  // The rectangle about the region from which places are drawn.
  double most_x = region.most_x, far = region.most_depth;
  if (!region.reach_map) {
    most_x = std::min(most_x, region.shoulder_x + region.reach);
    far = std::min(far, region.shoulder_depth + region.reach);
  }
  const auto rounded = [](double value, double parts) { return std::round(value * parts) / parts; };
  return {.center = {rounded(Uniform(random, -most_x, most_x), 1000),
                     rounded(edge + Uniform(random, region.least_depth, far), 1000)},
          .yaw_deg = rounded(Uniform(random, -180, 180), 10),
          .half_size = half_size};
}

/// Returns a place for each group, or for as many as fit, in order.
std::vector<Footprint> PlacesFor(const scene::SceneSpec& scene,
                                 const std::vector<ObjectGroup>& groups, const LayoutRules& rules,
                                 bool has_edges, std::uint64_t seed, std::uint64_t attempt) {
  std::vector<Footprint> taken;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const ObjectGroup& group = groups[k];
    // By the first member's id, so that other groups do not shift the numbers of this one.
    std::mt19937_64 random =
        StreamOf(seed, attempt, scene.objects[group.members.front().object].id());
    // Every second group.
    const bool is_for_rim = has_edges && k % 2 == 0;
    bool is_placed = false;
    for (int i = 0; i < kTries && !is_placed; ++i) {
      const Footprint place = Somewhere(rules, group.half_size, &random);
      is_placed = rules.region.Holds(rules.table, place, group.top) &&
                  AreMembersReached(rules, group, place) &&
                  (!is_for_rim || IsAtRim(rules, place, group.top)) && IsFree(rules, taken, place);
      if (is_placed) taken.push_back(place);
    }
    // The attempt has failed; how far it came names the culprit in the message.
    if (!is_placed) break;
  }
  return taken;
}

/// Moves the objects of a group to its place.
void Put(const ObjectGroup& group, const Footprint& place, scene::SceneSpec* scene) {
  const RigidTransform X_WK(RotationFromFixedAxes({0, 0, place.yaw_deg}),
                            Vector3(place.center.x(), place.center.y(), 0));
  for (const GroupMember& member : group.members) {
    const Vector3 angles_deg = member.angles_deg + Vector3(0, 0, place.yaw_deg);
    scene->objects[member.object].whole.X_PE =
        RigidTransform(RotationFromFixedAxes(angles_deg), X_WK * member.p_KB);
  }
}

}  // namespace

double HeightOfLooseObjects(const scene::SceneSpec& scene) {
  double height = 0;
  for (const std::size_t i : LooseObjects(scene)) {
    const scene::ObjectSpec& object = scene.objects[i];
    const std::vector<scene::Solid> solids = scene::SolidsOf(object.whole);
    height = std::max(height, scene::BoundsOf(solids, object.pose_in_world()).high.z());
  }
  return height;
}

scene::SceneSpec RandomLayout(scene::SceneSpec scene, std::uint64_t seed, LayoutLevel level,
                              const LayoutRegion& region) {
  const std::vector<std::size_t> loose = LooseObjects(scene);
  const bool has_moving_fixtures = level == LayoutLevel::kFixtures && !scene.objects.empty();
  if (has_moving_fixtures) MoveFixtures(seed, loose, region, &scene);
  const std::vector<ObjectGroup> piles =
      level == LayoutLevel::kPiles ? PilesOf(scene) : std::vector<ObjectGroup>();
  if (loose.empty() && piles.empty() && !has_moving_fixtures) {
    throw std::invalid_argument(
        "layout: no object in '" + scene.name +
        "' stands loose on the table, so no object can be moved; the levels "
        "fixtures and piles move others");
  }
  // Obstacles are computed before distractors are added: those are placed like all loose objects.
  std::vector<std::size_t> moved = loose;
  for (const ObjectGroup& pile : piles) {
    for (const GroupMember& member : pile.members) moved.push_back(member.object);
  }
  LayoutRules rules{.table = scene.table, .region = region, .obstacles = ObstaclesOf(scene, moved)};
  std::vector<ObjectGroup> groups = ObjectGroupsOf(scene, loose, seed, level);
  groups.insert(groups.begin(), piles.begin(), piles.end());
  if (HasDistractors(level)) {
    for (std::size_t i : AddDistractors(seed, loose, &scene)) {
      groups.push_back(ObjectGroupsOf(scene, {i}, seed, LayoutLevel::kScattered).front());
    }
  }

  // Relax one rule at a time: the distance first, then the free strip.
  std::uint64_t attempt = 0;
  std::size_t most_placed = 0;
  for (bool keeps_strip_free : {true, false}) {
    rules.keeps_strip_free = keeps_strip_free;
    for (double gap : kGaps) {
      rules.gap = gap;
      for (int i = 0; i < kAttempts; ++i, ++attempt) {
        const std::vector<Footprint> places =
            PlacesFor(scene, groups, rules, HasEdges(level), seed, attempt);
        most_placed = std::max(most_placed, places.size());
        if (places.size() < groups.size()) continue;
        for (std::size_t k = 0; k < groups.size(); ++k) Put(groups[k], places[k], &scene);
        return scene;
      }
    }
  }
  throw std::invalid_argument("layout: there is no room for '" +
                              scene.objects[groups[most_placed].members.front().object].id() +
                              "' beside " + std::to_string(most_placed) +
                              " others within the robot's reach");
}

}  // namespace smile::layout

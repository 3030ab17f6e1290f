// Decides what may be moved and what moves together. All random numbers come from streams named
// after what they decide (StreamOf()), so an object that is added to a scene changes no decision
// about the others.

#include "layout/internal_object_group.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "base/state_hash.h"
#include "base/uniform.h"
#include "math/angles.h"
#include "scene/bounds.h"
#include "scene/controls_of.h"
#include "scene/solid.h"

namespace smile::layout {
namespace {

/// Objects closer than this touch [m].
constexpr double kTouching = 0.0005;
/// Distance of blocks in contact, so that physics finds them beside each other and not inside [m].
constexpr double kContactGap = 0.0002;
/// Greatest offset and rotation of the upper block of a stack.
constexpr double kMostOffset = 0.01, kMostTurnDeg = 20;  // [m], [degrees]

/// Collects the hosts of guests that are fastened from the start.
void NoteBonds(const scene::Part& part, std::set<std::string>* hosts, bool* has_fastened_guest) {
  const auto* composite = std::get_if<scene::Composite>(&part.shape);
  if (!composite) return;
  for (const scene::GuestPoint& guest : composite->guests) {
    if (guest.initial_tightness == 0) continue;
    hosts->insert(guest.initial_host);
    *has_fastened_guest = true;
  }
  for (const scene::Part& child : composite->parts) NoteBonds(child, hosts, has_fastened_guest);
}

/// Returns true if a part, or one inside it, has one of these hosts.
bool HasHost(const scene::Part& part, const std::set<std::string>& hosts) {
  const auto* composite = std::get_if<scene::Composite>(&part.shape);
  if (!composite) return false;
  return std::ranges::any_of(composite->hosts,
                             [&](const auto& host) { return hosts.contains(host.id); }) ||
         std::ranges::any_of(composite->parts,
                             [&](const auto& child) { return HasHost(child, hosts); });
}

/// Returns which of the scene's objects belong to a mechanism: slider, chain, fastened bond, or
/// controls.
std::vector<bool> PartsOfMechanisms(const scene::SceneSpec& scene) {
  std::vector<bool> is_part(scene.objects.size());
  for (const scene::SliderSpec& slider : scene.sliders) {
    is_part[slider.first_object] = is_part[slider.first_object + 1] = true;
  }
  // A chain has two objects more than links.
  for (const scene::ChainSpec& chain : scene.chains) {
    for (std::size_t i = 0; i < chain.link_ids.size() + 2; ++i) {
      is_part[chain.first_object + i] = true;
    }
  }
  // Two passes, as a guest may come before its host in the file: first the guests that are fastened
  // and the ids of their hosts, then the objects that have these hosts.
  std::set<std::string> hosts;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    bool has_fastened_guest = false;
    NoteBonds(scene.objects[i].whole, &hosts, &has_fastened_guest);
    if (has_fastened_guest || !scene::ControlsOf(scene.objects[i].whole).empty()) {
      is_part[i] = true;
    }
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (HasHost(scene.objects[i].whole, hosts)) is_part[i] = true;
  }
  return is_part;
}

scene::Bounds BoundsInWorld(const scene::ObjectSpec& object) {
  return scene::BoundsOf(scene::SolidsOf(object.whole), object.pose_in_world());
}

/// Returns true if two objects touch: by their boxes, then by their footprints.
bool DoTouch(const scene::ObjectSpec& a, const scene::ObjectSpec& b) {
  const scene::Bounds bounds_a = BoundsInWorld(a), bounds_b = BoundsInWorld(b);
  return !bounds_a.is_empty() && !bounds_b.is_empty() && bounds_a.Meets(bounds_b, kTouching) &&
         GapBetween(FootprintOf(a, a.pose_in_world()), FootprintOf(b, b.pose_in_world())) <
             kTouching;
}

/// Returns a group of one object, as it stands but with a yaw of 0.
ObjectGroup Alone(const scene::SceneSpec& scene, std::size_t i) {
  const scene::ObjectSpec& object = scene.objects[i];
  Vector3 angles_deg = FixedAxesAngles(object.pose_in_world().rotation());
  angles_deg.z() = 0;
  // The tilt and the height stay: an object that lies on its side stays so.
  const double z = object.pose_in_world().translation().z();
  const RigidTransform X_KB(RotationFromFixedAxes(angles_deg), Vector3(0, 0, z));
  const scene::Bounds bounds = scene::BoundsOf(scene::SolidsOf(object.whole), X_KB);
  // The group's frame is at the center of the footprint, not at the object's origin.
  const Vector3 center = bounds.center();
  return {.members = {{.object = i,
                       .p_KB = Vector3(-center.x(), -center.y(), z),
                       .angles_deg = angles_deg}},
          .half_size = bounds.size().head<2>() / 2,
          .top = bounds.high.z()};
}

/// Returns a group of these objects as they stand, its frame along the axes of the table.
ObjectGroup AsTheyStand(const scene::SceneSpec& scene, const std::vector<std::size_t>& objects) {
  scene::Bounds bounds;
  for (const std::size_t i : objects) bounds.Add(BoundsInWorld(scene.objects[i]));
  const Vector2 middle = bounds.center().head<2>();
  ObjectGroup group{.half_size = bounds.size().head<2>() / 2, .top = bounds.high.z()};
  for (const std::size_t i : objects) {
    const RigidTransform X_WB = scene.objects[i].pose_in_world();
    const Vector2 center = BoundsInWorld(scene.objects[i]).center().head<2>();
    group.members.push_back({.object = i,
                             .p_KB = X_WB.translation() - Vector3(middle.x(), middle.y(), 0),
                             .angles_deg = FixedAxesAngles(X_WB.rotation()),
                             .center = center - middle});
  }
  return group;
}

/// Returns a row of the groups, side by side along x, in contact.
ObjectGroup Row(const std::vector<ObjectGroup>& alone) {
  ObjectGroup row;
  for (const ObjectGroup& one : alone) row.half_size.x() += one.half_size.x();
  // Half of all gaps between the members.
  row.half_size.x() += kContactGap * static_cast<double>(alone.size() - 1) / 2;
  double x = -row.half_size.x();
  for (const ObjectGroup& one : alone) {
    GroupMember member = one.members.front();
    member.p_KB.x() += x + one.half_size.x();
    member.center.x() = x + one.half_size.x();
    row.members.push_back(member);
    row.half_size.y() = std::max(row.half_size.y(), one.half_size.y());
    row.top = std::max(row.top, one.top);
    x += 2 * one.half_size.x() + kContactGap;
  }
  return row;
}

/// Returns a stack of two groups, the upper one slightly displaced and rotated.
ObjectGroup Stack(const ObjectGroup& lower, const ObjectGroup& upper, std::mt19937_64* random) {
  // Whole degrees keep scene files readable. The order of these three draws is part of each layout.
  const double yaw_deg = std::round(Uniform(random, -kMostTurnDeg, kMostTurnDeg));
  const Vector2 offset(Uniform(random, -kMostOffset, kMostOffset),
                       Uniform(random, -kMostOffset, kMostOffset));
  ObjectGroup stack = lower;
  GroupMember member = upper.members.front();
  const RigidTransform X_KU(RotationFromFixedAxes({0, 0, yaw_deg}),
                            Vector3(offset.x(), offset.y(), lower.top));
  member.p_KB = X_KU * member.p_KB;
  member.angles_deg.z() = yaw_deg;
  member.center = offset;
  stack.members.push_back(member);
  stack.top += upper.top;
  for (const Vector2& corner :
       Footprint{.center = offset, .yaw_deg = yaw_deg, .half_size = upper.half_size}.corners()) {
    // The footprint stays centered at the lower block and also covers the upper one.
    stack.half_size = stack.half_size.cwiseMax(corner.cwiseAbs());
  }
  return stack;
}

bool IsBlock(const scene::ObjectSpec& object) {
  return std::holds_alternative<scene::Block>(object.whole.shape);
}

/// Returns the indices of the groups in `alone` that are blocks of the most frequent size, in an
/// order that the seed shuffles.
std::vector<std::size_t> EqualBlocks(const scene::SceneSpec& scene,
                                     const std::vector<ObjectGroup>& alone, std::uint64_t seed) {
  // Equal within rounding: sizes come from decimal numbers in a file.
  std::vector<std::size_t> most;
  for (const ObjectGroup& model : alone) {
    std::vector<std::size_t> equals;
    for (std::size_t i = 0; i < alone.size(); ++i) {
      if (IsBlock(scene.objects[alone[i].members.front().object]) &&
          (alone[i].half_size - model.half_size).cwiseAbs().maxCoeff() < 1e-6 &&
          std::abs(alone[i].top - model.top) < 1e-6) {
        equals.push_back(i);
      }
    }
    if (equals.size() > most.size()) most = equals;
  }
  // Shuffle by a random key per id, so that another object in the scene does not change the order
  // of these.
  std::vector<std::pair<std::uint64_t, std::size_t>> keyed;
  for (std::size_t i : most) {
    const std::string& id = scene.objects[alone[i].members.front().object].id();
    keyed.emplace_back(StreamOf(seed, 0, "order of " + id)(), i);
  }
  std::ranges::sort(keyed);
  for (std::size_t i = 0; i < keyed.size(); ++i) most[i] = keyed[i].second;
  return most;
}

/// Numbers of rows and stacks that equal blocks are grouped into.
struct GroupCounts {
  std::size_t rows = 0, stacks = 0;
};
/// Returns the counts for a level: about half of the blocks are grouped.
GroupCounts CountsFor(LayoutLevel level, std::size_t num_blocks) {
  if (num_blocks < 2) return {};
  // Groups of two: a quarter as many groups as blocks, rounded, uses about half of the blocks.
  const std::size_t count = (num_blocks + 2) / 4;
  if (level == LayoutLevel::kTouching) return {.rows = count};
  if (level == LayoutLevel::kStacked) return {.stacks = count};
  if (level == LayoutLevel::kMixed) return {.rows = count / 2, .stacks = (count + 1) / 2};
  return {};
}

double AreaOf(const ObjectGroup& group) { return group.half_size.x() * group.half_size.y(); }

}  // namespace

std::mt19937_64 StreamOf(std::uint64_t seed, std::uint64_t attempt, std::string_view name) {
  StateHash hash;
  hash.Add(seed);
  hash.Add(attempt);
  hash.Add(name);
  return std::mt19937_64(hash.value());
}

std::vector<std::size_t> LooseObjects(const scene::SceneSpec& scene) {
  const std::vector<bool> is_part = PartsOfMechanisms(scene);
  std::vector<std::size_t> loose;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::ObjectSpec& object = scene.objects[i];
    if (object.is_static() || is_part[i]) continue;
    // On the table and touching nothing: what stands on or leans against something would fall when
    // it is moved alone.
    const scene::Bounds bounds = BoundsInWorld(object);
    if (bounds.is_empty() || std::abs(bounds.low.z()) > kTouching) continue;
    const bool is_touched = std::ranges::any_of(scene.objects, [&](const auto& other) {
      return &other != &object && DoTouch(object, other);
    });
    if (!is_touched) loose.push_back(i);
  }
  return loose;
}

std::vector<ObjectGroup> PilesOf(const scene::SceneSpec& scene) {
  const std::vector<bool> is_part = PartsOfMechanisms(scene);
  // Piles grow object by object, each named after its first object.
  std::vector<std::size_t> names(scene.objects.size());
  std::vector<bool> is_bound(scene.objects.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = i;
    is_bound[i] = scene.objects[i].is_static() || is_part[i];
    for (std::size_t k = 0; k < i; ++k) {
      if (!DoTouch(scene.objects[i], scene.objects[k])) continue;
      const auto [low, high] = std::minmax(names[i], names[k]);
      const std::size_t to = low, from = high;
      std::ranges::replace(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i) + 1, from,
                           to);
    }
  }
  std::vector<std::vector<std::size_t>> members(names.size());
  std::vector<bool> is_pile_bound(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    members[names[i]].push_back(i);
    if (is_bound[i]) is_pile_bound[names[i]] = true;
  }
  std::vector<ObjectGroup> piles;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].size() < 2 || is_pile_bound[i]) continue;
    // What hangs in the air, or lies on the floor, stays.
    double lowest = 1;
    for (const std::size_t object : members[i]) {
      lowest = std::min(lowest, BoundsInWorld(scene.objects[object]).low.z());
    }
    if (std::abs(lowest) <= kTouching) piles.push_back(AsTheyStand(scene, members[i]));
  }
  return piles;
}

std::vector<ObjectGroup> ObjectGroupsOf(const scene::SceneSpec& scene,
                                        const std::vector<std::size_t>& objects, std::uint64_t seed,
                                        LayoutLevel level) {
  std::vector<ObjectGroup> alone, groups;
  for (std::size_t i : objects) alone.push_back(Alone(scene, i));
  std::vector<std::size_t> blocks = EqualBlocks(scene, alone, seed);
  std::vector<bool> is_used(alone.size());
  const auto take = [&] {
    const std::size_t i = blocks.back();
    blocks.pop_back();
    is_used[i] = true;
    return alone[i];
  };

  // The name of the stream must stay: another one would change the layout of each seed.
  std::mt19937_64 random = StreamOf(seed, 0, "clumps");
  const GroupCounts counts = CountsFor(level, blocks.size());
  for (std::size_t k = 0; k < counts.stacks && blocks.size() >= 2; ++k) {
    const ObjectGroup lower = take();
    groups.push_back(Stack(lower, take(), &random));
  }
  for (std::size_t k = 0; k < counts.rows && blocks.size() >= 2; ++k) {
    std::vector<ObjectGroup> row{take(), take()};
    // A third block only if two remain for each further row.
    const std::size_t spare = blocks.size() - std::min(blocks.size(), 2 * (counts.rows - k - 1));
    if (spare > 0 && Uniform(&random, 0, 1) < 0.3) row.push_back(take());
    groups.push_back(Row(row));
  }
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (!is_used[i]) groups.push_back(alone[i]);
  }
  // Large groups are harder to place, so they come first; the margin ignores rounding.
  std::ranges::stable_sort(groups, [](const ObjectGroup& a, const ObjectGroup& b) {
    return AreaOf(a) > AreaOf(b) + 1e-9;
  });
  return groups;
}

}  // namespace smile::layout

// Two kinds of input are checked here: definitions from callers, and whole snapshots, which may
// come from files that are not trusted.

#include "mechanics/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace smile::mechanics {
namespace {

bool IsFinite(const RigidTransform& X) {
  return X.rotation().allFinite() && X.translation().allFinite();
}

/// Checks a fraction from 0 to 1.
void CheckShare(double share, const char* name) {
  if (share >= 0 && share <= 1) return;
  throw std::invalid_argument("joint: " + std::string(name) + " is " + std::to_string(share) +
                              ", expected 0 to 1");
}

/// Check the numbers of each kind of joint.
void CheckNumbers(const WeldSpec& weld) {
  if (!IsFinite(weld.X_LB)) throw std::invalid_argument("joint: its frame is not finite");
  if (!(weld.holds_up >= 0)) {
    throw std::invalid_argument("joint: holds up " + std::to_string(weld.holds_up) +
                                " kg, expected at least 0");
  }
}
void CheckNumbers(const FixedJointSpec& fixed) {
  if (!IsFinite(fixed.X_AB)) throw std::invalid_argument("joint: its frame is not finite");
}
void CheckNumbers(const BallJointSpec& ball) {
  if (ball.p_AQ.allFinite() && ball.p_BQ.allFinite()) return;
  throw std::invalid_argument("joint: its point is not finite");
}
void CheckNumbers(const SliderJointSpec& slider) {
  if (!IsFinite(slider.X_AJ) || !IsFinite(slider.X_BK)) {
    throw std::invalid_argument("joint: its frame is not finite");
  }
  if (!std::isfinite(slider.lower) || !std::isfinite(slider.upper) || slider.lower > slider.upper) {
    throw std::invalid_argument("joint: limits are " + std::to_string(slider.lower) + " and " +
                                std::to_string(slider.upper) + ", expected the lower first");
  }
  CheckShare(slider.damping, "damping");
  CheckShare(slider.restitution, "restitution");
  CheckShare(slider.softness, "softness");
}

/// Checks the number of a link, from `least` (0, or -1 for the base) to below `num_links`.
void CheckLink(int link, int least, int num_links) {
  if (link >= least && link < num_links) return;
  throw std::invalid_argument("joint: link " + std::to_string(link) + " does not exist, expected " +
                              std::to_string(least) + " to " + std::to_string(num_links - 1));
}

/// Throws unless the condition holds.
void DemandOfSnapshot(bool holds, const char* complaint) {
  if (!holds) throw std::invalid_argument("snapshot: " + std::string(complaint));
}

template <class Records, class Id>
const auto& Find(const Records& records, Id id, const char* complaint) {
  const auto found = std::lower_bound(records.begin(), records.end(), id,
                                      [](const auto& record, Id key) { return record.id < key; });
  DemandOfSnapshot(found != records.end() && found->id == id, complaint);
  return *found;
}

/// Returns true if ids are strictly ascending, so also unique.
template <class Records>
bool IsAscending(const Records& records) {
  return std::adjacent_find(records.begin(), records.end(), [](const auto& a, const auto& b) {
           return !(a.id < b.id);
         }) == records.end();
}

/// Checks that no two objects share an id. Bodies and links share one counter.
/// @param unknown  indices of the bodies that are not known to be sound.
void CheckIds(const Snapshot& snapshot, std::span<const std::size_t> unknown) {
  // Ids are stored as Bullet's user index, an int.
  DemandOfSnapshot(snapshot.next_id <= std::numeric_limits<int>::max(), "its next id is too large");
  const auto& bodies = snapshot.bodies;
  const bool are_bodies_in_order = std::ranges::all_of(unknown, [&bodies](std::size_t i) {
    return (i == 0 || bodies[i - 1].id < bodies[i].id) &&
           (i + 1 == bodies.size() || bodies[i].id < bodies[i + 1].id);
  });
  DemandOfSnapshot(
      are_bodies_in_order && IsAscending(snapshot.articulations) && IsAscending(snapshot.joints),
      "its bodies, robots or joints are not in the order of their ids");
  // Ids begin at 1. The counter must be above all of them, or a new object would get a used one.
  const auto demand_assigned = [&snapshot](std::uint64_t first, std::uint64_t end) {
    DemandOfSnapshot(first > 0 && end <= snapshot.next_id, "an id was never assigned");
  };
  if (!bodies.empty()) demand_assigned(bodies.front().id.value, bodies.back().id.value + 1ull);
  std::uint64_t free = 0;  // ids from here on belong to no robot so far
  for (const auto& [id, spec] : snapshot.articulations) {
    DemandOfSnapshot(spec != nullptr, "a robot is missing");
    const std::uint64_t end = id.value + std::uint64_t{spec->links.size()} + 1;
    demand_assigned(id.value, end);
    const auto body =
        std::lower_bound(bodies.begin(), bodies.end(), BodyId{id.value},
                         [](const auto& entry, BodyId key) { return entry.id < key; });
    DemandOfSnapshot(id.value >= free && (body == bodies.end() || body->id.value >= end),
                     "two objects have the same id");
    free = end;
  }
  if (snapshot.joints.empty()) return;
  DemandOfSnapshot(snapshot.joints.front().id.value > 0 &&
                       snapshot.joints.back().id.value < snapshot.next_joint_id,
                   "a joint's id was never assigned");
}

}  // namespace

void CheckBody(const BodySpec& spec) {
  if (!IsFinite(spec.X_WB)) throw std::invalid_argument("body: its pose is not finite");
  if (!(spec.mass.mass >= 0) || !std::isfinite(spec.mass.mass) || !spec.mass.inertia.allFinite() ||
      !spec.mass.center.allFinite()) {
    throw std::invalid_argument("body: mass is " + std::to_string(spec.mass.mass) +
                                " kg, expected at least 0");
  }
  if (spec.angular_damping && !(*spec.angular_damping >= 0 && *spec.angular_damping <= 1)) {
    throw std::invalid_argument("body: angular damping is " +
                                std::to_string(*spec.angular_damping) + ", expected 0 to 1");
  }
}

void CheckArticulation(const scene::ArticulationSpec& spec) {
  const int count = static_cast<int>(spec.links.size());
  // A parent comes before its children, so link trees have no cycles.
  bool is_sound = IsFinite(spec.X_WBase);
  for (int i = 0; i < count; ++i) {
    const scene::LinkSpec& link = spec.links[i];
    // Mass and friction are tested by comparisons that are false for NaN.
    is_sound = is_sound && link.parent >= -1 && link.parent < i && IsFinite(link.X_PJ) &&
               link.axis.allFinite() && link.p_LLcm.allFinite() && link.inertia.allFinite() &&
               std::isfinite(link.mass) && link.mass > 0 && std::isfinite(link.friction) &&
               link.friction >= 0;
    if (!link.mimic) continue;
    const scene::Mimic& mimic = *link.mimic;
    // A leader that follows no joint itself: there are no chains and no loops.
    is_sound = is_sound && mimic.leader >= 0 && mimic.leader < count && mimic.leader != i &&
               !spec.links[mimic.leader].mimic && std::isfinite(mimic.multiplier) &&
               mimic.multiplier != 0 && std::isfinite(mimic.offset);
  }
  for (const auto& [a, b] : spec.never_collide) {
    // -1 is the base.
    is_sound = is_sound && a >= -1 && b >= -1 && a < count && b < count;
  }
  DemandOfSnapshot(is_sound, "the links of a robot are inconsistent");
}

void CheckJoint(const JointSpec& spec, const std::function<bool(BodyId)>& is_static,
                const std::function<int(ArticulationId)>& num_links) {
  std::visit([](const auto& joint) { CheckNumbers(joint); }, spec);
  if (const auto* weld = std::get_if<WeldSpec>(&spec)) {
    const int count = num_links(weld->articulation);
    CheckLink(weld->link, 0, count);
    for (int link : weld->links_not_colliding) CheckLink(link, -1, count);  // -1 is the base
    if (is_static(weld->body)) {
      throw std::invalid_argument("joint: body " + std::to_string(weld->body.value) +
                                  " is static, it can't be held");
    }
    return;
  }
  const auto [a, b] = *BodyPairOf(spec);
  if (a == b) throw std::invalid_argument("joint: it joins a body with itself");
  const bool is_a_static = is_static(a), is_b_static = is_static(b);  // both must exist
  if (is_a_static && is_b_static) {
    throw std::invalid_argument("joint: both its bodies are static");
  }
}

void CheckSnapshot(const Snapshot& snapshot, const SharedList<Snapshot::BodyEntry>& known) {
  const std::vector<std::size_t> unknown = snapshot.bodies.MayDifferFrom(known);
  CheckIds(snapshot, unknown);
  const auto find_body = [&snapshot](BodyId id) {
    return Find(snapshot.bodies, id, "a joint is of an unknown body").spec;
  };
  // Ids are sound from here on, so bodies and articulations can be looked up.
  for (const std::size_t i : unknown) {
    const Snapshot::BodyEntry& body = snapshot.bodies[i];
    DemandOfSnapshot(body.spec != nullptr && body.state != nullptr, "a body is missing");
  }
  for (const Joint& joint : snapshot.joints) {
    CheckJoint(
        joint.spec, [&find_body](BodyId id) { return find_body(id)->mass.mass == 0; },
        [&snapshot](ArticulationId id) {
          const auto& record = Find(snapshot.articulations, id, "a weld is to an unknown robot");
          return static_cast<int>(record.spec->links.size());
        });
  }
  for (const auto* pairs : {&snapshot.passing, &snapshot.close_fits}) {
    for (const auto& [a, b] : *pairs) {
      DemandOfSnapshot(a != b, "a body passes through itself");
      find_body(a);
      find_body(b);
    }
  }
  DemandOfSnapshot(std::ranges::is_sorted(snapshot.close_fits), "its close fits are not sorted");
}

}  // namespace smile::mechanics

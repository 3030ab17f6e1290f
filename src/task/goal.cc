#include "task/goal.h"

#include <algorithm>
#include <limits>
#include <set>

#include "base/diagnostic.h"
#include "base/overloaded.h"
#include "record/trace_reader.h"
#include "scene/solid.h"

namespace smile::task {
namespace {

/// One thing stands on another when their surfaces are this near [m].
constexpr double kStanding = 0.01;

/// Axis-aligned bounds in the world.
struct Bounds {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
};

Vector3 HalfExtentsOf(const scene::Block& block) { return block.size / 2; }
Vector3 HalfExtentsOf(const scene::Cylinder& cylinder) {
  return {cylinder.radius, cylinder.length / 2, cylinder.radius};
}
Vector3 HalfExtentsOf(const scene::Sphere& sphere) { return Vector3::Constant(sphere.radius); }

template <class Shape>
void Extend(const Shape& shape, const RigidTransform& X_WS, Bounds* bounds) {
  const Vector3 reach = X_WS.rotation().cwiseAbs() * HalfExtentsOf(shape);
  bounds->low = bounds->low.cwiseMin(X_WS.translation() - reach);
  bounds->high = bounds->high.cwiseMax(X_WS.translation() + reach);
}

void Extend(const scene::Hull& hull, const RigidTransform& X_WS, Bounds* bounds) {
  for (const Vector3& p_SQ : hull.polyhedron().corners) {
    const Vector3 p_WQ = X_WS * p_SQ;
    bounds->low = bounds->low.cwiseMin(p_WQ);
    bounds->high = bounds->high.cwiseMax(p_WQ);
  }
}

Bounds BoundsOf(const scene::ObjectSpec& object) {
  Bounds bounds;
  for (const scene::Solid& solid : scene::SolidsOf(object.whole)) {
    const RigidTransform X_WS = object.pose_in_world() * solid.X_BS;
    std::visit([&](const auto& shape) { Extend(shape, X_WS, &bounds); }, solid.shape);
  }
  return bounds;
}

bool StandsOn(const Bounds& upper, const Bounds& lower) {
  return std::abs(upper.low.z() - lower.high.z()) < kStanding && upper.low.x() < lower.high.x() &&
         lower.low.x() < upper.high.x() && upper.low.y() < lower.high.y() &&
         lower.low.y() < upper.high.y();
}

/// What was moved, and everything below it down to the table.
std::set<std::string> WithSupports(std::set<std::string> ids,
                                   const std::vector<scene::ObjectSpec>& objects) {
  std::vector<Bounds> bounds;
  for (const scene::ObjectSpec& object : objects) bounds.push_back(BoundsOf(object));
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t upper = 0; upper < objects.size(); ++upper) {
      if (!ids.contains(objects[upper].id())) continue;
      for (std::size_t lower = 0; lower < objects.size(); ++lower) {
        if (lower == upper || !StandsOn(bounds[upper], bounds[lower])) continue;
        has_grown = ids.insert(objects[lower].id()).second || has_grown;
      }
    }
  }
  return ids;
}

/// What an object looks like, apart from where it is and what it is called.
std::vector<scene::Solid> LooksOf(const scene::ObjectSpec& object) {
  std::vector<scene::Solid> solids = scene::SolidsOf(object.whole);
  for (scene::Solid& solid : solids) solid.part_id.clear();
  return solids;
}

}  // namespace

Goal GoalOf(const record::Recording& demonstration) {
  record::TraceReader trace(demonstration);
  std::vector<scene::ObjectSpec> objects = demonstration.scene.objects;
  std::set<std::string> destroyed, moved;
  const auto note = [&moved](const std::vector<sim::Event>& events) {
    for (const sim::Event& event : events) {
      const bool moves = event.kind == sim::EventKind::kGrasped ||
                         event.kind == sim::EventKind::kFastened ||
                         event.kind == sim::EventKind::kLoosened;
      if (moves && event.hand) moved.insert(event.object);
    }
  };
  note(trace.events_before_start());
  while (const auto moment = trace.Next()) {
    note(moment->events);
    destroyed.clear();
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (!moment->objects[i].is_present) destroyed.insert(objects[i].id());
      objects[i].whole.X_PE = moment->objects[i].pose_in_world();
    }
  }
  std::erase_if(objects, [&](const auto& object) { return destroyed.contains(object.id()); });
  // The traces of old recordings have no events.
  for (const record::LoggedCommand& logged : demonstration.commands) {
    std::visit(Overloaded{[&](const sim::Grasp& grasp) { moved.insert(grasp.object); },
                          [&](const sim::Fasten& fasten) { moved.insert(fasten.object); },
                          [&](const sim::Loosen& loosen) { moved.insert(loosen.object); },
                          [](const auto&) {}},
               logged.command);
  }

  const std::set<std::string> ids = WithSupports(std::move(moved), objects);
  std::erase_if(objects, [&ids](const auto& object) { return !ids.contains(object.id()); });
  if (objects.empty()) {
    throw InputError({demonstration.directory.string(), 0, "",
                      "no hand moved anything in this recording that is still there, so there is "
                      "nothing to imitate"});
  }
  return {std::move(objects)};
}

std::map<std::string, std::string> MatchObjects(const Goal& goal, const scene::SceneSpec& scene) {
  std::map<std::string, std::string> match;
  std::set<std::string> taken;
  const auto take = [&](const scene::ObjectSpec& wanted, bool same_id) {
    for (const scene::ObjectSpec& object : scene.objects) {
      if (match.contains(wanted.id()) || taken.contains(object.id())) continue;
      if (same_id && object.id() != wanted.id()) continue;
      if (LooksOf(object) != LooksOf(wanted)) continue;
      match[wanted.id()] = object.id();
      taken.insert(object.id());
    }
  };
  for (const scene::ObjectSpec& wanted : goal.objects) take(wanted, /*same_id=*/true);
  for (const scene::ObjectSpec& wanted : goal.objects) take(wanted, /*same_id=*/false);

  std::vector<Diagnostic> findings;
  for (const scene::ObjectSpec& wanted : goal.objects) {
    if (match.contains(wanted.id())) continue;
    findings.push_back({scene.name, 0, "",
                        "has nothing that looks like '" + wanted.id() + "' of the demonstration"});
  }
  if (!findings.empty()) throw InputError(std::move(findings));
  return match;
}

}  // namespace smile::task

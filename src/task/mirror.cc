#include "task/mirror.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "task/placing.h"

namespace smile::task {
namespace {

/// A turn beyond this shows another side of a structure [rad].
constexpr double kOtherSide = std::numbers::pi / 2;

/// Returns an episode in which a structure stands as demonstrated, and nothing else does.
Episode StandingAs(const Structure& structure) {
  Episode episode;
  for (const auto* objects : {&structure.objects, &structure.others}) {
    for (const scene::ObjectSpec& object : *objects) {
      episode.scene.objects.push_back(object);
      episode.begin.objects.push_back(
          recording::TracePose::At(object.pose_in_world(), /*is_awake=*/false));
    }
  }
  episode.end = episode.begin;
  return episode;
}

/// Returns true if a structure stands somewhere in an outcome, turned by kOtherSide at most.
bool FitsFromTheSameSide(const Structure& structure, const Episode& outcome, const Match& match) {
  const Placing placing = FindPlacing(structure, outcome, match);
  if (std::abs(placing.turn) > kOtherSide) return false;
  const ObjectPoses poses = PosesAt(outcome.scene, outcome.end);
  return std::ranges::all_of(structure.objects, [&](const scene::ObjectSpec& object) {
    const std::string& id = placing.match.at(object.id());
    return ErrorOf(object, placing.motion * object.pose_in_world(),
                   *std::ranges::find(outcome.scene.objects, id, &scene::ObjectSpec::id),
                   poses.at(id))
        .is_pose_within();
  });
}

}  // namespace

Structure MirrorImageOf(Structure structure) {
  // In a mirror at x = 0. A rotation stays one, since it is mirrored from both sides.
  const Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
  for (scene::ObjectSpec& object : structure.objects) {
    const RigidTransform X_WB = object.pose_in_world();
    object.whole.X_PE =
        RigidTransform(Matrix3(mirror * X_WB.rotation() * mirror), mirror * X_WB.translation());
  }
  return structure;
}

bool IsMirrored(const Structure& structure, const Episode& outcome, const Match& match,
                double turn) {
  if (std::abs(turn) <= kOtherSide) return false;
  const Structure image = MirrorImageOf(structure);
  // A tower is its own mirror image, so its turn means nothing.
  return FitsFromTheSameSide(image, outcome, match) &&
         !FitsFromTheSameSide(image, StandingAs(structure), match);
}

}  // namespace smile::task

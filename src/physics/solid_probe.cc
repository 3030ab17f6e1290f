#include "physics/solid_probe.h"

#include "physics/internal_overlap_probe.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

struct SolidProbe::Parts {
  std::vector<CollisionShape> shapes;
  std::vector<PosedPart> posed;  ///< each shape where it is now
  OverlapProbe probe;
};

SolidProbe::SolidProbe(const std::vector<scene::Solid>& solids)
    : parts_(std::make_unique<Parts>()) {
  for (const scene::Solid& solid : solids) {
    // A shape in its own frame: its pose changes from query to query.
    scene::Solid centered = solid;
    centered.X_BS = {};
    parts_->shapes.push_back(MakeCollisionShape({centered}, {}));
    parts_->posed.emplace_back();
    SetPose(parts_->posed.size() - 1, solid.X_BS);
  }
}

SolidProbe::~SolidProbe() = default;

void SolidProbe::SetPose(std::size_t solid, const RigidTransform& X_WS) {
  PosedPart& part = parts_->posed[solid];
  part.X_WP = ToBullet(X_WS);
  parts_->shapes[solid].shape()->getAabb(part.X_WP, part.min, part.max);
}

double SolidProbe::Depth(std::size_t a, std::size_t b) {
  const PosedPart &one = parts_->posed[a], &other = parts_->posed[b];
  // Most pairs are far apart.
  if (!TestAabbAgainstAabb2(one.min, one.max, other.min, other.max)) return 0;
  return parts_->probe.Depth(parts_->shapes[a].shape(), one.X_WP, parts_->shapes[b].shape(),
                             other.X_WP);
}

}  // namespace smile::physics

#include "physics/solid_probe.h"

#include "physics/internal_overlap_probe.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

struct SolidProbe::Parts {
  std::vector<CollisionShape> shapes;
  std::vector<PosedPart> posed;  ///< each shape where it is now
  OverlapProbe probe;

  void Put(std::size_t solid, const btTransform& X_WS) {
    PosedPart& part = posed[solid];
    part.X_WP = X_WS;
    shapes[solid].shape()->getAabb(X_WS, part.min, part.max);
  }
};

SolidProbe::SolidProbe(const std::vector<scene::Solid>& solids)
    : parts_(std::make_unique<Parts>()) {
  for (const scene::Solid& solid : solids) {
    // A shape in its own frame: its pose changes from query to query.
    scene::Solid centered = solid;
    centered.X_BS = {};
    parts_->shapes.push_back(MakeCollisionShape({centered}, {}));
    parts_->posed.emplace_back();
    parts_->Put(parts_->posed.size() - 1, ToBullet(solid.X_BS));
  }
}

SolidProbe::~SolidProbe() = default;

void SolidProbe::SetPose(std::size_t solid, const RigidTransform& X_WS) {
  parts_->Put(solid, ToBullet(X_WS));
}

double SolidProbe::Depth(std::size_t a, std::size_t b) {
  Parts& parts = *parts_;
  const PosedPart &posed_a = parts.posed[a], &posed_b = parts.posed[b];
  // Most pairs are far apart.
  if (!TestAabbAgainstAabb2(posed_a.min, posed_a.max, posed_b.min, posed_b.max)) return 0;
  return parts.probe.Depth(parts.shapes[a].shape(), posed_a.X_WP, parts.shapes[b].shape(),
                           posed_b.X_WP);
}

}  // namespace smile::physics

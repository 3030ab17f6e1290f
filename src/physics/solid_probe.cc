#include "physics/solid_probe.h"

#include "physics/internal_overlap_probe.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

struct SolidProbe::Parts {
  std::vector<CollisionShape> shapes;
  std::vector<btTransform> X_WS;
  OverlapProbe probe;
};

SolidProbe::SolidProbe(const std::vector<scene::Solid>& solids)
    : parts_(std::make_unique<Parts>()) {
  for (const scene::Solid& solid : solids) {
    // A shape in its own frame: its pose changes from query to query.
    scene::Solid centered = solid;
    centered.X_BS = {};
    parts_->shapes.push_back(MakeCollisionShape({centered}, {}));
    parts_->X_WS.push_back(ToBullet(solid.X_BS));
  }
}

SolidProbe::~SolidProbe() = default;

void SolidProbe::SetPose(std::size_t solid, const RigidTransform& X_WS) {
  parts_->X_WS[solid] = ToBullet(X_WS);
}

double SolidProbe::Depth(std::size_t a, std::size_t b) {
  Parts& parts = *parts_;
  return parts.probe.Depth(parts.shapes[a].shape(), parts.X_WS[a], parts.shapes[b].shape(),
                           parts.X_WS[b]);
}

}  // namespace smile::physics

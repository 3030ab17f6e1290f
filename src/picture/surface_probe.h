#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "model/model.h"

namespace smile::picture {

/// Part of a line, by its parameters [m].
struct Span {
  double from = 0, to = 0;
};

/// Surface probe: intersects lines and points with the objects of a model, to place the fingers of
/// a hand.
class SurfaceProbe {
 public:
  /// @param model  must outlive this. Its robot is ignored.
  explicit SurfaceProbe(const model::Model& model);

  /// Returns the parts of a line inside the pieces fixed to a frame F, in order; touching parts are
  /// merged.
  /// @param p_FQ, direction  a point of the line [m] and its direction, of length 1; in F.
  std::vector<Span> Along(model::FrameIndex frame, const std::vector<int>& variants,
                          const Vector3& p_FQ, const Vector3& direction) const;
  /// Returns the span that contains the point, or has it on its edge; an empty one if there is
  /// none.
  Span Around(model::FrameIndex frame, const std::vector<int>& variants, const Vector3& p_FQ,
              const Vector3& direction) const;

  /// Returns the point itself if it lies inside, otherwise a near one slightly below the surface.
  Vector3 PointWithin(model::FrameIndex frame, const std::vector<int>& variants,
                      const Vector3& p_FQ) const;

 private:
  const scene::VisualModel& visual_model_;
  std::vector<mesh::TriangleMesh> meshes_;  ///< one per visual; empty for the robot
};

}  // namespace smile::picture

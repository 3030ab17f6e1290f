#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "model/model.h"

namespace smile::picture {

/// A part of a line, by how far along it [m].
struct Span {
  double from = 0, to = 0;
};

/// Feels where the objects of a model are, as hands do that take hold of them.
class Touch {
 public:
  /// @param model  must outlive this. Its robot is not felt.
  explicit Touch(const model::Model& model);

  /// Where a line runs within what is fixed to a frame F, in order; touching spans are one.
  /// @param p_FQ, direction  a point of the line [m], and where it runs; of length 1.
  std::vector<Span> Along(model::FrameIndex frame, const std::vector<int>& looks,
                          const Vector3& p_FQ, const Vector3& direction) const;
  /// The span that the point itself lies in, or on the edge of; if none, an empty one.
  Span Around(model::FrameIndex frame, const std::vector<int>& looks, const Vector3& p_FQ,
              const Vector3& direction) const;

  /// The point itself where it lies within, else one near it a little below the surface.
  Vector3 PointWithin(model::FrameIndex frame, const std::vector<int>& looks,
                      const Vector3& p_FQ) const;

 private:
  const scene::VisualModel& visual_model_;
  std::vector<mesh::TriangleMesh> meshes_;  ///< one per visual; of others empty
};

}  // namespace smile::picture

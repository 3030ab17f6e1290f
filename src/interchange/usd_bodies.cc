#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/overloaded.h"
#include "base/wording.h"
#include "interchange/internal_usd_bodies.h"
#include "interchange/linear_color.h"
#include "sim/simulation.h"

namespace smile::interchange {
namespace {

/// Points and faces of a mesh, as values of properties.
struct MeshText {
  std::string points, counts, indices;

  void AddPoint(const Vector3& point) { points += (points.empty() ? "" : ", ") + UsdTuple(point); }
  template <class Face>
  void AddFace(const Face& face) {
    counts += (counts.empty() ? "" : ", ") + std::to_string(face.size());
    for (const std::uint32_t corner : face) {
      indices += (indices.empty() ? "" : ", ") + std::to_string(corner);
    }
  }
};

MeshText TextOf(const scene::Hull& hull) {
  MeshText text;
  for (const Vector3& corner : hull.polyhedron().corners) text.AddPoint(corner);
  for (const auto& face : hull.polyhedron().faces) text.AddFace(face);
  return text;
}

MeshText TextOf(const scene::DrawnMesh& mesh) {
  MeshText text;
  for (const auto& vertex : mesh.mesh->surface.vertices) {
    text.AddPoint(vertex.cast<double>() * mesh.scale);
  }
  for (const auto& triangle : mesh.mesh->surface.triangles) text.AddFace(triangle);
  return text;
}

/// Returns the type of a shape's prim.
const char* TypeOf(const scene::VisualShape& shape) {
  return std::visit(
      Overloaded{[](const scene::Block&) { return "Cube"; },
                 [](const scene::Cylinder&) { return "Cylinder"; },
                 [](const scene::Sphere&) { return "Sphere"; }, [](const auto&) { return "Mesh"; }},
      shape);
}

/// Writes the sizes of a shape, whose extent includes everything.
void WriteSizes(const scene::VisualShape& shape, UsdWriter* usd) {
  std::visit(
      Overloaded{[&](const scene::Block&) { usd->Set("double size", 1); },
                 [&](const scene::Cylinder& cylinder) {
                   usd->Set("uniform token axis", "\"Y\"");
                   usd->Set("double radius", cylinder.radius);
                   usd->Set("double height", cylinder.length);
                 },
                 [&](const scene::Sphere& sphere) { usd->Set("double radius", sphere.radius); },
                 [&](const auto& mesh) {
                   const MeshText text = TextOf(mesh);
                   usd->Set("point3f[] points", "[" + text.points + "]");
                   usd->Set("int[] faceVertexCounts", "[" + text.counts + "]");
                   usd->Set("int[] faceVertexIndices", "[" + text.indices + "]");
                   usd->Set("uniform token subdivisionScheme", "\"none\"");
                 }},
      shape);
}

}  // namespace

UsdBodies::UsdBodies(const ExportedMotion& motion, UsdWriter* usd) : motion_(motion), usd_(*usd) {
  for (const double seconds : motion.seconds) {
    codes_.push_back(std::round(seconds * sim::kTicksPerSecond));
  }
}

void UsdBodies::AddMaterial(double friction, double restitution) {
  materials_.try_emplace({friction, restitution},
                         "material_" + std::to_string(materials_.size() + 1));
}

void UsdBodies::WriteMaterials(const ExportedWorld& world) {
  for (const ExportedBody& body : world.bodies) {
    AddMaterial(body.spec.friction, body.spec.restitution);
  }
  if (world.robot) {
    AddMaterial(scene::LinkSpec().friction, 0);
    for (const scene::LinkSpec& link : world.robot->spec->links) AddMaterial(link.friction, 0);
  }
  usd_.Open("Scope", "materials");
  for (auto& [material, name] : materials_) {
    usd_.Open("Material", name, {"PhysicsMaterialAPI"});
    // Contacts of SMILE have the product of both frictions; UsdPhysics leaves the rule to programs.
    const double friction = material.first * material.first;
    usd_.Set("float physics:dynamicFriction", friction);
    usd_.Set("float physics:staticFriction", friction);
    usd_.Set("float physics:restitution", material.second);
    usd_.Close();
    name = "</World/materials/" + name + ">";
  }
  WritePaints();
  usd_.Close();
}

void UsdBodies::WritePaints() {
  for (const MovingFrame& frame : motion_.frames) {
    for (const MovingVisuals& group : frame.visuals) {
      for (const scene::Visual& visual : group.visuals) {
        paints_.try_emplace({LinearOf(visual.color), visual.glows},
                            "color_" + std::to_string(paints_.size() + 1));
      }
    }
  }
  for (auto& [paint, name] : paints_) {
    const std::string path = "/World/materials/" + name;
    usd_.Open("Material", name);
    usd_.Set("token outputs:surface.connect", "<" + path + "/surface.outputs:surface>");
    WriteShader(paint);
    usd_.Close();
    name = "<" + path + ">";
  }
}

void UsdBodies::WriteShader(const Paint& paint) {
  const auto& [red, green, blue] = paint.first;
  const std::string color = UsdTuple(Vector3(red, green, blue));
  usd_.Open("Shader", "surface");
  usd_.Set("uniform token info:id", "\"UsdPreviewSurface\"");
  usd_.Set("color3f inputs:diffuseColor", color);
  if (paint.second) usd_.Set("color3f inputs:emissiveColor", color);
  usd_.Set("float inputs:roughness", 1);
  usd_.Declare("token outputs:surface");
  usd_.Close();
}

void UsdBodies::WriteMass(const scene::MassProperties& mass) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(mass.inertia);
  Matrix3 axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  usd_.Set("float physics:mass", mass.mass);
  usd_.Set("point3f physics:centerOfMass", UsdTuple(mass.center));
  usd_.Set("float3 physics:diagonalInertia", UsdTuple(Vector3(solver.eigenvalues())));
  usd_.Set("quatf physics:principalAxes",
           UsdTuple(RigidTransform(axes, Vector3::Zero()).quaternion()));
}

void UsdBodies::OpenBody(const std::string& name, const RigidTransform& X_WB,
                         const scene::MassProperties* mass, int frame,
                         const std::vector<std::string>& never_collides_with) {
  std::vector<std::string_view> schemas;
  if (mass != nullptr) schemas = {"PhysicsRigidBodyAPI", "PhysicsMassAPI"};
  if (!never_collides_with.empty()) schemas.emplace_back("PhysicsFilteredPairsAPI");
  usd_.Open("Xform", name, schemas);
  if (mass != nullptr) {
    if (motion_.is_animated()) usd_.Set("bool physics:kinematicEnabled", "true");
    WriteMass(*mass);
  }
  std::string paths;
  for (const std::string& path : never_collides_with) paths += (paths.empty() ? "" : ", ") + path;
  if (!paths.empty()) usd_.Set("rel physics:filteredPairs", "[" + paths + "]");
  if (frame >= 0 && motion_.is_animated()) {
    usd_.SetPoses(motion_.frames[static_cast<std::size_t>(frame)], codes_);
  } else {
    usd_.SetPose(X_WB);
  }
}

void UsdBodies::WriteSurface(const Surface& surface) {
  if (surface.material != nullptr) {
    usd_.Set("uniform token purpose", "\"guide\"");
    usd_.Set("rel material:binding:physics", materials_.at(*surface.material));
  } else {
    usd_.Set("rel material:binding", paints_.at(surface.paint));
  }
  const auto& [red, green, blue] = surface.paint.first;
  usd_.Set("color3f[] primvars:displayColor", "[" + UsdTuple(Vector3(red, green, blue)) + "]");
}

void UsdBodies::WriteShape(const scene::VisualShape& shape, const RigidTransform& X,
                           const std::string& name, const Surface& surface) {
  const std::string type = TypeOf(shape);
  const bool collides = surface.material != nullptr;
  std::vector<std::string_view> schemas{"MaterialBindingAPI"};
  if (collides) schemas.emplace_back("PhysicsCollisionAPI");
  if (collides && type == "Mesh") schemas.emplace_back("PhysicsMeshCollisionAPI");
  usd_.Open(type, name, schemas);
  if (collides && type == "Mesh") {
    usd_.Set("uniform token physics:approximation", "\"convexHull\"");
  }
  WriteSizes(shape, &usd_);
  WriteSurface(surface);
  const auto* block = std::get_if<scene::Block>(&shape);
  usd_.SetPose(X, block != nullptr ? block->size : Vector3(Vector3::Ones()));
  usd_.Close();
}

void UsdBodies::WriteSolids(const std::vector<scene::Solid>& solids, double friction,
                            double restitution) {
  const Material material(friction, restitution);
  int number = 0;
  for (const scene::Solid& solid : solids) {
    WriteShape(scene::VisualShapeOf(solid.shape), solid.X_BS,
               "collision_" + std::to_string(++number),
               {.paint = {LinearOf(solid.color), false}, .material = &material});
  }
}

void UsdBodies::WriteVisuals(int frame) {
  if (frame < 0) return;
  int number = 0, group_number = 0;
  for (const MovingVisuals& group : motion_.frames[static_cast<std::size_t>(frame)].visuals) {
    const bool changes = group.shown.size() > 1;
    if (changes) {
      usd_.Open("Xform", "variant_" + std::to_string(++group_number));
      usd_.SetVisibility(group, codes_);
    }
    for (const scene::Visual& visual : group.visuals) {
      WriteShape(visual.shape, visual.X_FV, "visual_" + std::to_string(++number),
                 {.paint = {LinearOf(visual.color), visual.glows}});
    }
    if (changes) usd_.Close();
  }
}

}  // namespace smile::interchange

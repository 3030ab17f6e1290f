#include <cmath>
#include <numbers>

#include "base/overloaded.h"
#include "base/wording.h"
#include "interchange/internal_mjcf_geoms.h"
#include "interchange/numbers.h"

namespace smile::interchange {

void MjcfGeoms::WritePose(const RigidTransform& X) {
  xml_.Attribute("pos", Numbers(X.translation()));
  const Quaternion q = X.quaternion();
  xml_.Attribute("quat", Numbers({q.w(), q.x(), q.y(), q.z()}));
}

void MjcfGeoms::WriteInertial(const scene::MassProperties& mass) {
  const Matrix3& I = mass.inertia;
  xml_.Open("inertial");
  xml_.Attribute("pos", Numbers(mass.center));
  xml_.Number("mass", mass.mass);
  xml_.Attribute("fullinertia", Numbers({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}));
  xml_.Close();
}

void MjcfGeoms::WriteShape(const scene::VisualShape& shape, const RigidTransform& X_BG) {
  RigidTransform X = X_BG;
  std::visit(Overloaded{[&](const scene::Block& block) {
                          xml_.Attribute("type", "box");
                          xml_.Attribute("size", Numbers(Vector3(block.size / 2)));
                        },
                        [&](const scene::Cylinder& cylinder) {
                          xml_.Attribute("type", "cylinder");
                          xml_.Attribute("size", Numbers({cylinder.radius, cylinder.length / 2}));
                          X = X_BG * CylinderAlongZ();
                        },
                        [&](const scene::Sphere& sphere) {
                          xml_.Attribute("type", "sphere");
                          xml_.Attribute("size", NumberText(sphere.radius));
                        },
                        [&](const auto& mesh) {
                          xml_.Attribute("type", "mesh");
                          xml_.Attribute("mesh", meshes_.NameOf(mesh));
                        }},
             shape);
  WritePose(X);
}

void MjcfGeoms::WriteSolid(const scene::Solid& solid, double friction, double rolling) {
  xml_.Open("geom");
  WriteShape(scene::VisualShapeOf(solid.shape), solid.X_BS);
  xml_.Count("group", 3);
  xml_.Attribute("rgba", Numbers({solid.color.red, solid.color.green, solid.color.blue, 0.5}));
  // Contacts of SMILE have the product of both frictions.
  if (rolling > 0) xml_.Count("condim", 6);
  xml_.Attribute("friction", Numbers({friction * friction, 0, rolling}));
  xml_.Close();
}

void MjcfGeoms::WriteVisual(const scene::Visual& visual) {
  xml_.Open("geom");
  WriteShape(visual.shape, visual.X_FV);
  xml_.Count("group", 2);
  xml_.Count("contype", 0);
  xml_.Count("conaffinity", 0);
  xml_.Attribute("rgba", Numbers({visual.color.red, visual.color.green, visual.color.blue, 1}));
  xml_.Close();
}

void MjcfGeoms::WriteCamera(const ExportedCamera& camera) {
  // MuJoCo's cameras have y up and look along -z.
  const RigidTransform X_CM(Matrix3(Vector3(1, -1, -1).asDiagonal()), Vector3::Zero());
  const CameraIntrinsics& optics = camera.intrinsics;
  xml_.Open("camera");
  xml_.Attribute("name", camera.name);
  WritePose(camera.X_FC * X_CM);
  const double angle = 2 * std::atan(optics.height_px / (2 * optics.fy));
  // Degrees, whatever the compiler's angles are.
  xml_.Number("fovy", angle * 180 / std::numbers::pi);
  xml_.Attribute("resolution",
                 std::to_string(optics.width_px) + " " + std::to_string(optics.height_px));
  xml_.Close();
}

void WriteMjcfAssets(const MeshTable& meshes, xml::Writer* xml) {
  if (meshes.meshes().empty()) return;
  xml->Open("asset");
  for (const NamedMesh& mesh : meshes.meshes()) {
    std::string vertices, faces;
    for (const Vector3& corner : mesh.corners) {
      vertices += (vertices.empty() ? "" : " ") + Numbers(corner);
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        faces += (faces.empty() ? "" : " ") + std::to_string(corner);
      }
    }
    xml->Open("mesh");
    xml->Attribute("name", mesh.name);
    // What is only drawn need not be closed. MuJoCo finds the faces of hulls itself.
    xml->Attribute("inertia", mesh.is_convex ? "convex" : "shell");
    xml->Attribute("vertex", vertices);
    if (!mesh.is_convex) xml->Attribute("face", faces);
    xml->Close();
  }
  xml->Close();
}

}  // namespace smile::interchange

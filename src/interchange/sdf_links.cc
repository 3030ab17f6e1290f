#include <cmath>

#include "base/overloaded.h"
#include "base/wording.h"
#include "interchange/internal_sdf_links.h"
#include "interchange/mesh_files.h"
#include "interchange/numbers.h"

namespace smile::interchange {

void SdfLinks::WritePose(const RigidTransform& X) {
  const Vector3& p = X.translation();
  const Quaternion q = X.quaternion();
  // Angles would be less exact.
  xml_.Open("pose");
  xml_.Attribute("rotation_format", "quat_xyzw");
  xml_.Text(Numbers({p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}));
  xml_.Close();
}

void SdfLinks::WriteInertial(const scene::MassProperties& mass) {
  const Matrix3& I = mass.inertia;
  xml_.Open("inertial");
  WritePose(RigidTransform(mass.center));
  xml_.TextElement("mass", NumberText(mass.mass));
  xml_.Open("inertia");
  xml_.TextElement("ixx", NumberText(I(0, 0)));
  xml_.TextElement("ixy", NumberText(I(0, 1)));
  xml_.TextElement("ixz", NumberText(I(0, 2)));
  xml_.TextElement("iyy", NumberText(I(1, 1)));
  xml_.TextElement("iyz", NumberText(I(1, 2)));
  xml_.TextElement("izz", NumberText(I(2, 2)));
  xml_.Close();
  xml_.Close();
}

void SdfLinks::WriteMesh(const std::string& name) {
  xml_.Open("mesh");
  xml_.TextElement("uri", MeshFileName(mesh_folder_, name));
  xml_.Close();
}

void SdfLinks::WriteShape(const scene::VisualShape& shape, const RigidTransform& X_LG) {
  const bool is_cylinder = std::holds_alternative<scene::Cylinder>(shape);
  WritePose(is_cylinder ? X_LG * CylinderAlongZ() : X_LG);
  xml_.Open("geometry");
  std::visit(Overloaded{[&](const scene::Block& block) {
                          xml_.Open("box");
                          xml_.TextElement("size", Numbers(block.size));
                          xml_.Close();
                        },
                        [&](const scene::Cylinder& cylinder) {
                          xml_.Open("cylinder");
                          xml_.TextElement("radius", NumberText(cylinder.radius));
                          xml_.TextElement("length", NumberText(cylinder.length));
                          xml_.Close();
                        },
                        [&](const scene::Sphere& sphere) {
                          xml_.Open("sphere");
                          xml_.TextElement("radius", NumberText(sphere.radius));
                          xml_.Close();
                        },
                        [&](const auto& mesh) { WriteMesh(meshes_.NameOf(mesh)); }},
             shape);
  xml_.Close();
}

void SdfLinks::WriteSurface(double friction, double restitution) {
  // Contacts of SMILE have the product of both frictions.
  const std::string mu = NumberText(friction * friction);
  xml_.Open("surface");
  xml_.Open("friction");
  xml_.Open("ode");
  xml_.TextElement("mu", mu);
  xml_.TextElement("mu2", mu);
  xml_.Close();
  xml_.Close();
  if (restitution > 0) {
    xml_.Open("bounce");
    xml_.TextElement("restitution_coefficient", NumberText(restitution));
    xml_.Close();
  }
  xml_.Close();
}

void SdfLinks::WriteSolids(const std::vector<scene::Solid>& solids, double friction,
                           double restitution) {
  int number = 0;
  for (const scene::Solid& solid : solids) {
    xml_.Open("collision");
    xml_.Attribute("name", "collision_" + std::to_string(++number));
    WriteShape(scene::VisualShapeOf(solid.shape), solid.X_BS);
    WriteSurface(friction, restitution);
    xml_.Close();
  }
}

void SdfLinks::WriteVisuals(const std::vector<scene::Visual>& visuals) {
  int number = 0;
  for (const scene::Visual& visual : visuals) {
    const Color& color = visual.color;
    const std::string rgba = Numbers({color.red, color.green, color.blue, 1});
    xml_.Open("visual");
    xml_.Attribute("name", "visual_" + std::to_string(++number));
    WriteShape(visual.shape, visual.X_FV);
    xml_.TextElement("cast_shadows", visual.casts_shadow ? "true" : "false");
    xml_.Open("material");
    xml_.TextElement("ambient", rgba);
    xml_.TextElement("diffuse", rgba);
    if (visual.glows) xml_.TextElement("emissive", rgba);
    xml_.Close();
    xml_.Close();
  }
}

void SdfLinks::WriteCamera(const ExportedCamera& camera, const std::string& name) {
  // A sensor S looks along its x axis, with y to the left and z up.
  Matrix3 R_CS;
  R_CS << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const CameraIntrinsics& optics = camera.intrinsics;
  xml_.Open("sensor");
  xml_.Attribute("name", name);
  xml_.Attribute("type", "camera");
  WritePose(camera.X_FC * RigidTransform(R_CS, Vector3::Zero()));
  xml_.Open("camera");
  xml_.TextElement("horizontal_fov", NumberText(2 * std::atan(optics.width_px / (2 * optics.fx))));
  xml_.Open("image");
  xml_.TextElement("width", std::to_string(optics.width_px));
  xml_.TextElement("height", std::to_string(optics.height_px));
  xml_.Close();
  xml_.Open("clip");
  xml_.TextElement("near", NumberText(optics.near));
  xml_.TextElement("far", NumberText(optics.far));
  xml_.Close();
  xml_.Close();
  xml_.Close();
}

}  // namespace smile::interchange

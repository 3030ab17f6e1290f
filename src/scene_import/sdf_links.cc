#include <algorithm>

#include "base/wording.h"
#include "scene_import/internal_link_shapes.h"
#include "scene_import/internal_sdf_links.h"
#include "scene_import/internal_shapes.h"

namespace smile::scene_import {
namespace {

constexpr double kSdfDensity = 1000;  ///< of water, as of SDFormat 1.11 [kg/m3]

std::vector<ForeignShape> SdfMeshShapes(const SourceElement& mesh, bool collides, ModelFiles* files,
                                        ImportFindings* findings) {
  if (!collides) {
    findings->Remark(mesh.place(), "left out: a mesh that is only seen; SMILE shows what collides");
    return {};
  }
  if (mesh.FindChild("submesh")) findings->Remark(mesh.place(), "changed: all of it, no submesh");
  const Vector3 scale = SdfVector(mesh, "scale", {1, 1, 1}, findings);
  if (!(scale.cwiseAbs().minCoeff() > 1e-9) || scale.cwiseAbs().maxCoeff() > kMaxLength) {
    findings->Refuse(mesh.place(), "found a scale of 0 or beyond 1e5");
    return {};
  }
  const auto shape =
      files->MeshShape(FileNameOfUri(SdfText(mesh, "uri"), *files), scale, mesh.place(), findings);
  return shape ? std::vector{*shape} : std::vector<ForeignShape>();
}

std::vector<ForeignShape> SdfRoundShapes(const SourceElement& shape, ImportFindings* findings) {
  const double radius = SdfNumber(shape, "radius", 0.5, findings);
  const double length = SdfNumber(shape, "length", 1, findings);
  if (!AreSpans({radius, length}, shape.place(), findings)) return {};
  if (shape.name == "sphere") return {SphereShape(radius)};
  if (shape.name == "capsule") return CapsuleShapes(radius, length);
  return {CylinderShape(radius, length)};
}

std::vector<ForeignShape> SdfPlaneShapes(const SourceElement& shape, ImportFindings* findings) {
  const Vector3 normal = SdfVector(shape, "normal", Vector3::UnitZ(), findings);
  GroundPlane plane;
  if (const SourceElement* size = shape.FindChild("size")) {
    const auto spans = NumbersOf(size->text, 2, 2, size->place(), "size", findings);
    if (spans) plane = {.x_span = (*spans)[0], .y_span = (*spans)[1]};
  }
  if (!(normal.norm() > 1e-9)) {
    findings->Refuse(shape.place(), "found a normal of length 0");
    return {};
  }
  const Quaternion q = Quaternion::FromTwoVectors(Vector3::UnitZ(), normal);
  return {{.geometry = plane, .X_BE = {q, Vector3::Zero()}}};
}

std::vector<ForeignShape> SdfShapesOf(const SourceElement& shape, bool collides, ModelFiles* files,
                                      ImportFindings* findings) {
  const std::string& type = shape.name;
  if (type == "mesh") return SdfMeshShapes(shape, collides, files, findings);
  if (type == "sphere" || type == "cylinder" || type == "capsule") {
    return SdfRoundShapes(shape, findings);
  }
  if (type == "plane") return SdfPlaneShapes(shape, findings);
  if (type == "box") {
    const Vector3 size = SdfVector(shape, "size", {1, 1, 1}, findings);
    if (!AreSpans({size.x(), size.y(), size.z()}, shape.place(), findings)) return {};
    return {BlockShape(size)};
  }
  findings->Remark(shape.place(),
                   "left out: SMILE has no shape like this " + Printable(type.substr(0, 60)));
  return {};
}

/// Remarks the children of an element that are not among the known ones.
void RemarkOthers(const SourceElement& element, std::initializer_list<std::string_view> known,
                  ImportFindings* findings) {
  for (const SourceElement& child : element.children) {
    if (std::ranges::find(known, child.name) != known.end()) continue;
    findings->Remark(child.place(), "left out: SMILE has no counterpart of it");
  }
}

/// Reads the friction and restitution of a collision.
void ReadSdfSurface(const SourceElement& collision, ForeignShape* shape, ImportFindings* findings) {
  shape->friction = 1;  // of SDFormat
  const SourceElement* surface = collision.FindChild("surface");
  if (!surface) return;
  RemarkOthers(*surface, {"friction", "bounce"}, findings);
  const SourceElement* friction = surface->FindChild("friction");
  const SourceElement* ode = friction ? friction->FindChild("ode") : nullptr;
  if (ode) shape->friction = FrictionOfContact(SdfNumber(*ode, "mu", 1, findings));
  if (const SourceElement* bounce = surface->FindChild("bounce")) {
    const double fraction = SdfNumber(*bounce, "restitution_coefficient", 0, findings);
    shape->restitution = fraction > 0 ? std::min(fraction, 1.0) : 0;
  }
}

void ReadSdfShape(const SourceElement& part, SdfFrames* frames, ModelFiles* files,
                  ForeignBody* body, ImportFindings* findings) {
  ForeignShape traits{.place = part.place()};
  if (const std::string* name = part.FindAttribute("name")) traits.name = *name;
  traits.collides = part.name == "collision";
  traits.is_seen = !traits.collides;
  if (traits.collides) ReadSdfSurface(part, &traits, findings);
  const SourceElement* material = part.FindChild("material");
  if (material && material->FindChild("diffuse")) {
    const Vector3 rgb = SdfVector(*material, "diffuse", {1, 1, 1}, findings);
    traits.color = ColorOfNumbers({rgb.x(), rgb.y(), rgb.z()});
  }
  RemarkOthers(part, {"pose", "geometry", "material", "surface", "cast_shadows", "max_contacts"},
               findings);
  if (material) RemarkOthers(*material, {"ambient", "diffuse", "specular", "emissive"}, findings);
  const SourceElement* geometry = part.FindChild("geometry");
  if (!geometry || geometry->children.empty()) {
    return findings->Refuse(part.place(), "found no geometry");
  }
  std::vector<ForeignShape> shapes =
      SdfShapesOf(geometry->children[0], traits.collides, files, findings);
  for (ForeignShape& shape : shapes) shape.mass *= traits.collides ? kSdfDensity : 0;
  AddLinkShapes(frames->Written(part), std::move(shapes), traits, body, findings);
}

}  // namespace

std::optional<ForeignMass> SdfMassOf(const SourceElement& link, SdfFrames* frames,
                                     ImportFindings* findings) {
  const SourceElement* inertial = link.FindChild("inertial");
  if (!inertial) return ForeignMass{.mass = 1};  // of SDFormat
  const std::string* is_automatic = inertial->FindAttribute("auto");
  if (is_automatic && *is_automatic == "true") {
    findings->Remark(inertial->place(), "changed: the mass is that of water");
    return std::nullopt;
  }
  const RigidTransform X_LI = frames->Written(*inertial);
  ForeignMass mass{.mass = SdfNumber(*inertial, "mass", 1, findings), .p_BBcm = X_LI.translation()};
  IsMass(mass.mass, inertial->place(), findings);
  const SourceElement* inertia = inertial->FindChild("inertia");
  if (!inertia) return mass;
  const auto part = [&](const char* name, double usual) {
    return SdfNumber(*inertia, name, usual, findings);
  };
  Matrix3 I;
  I << part("ixx", 1), part("ixy", 0), part("ixz", 0), part("ixy", 0), part("iyy", 1),
      part("iyz", 0), part("ixz", 0), part("iyz", 0), part("izz", 1);
  mass.inertia = X_LI.rotation() * I * X_LI.rotation().transpose();
  return mass;
}

void ReadSdfShapes(const SourceElement& link, SdfFrames* frames, ModelFiles* files,
                   ForeignBody* body, ImportFindings* findings) {
  for (const SourceElement& part : link.children) {
    if (part.name == "collision" || part.name == "visual") {
      ReadSdfShape(part, frames, files, body, findings);
    } else if (part.name != "pose" && part.name != "inertial" && part.name != "sensor") {
      findings->Remark(part.place(), "left out: SMILE has no counterpart of it");
    }
  }
}

}  // namespace smile::scene_import

#include <algorithm>
#include <cmath>

#include "base/wording.h"
#include "scene_import/internal_mjcf_context.h"
#include "scene_import/internal_shapes.h"

// Geoms of MJCF. Sizes are halves and radii.

namespace smile::scene_import {
namespace {

constexpr double kWaterDensity = 1000;  ///< default of MJCF [kg/m3]
/// Groups from here on are not shown at first.
constexpr double kFirstHiddenGroup = 3;

/// Dimensions of a geom and its pose in the body.
struct GeomFrame {
  std::vector<double> size;
  RigidTransform X_BG;
};

/// Reads the size, and `fromto`, which sets the last size and the pose.
GeomFrame GeomFrameOf(ElementReader* reader, const MjcfCompiler& compiler) {
  GeomFrame frame{.size = reader->Numbers("size", 1, 3), .X_BG = MjcfPoseOf(reader, compiler)};
  const std::vector<double> ends = reader->Numbers("fromto", 6, 6);
  if (ends.empty()) return frame;
  const Vector3 from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
  const double length = (to - from).norm();
  if (!(length > kMinSpan) || frame.size.empty()) {
    reader->Refuse("found fromto without a length or a size, expected two places and a radius");
    return frame;
  }
  frame.size = {frame.size[0], length / 2, length / 2};
  if (reader->Text("type") == "box") frame.size[1] = frame.size[0];
  frame.X_BG =
      RigidTransform(Quaternion::FromTwoVectors(Vector3::UnitZ(), to - from), (from + to) / 2);
  IsPosition(frame.X_BG.translation(), reader->place(), &reader->findings());
  return frame;
}

/// Reads the corners of a mesh that stands in the model; nullopt after a fault.
std::optional<scene::SurfaceMesh> WrittenCorners(ElementReader* asset) {
  const std::vector<double> v = asset->Numbers("vertex", 12, 300'000);
  if (v.empty()) return std::nullopt;
  scene::SurfaceMesh surface;
  for (std::size_t i = 2; i < v.size(); i += 3) {
    // From the axes of files to those of scenes, see CylinderFromZ().
    surface.vertices.emplace_back(static_cast<float>(v[i - 2]), static_cast<float>(-v[i]),
                                  static_cast<float>(v[i - 1]));
  }
  return surface;
}

/// Makes the shape of a mesh asset; nullopt after a fault.
std::optional<ForeignShape> ShapeOfAsset(const std::string& name, const SourceElement& asset,
                                         const MjcfContext& context) {
  const SourceElement completed = context.defaults.Completed(asset, "", context.findings);
  ElementReader reader(completed, context.findings);
  const Vector3 scale = reader.Vector("scale", {1, 1, 1});
  if (!(scale.cwiseAbs().minCoeff() > 1e-9) || scale.cwiseAbs().maxCoeff() > kMaxLength) {
    reader.Refuse("found a scale of 0 or beyond 1e5");
    return std::nullopt;
  }
  if (reader.Has("refpos") || reader.Has("refquat")) {
    reader.Refuse("found refpos or refquat, expected a mesh in its own frame");
    return std::nullopt;
  }
  if (reader.Has("vertex")) {
    // MuJoCo collides meshes as their hulls, so faces make no difference.
    const std::optional<scene::SurfaceMesh> corners = WrittenCorners(&reader);
    if (!corners) return std::nullopt;
    return context.files->MeshShape(*corners, scale, name, reader.place(), context.findings);
  }
  const std::string file = reader.Text("file");
  const std::string& folder = context.compiler.mesh_folder;
  return context.files->MeshShape(folder.empty() ? file : folder + "/" + file, scale,
                                  reader.place(), context.findings);
}

/// Returns the shape of the mesh that a geom names.
std::vector<ForeignShape> MjcfMeshShapes(ElementReader* geom, const MjcfContext& context) {
  const std::string name = geom->Text("mesh");
  const auto asset = context.meshes.find(name);
  if (asset == context.meshes.end()) {
    geom->Refuse("found mesh=" + Quoted(name) + ", expected a mesh of asset");
    return {};
  }
  const auto known = context.mesh_shapes->find(name);
  if (known != context.mesh_shapes->end()) return known->second;
  const std::optional<ForeignShape> shape = ShapeOfAsset(name, *asset->second, context);
  std::vector<ForeignShape>& made = (*context.mesh_shapes)[name];
  if (shape) made.push_back(*shape);
  return made;
}

std::vector<ForeignShape> BoxShapes(const std::vector<double>& half, ElementReader* geom) {
  if (half.size() < 3) {
    geom->Refuse("found fewer than three sizes, expected those of a box");
    return {};
  }
  const Vector3 size = 2 * Vector3(half[0], half[1], half[2]);
  if (!AreSpans({size.x(), size.y(), size.z()}, geom->place(), &geom->findings())) return {};
  return {BlockShape(size)};
}

std::vector<ForeignShape> RoundShapes(const std::string& type, const std::vector<double>& size,
                                      ElementReader* geom) {
  const std::size_t needed = type == "sphere" ? 1 : 2;
  if (size.size() < needed) {
    geom->Refuse("found fewer sizes than a " + type + " has");
    return {};
  }
  const double length = needed == 2 ? 2 * size[1] : 1;
  if (!AreSpans({size[0], length}, geom->place(), &geom->findings())) return {};
  if (type == "sphere") return {SphereShape(size[0])};
  if (type == "capsule") return CapsuleShapes(size[0], length);
  return {CylinderShape(size[0], length)};
}

std::vector<ForeignShape> PlaneShapes(const std::vector<double>& half) {
  GroundPlane plane;
  if (half.size() >= 2) plane = {.x_span = 2 * half[0], .y_span = 2 * half[1]};
  return {{.geometry = plane}};
}

/// Returns the shapes of a geom in its own frame.
std::vector<ForeignShape> ShapesInGeom(const std::string& type, const std::vector<double>& size,
                                       ElementReader* geom, const MjcfContext& context) {
  if (type == "mesh") return MjcfMeshShapes(geom, context);
  if (geom->Has("mesh")) {
    geom->Remark("left out: a " + Printable(type) + " that is fitted to a mesh");
    return {};
  }
  if (type == "box") return BoxShapes(size, geom);
  if (type == "sphere" || type == "cylinder" || type == "capsule") {
    return RoundShapes(type, size, geom);
  }
  if (type == "plane") return PlaneShapes(size);
  if (type == "ellipsoid" || type == "hfield" || type == "sdf") {
    geom->Remark("left out: SMILE has no shape like this " + type);
    return {};
  }
  geom->Refuse("found type=" + Quoted(type) +
               ", expected plane, sphere, capsule, cylinder, box or mesh");
  return {};
}

/// Reads the color of a geom: its own, or that of its material.
std::vector<double> GeomColorOf(ElementReader* geom, const MjcfContext& context) {
  std::vector<double> rgba = geom->Numbers("rgba", 4, 4);
  const std::string name = geom->Text("material");
  const auto material = context.materials.find(name);
  if (name.empty()) return rgba;
  if (material == context.materials.end()) {
    geom->Refuse("found material=" + Quoted(name) + ", expected one of asset");
    return rgba;
  }
  const SourceElement completed =
      context.defaults.Completed(*material->second, "", context.findings);
  ElementReader reader(completed, context.findings);
  const std::vector<double> its_color = reader.Numbers("rgba", 4, 4);
  if (reader.Has("texture")) reader.Remark("left out: its texture; SMILE paints in plain colors");
  return rgba.empty() ? its_color : rgba;
}

/// Reads whether a geom collides and is seen, and its color.
void ReadGeomLook(ElementReader* geom, const MjcfContext& context, ForeignShape* shape) {
  shape->collides = geom->Number("contype", 1) != 0;
  shape->collides |= geom->Number("conaffinity", 1) != 0;
  const std::vector<double> rgba = GeomColorOf(geom, context);
  const double alpha = rgba.empty() ? 1 : rgba[3];
  shape->is_seen = geom->Number("group", 0) < kFirstHiddenGroup && alpha > 0;
  if (rgba.empty()) return;
  const auto within = [](double part) { return std::clamp(part, 0.0, 1.0); };
  shape->color = Color{within(rgba[0]), within(rgba[1]), within(rgba[2])};
  if (shape->is_seen && alpha < 1) geom->Remark("changed: it is transparent, and opaque in SMILE");
}

/// Reads the friction of a geom.
void ReadGeomSurface(ElementReader* geom, ForeignShape* shape) {
  const std::vector<double> friction = geom->Numbers("friction", 1, 3);
  shape->friction = FrictionOfContact(friction.empty() ? 1 : friction[0]);
  // Of MuJoCo's contacts only those of six dimensions resist rolling.
  const bool resists = geom->Number("condim", 3) == 6;
  shape->rolling = 0;
  if (resists) shape->rolling = friction.size() < 3 ? 1e-4 : std::clamp(friction[2], 0.0, 1.0);
}

/// Sets the masses of a geom's shapes, which have those of 1 kg/m3.
void ReadGeomMass(ElementReader* geom, std::vector<ForeignShape>* shapes) {
  double total = 0;
  for (const ForeignShape& shape : *shapes) total += shape.mass;
  const double density = geom->Number("density", kWaterDensity);
  // The mass of what stands fast is not needed, and may be large.
  const double mass = geom->Number("mass", density * total);
  if (mass < 0 || geom->Has("mass")) IsMass(mass, geom->place(), &geom->findings());
  for (ForeignShape& shape : *shapes) shape.mass = total > 0 ? shape.mass / total * mass : 0;
}

}  // namespace

std::vector<ForeignShape> MjcfShapesOf(const SourceElement& geom, const MjcfContext& context) {
  ElementReader reader(geom, context.findings);
  const std::string type = reader.Text("type", "sphere");
  const GeomFrame frame = GeomFrameOf(&reader, context.compiler);
  ForeignShape traits{.place = reader.place(), .name = reader.Text("name")};
  ReadGeomLook(&reader, context, &traits);
  ReadGeomSurface(&reader, &traits);
  if (type == "mesh" && !traits.collides) {
    reader.Remark("left out: a mesh that is only seen; SMILE shows what collides");
    return {};
  }
  std::vector<ForeignShape> shapes = ShapesInGeom(type, frame.size, &reader, context);
  ReadGeomMass(&reader, &shapes);
  for (ForeignShape& shape : shapes) {
    ForeignShape complete = traits;
    complete.geometry = shape.geometry;
    complete.X_BE = frame.X_BG * shape.X_BE;
    complete.mass = shape.mass;
    complete.center_of_mass = shape.center_of_mass;
    shape = std::move(complete);
  }
  reader.RemarkRest({"class", "mesh", "user"});
  return shapes;
}

}  // namespace smile::scene_import

#include <cmath>
#include <map>
#include <set>

#include "base/wording.h"
#include "scene_import/internal_model_readers.h"
#include "scene_import/internal_sdf_links.h"
#include "scene_import/internal_shapes.h"

// Reads SDFormat, Gazebo's format: http://sdformat.org/spec

namespace smile::scene_import {
namespace {

/// Brightness of a light of SMILE's usual strength, as in the export.
constexpr double kUsualSdfDiffuse = 0.8;

/// Reads one model, whose frames and joints are its own.
class SdfModelReader {
 public:
  SdfModelReader(const SourceElement& model, ModelFiles* files, ImportFindings* findings,
                 ForeignWorld* world)
      : model_(model),
        files_(*files),
        findings_(*findings),
        world_(*world),
        frames_(model, findings) {}

  void Read() {
    X_WM_ = frames_.Written(model_);
    const SourceElement* pose = model_.FindChild("pose");
    const std::string* relative = pose ? pose->FindAttribute("relative_to") : nullptr;
    if (relative && !relative->empty() && *relative != "world") {
      findings_.Refuse(pose->place(),
                       "found a model relative to " + Quoted(*relative) + ", expected the world");
    }
    const std::string fixed = SdfText(model_, "static", "false");
    is_static_ = fixed == "true" || fixed == "1";
    for (const SourceElement& child : model_.children) Sort(child);
    for (const SourceElement& child : model_.children) {
      if (child.name == "link") AddLink(child, 0);
    }
  }

 private:
  void Sort(const SourceElement& child) {
    const std::string* name = child.FindAttribute("name");
    if (child.name == "link" && name) {
      links_.emplace(*name, &child);
    } else if (child.name == "joint") {
      const auto [known, is_new] = joints_.emplace(SdfText(child, "child"), &child);
      if (!is_new) findings_.Remark(child.place(), "left out: a second joint of its link");
    } else if (child.name == "model" || child.name == "include") {
      findings_.Refuse(child.place(), "found a model within a model, expected links and joints");
    } else if (child.name != "pose" && child.name != "static" && child.name != "frame") {
      findings_.Remark(child.place(), "left out: SMILE has no counterpart of it");
    }
  }

  /// Adds a link after the one that carries it.
  /// @returns its index; -1 after a fault.
  int AddLink(const SourceElement& link, std::size_t depth) {
    const std::string* name = link.FindAttribute("name");
    if (!name) return -1;
    const auto known = indices_.find(*name);
    if (known != indices_.end()) return known->second;
    if (depth > links_.size() || depth > 200 || world_.bodies.size() == kMaxBodies) {
      findings_.Refuse(link.place(),
                       "found joints in a circle, or more links than the import "
                       "allows");
      return -1;
    }
    ForeignBody body{.place = link.place(), .name = NameOf(*name)};
    body.X_WB = X_WM_ * frames_.PoseOf(link);
    if (!is_static_) ReadMobility(*name, depth, &body);
    body.mass = SdfMassOf(link, &frames_, &findings_);
    ReadSdfShapes(link, &frames_, &files_, &body, &findings_);
    ReadCameras(link, body);
    const int index = static_cast<int>(world_.bodies.size());
    world_.bodies.push_back(std::move(body));
    return indices_[*name] = index;
  }

  /// Returns the name of a link's object: that of the model if it is the only one.
  std::string NameOf(const std::string& link) const {
    const std::string* model = model_.FindAttribute("name");
    return links_.size() == 1 && model ? *model : link;
  }

  void ReadMobility(const std::string& link, std::size_t depth, ForeignBody* body) {
    const auto found = joints_.find(link);
    if (found == joints_.end()) {
      body->joint.kind = ForeignJointKind::kFree;
      return;
    }
    const SourceElement& element = *found->second;
    const std::string parent = SdfText(element, "parent");
    if (parent != "world") {
      const auto carrier = links_.find(parent);
      if (carrier == links_.end()) {
        return findings_.Refuse(element.place(), "found the parent " + Quoted(parent) +
                                                     ", expected a link of the model");
      }
      body->parent = AddLink(*carrier->second, depth + 1);
    }
    const std::string* type = element.FindAttribute("type");
    body->joint.place = element.place();
    body->joint.word = type ? *type : "";
    if (body->joint.word == "fixed") return;
    body->joint.kind = ForeignJointKind::kOther;
    if (body->joint.word == "prismatic") ReadPrismatic(element, &body->joint);
  }

  void ReadPrismatic(const SourceElement& element, ForeignJoint* joint) {
    joint->kind = ForeignJointKind::kSlide;
    const SourceElement* axis = element.FindChild("axis");
    if (!axis) return findings_.Refuse(element.place(), "found no axis");
    const Vector3 xyz = SdfVector(*axis, "xyz", Vector3::UnitZ(), &findings_);
    if (!(xyz.norm() > 1e-9)) return findings_.Refuse(axis->place(), "found an axis of length 0");
    const SourceElement* written = axis->FindChild("xyz");
    const std::string* frame = written ? written->FindAttribute("expressed_in") : nullptr;
    const RigidTransform X_MF =
        frame && !frame->empty() ? frames_.PoseOf(*frame, axis->place()) : frames_.PoseOf(element);
    joint->axis_in_world = (X_WM_ * X_MF).rotation() * xyz.normalized();
    if (const SourceElement* limit = axis->FindChild("limit")) {
      if (limit->FindChild("lower")) joint->lower = SdfNumber(*limit, "lower", 0, &findings_);
      if (limit->FindChild("upper")) joint->upper = SdfNumber(*limit, "upper", 0, &findings_);
    }
    if (const SourceElement* dynamics = axis->FindChild("dynamics")) {
      joint->damping = SdfNumber(*dynamics, "damping", 0, &findings_);
    }
  }

  void ReadCameras(const SourceElement& link, const ForeignBody& body) {
    for (const SourceElement& sensor : link.children) {
      if (sensor.name != "sensor") continue;
      const std::string* type = sensor.FindAttribute("type");
      const SourceElement* camera = sensor.FindChild("camera");
      if (!is_static_ || !type || *type != "camera" || !camera) {
        findings_.Remark(sensor.place(), "left out: a sensor that is no camera fixed in the world");
        continue;
      }
      AddCamera(sensor, *camera, body.X_WB);
    }
  }

  void AddCamera(const SourceElement& sensor, const SourceElement& camera,
                 const RigidTransform& X_WB) {
    // A sensor S looks along its x axis, with y to the left and z up.
    Matrix3 R_SC;
    R_SC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    const double across = SdfNumber(camera, "horizontal_fov", 1.047, &findings_);
    double width = 320, height = 240;
    if (const SourceElement* image = camera.FindChild("image")) {
      width = SdfNumber(*image, "width", width, &findings_);
      height = SdfNumber(*image, "height", height, &findings_);
    }
    if (!(width > 0) || !(height > 0)) {
      return findings_.Refuse(camera.place(), "found a picture without pixels");
    }
    ForeignCamera made{.place = sensor.place()};
    if (const std::string* name = sensor.FindAttribute("name")) made.name = *name;
    made.X_WC = X_WB * frames_.Written(sensor) * RigidTransform(R_SC, Vector3::Zero());
    made.vertical_field_of_view = 2 * std::atan(std::tan(across / 2) * height / width);
    world_.cameras.push_back(made);
  }

  const SourceElement& model_;
  ModelFiles& files_;
  ImportFindings& findings_;
  ForeignWorld& world_;
  SdfFrames frames_;
  RigidTransform X_WM_;
  bool is_static_ = false;
  std::map<std::string, const SourceElement*> links_;   // by name
  std::map<std::string, const SourceElement*> joints_;  // by child
  std::map<std::string, int> indices_;                  // of bodies
};

void ReadSdfLight(const SourceElement& light, ForeignWorld* world, ImportFindings* findings) {
  const std::string* type = light.FindAttribute("type");
  if (!type || *type != "directional") {
    return findings->Remark(light.place(), "left out: a light that is not directional");
  }
  const SourceElement none;
  SdfFrames frames(none, findings);
  const Vector3 direction = SdfVector(light, "direction", {0, 0, -1}, findings);
  const Vector3 diffuse = SdfVector(light, "diffuse", {1, 1, 1}, findings) / kUsualSdfDiffuse;
  world->lights.push_back({.place = light.place(),
                           .direction_in_world = frames.Written(light).rotation() * direction,
                           .color = {diffuse.x(), diffuse.y(), diffuse.z()}});
}

void ReadSdfContent(const SourceElement& parent, ModelFiles* files, ImportFindings* findings,
                    ForeignWorld* world) {
  for (const SourceElement& child : parent.children) {
    if (child.name == "model") {
      SdfModelReader(child, files, findings, world).Read();
    } else if (child.name == "light") {
      ReadSdfLight(child, world, findings);
    } else if (child.name == "gravity") {
      const Vector3 gravity = SdfVector(parent, "gravity", {0, 0, -9.81}, findings);
      if (!gravity.isApprox(Vector3(0, 0, -9.81), 0.002)) {
        findings->Remark(child.place(), "changed: gravity is 9.81 m/s2 downwards in SMILE");
      }
    } else if (child.name == "include") {
      findings->Remark(child.place(),
                       "left out: an included model; import a file without includes");
    } else if (child.name != "world") {
      findings->Remark(child.place(), "left out: SMILE has no counterpart of it");
    }
  }
}

}  // namespace

ForeignWorld ReadSdf(const SourceElement& root, ModelFiles* files, ImportFindings* findings) {
  ForeignWorld world;
  const SourceElement* first = root.FindChild("world");
  ReadSdfContent(first ? *first : root, files, findings, &world);
  for (const SourceElement& child : root.children) {
    if (first && &child != first) findings->Remark(child.place(), "left out: beside the world");
  }
  return world;
}

}  // namespace smile::scene_import

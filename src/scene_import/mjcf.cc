#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/files.h"
#include "base/wording.h"
#include "scene_import/internal_mjcf_context.h"
#include "scene_import/internal_model_readers.h"
#include "scene_import/internal_shapes.h"

// Reads MJCF, MuJoCo's format: https://mujoco.readthedocs.io/en/stable/XMLreference.html

namespace smile::scene_import {
namespace {

constexpr int kMaxIncludes = 64;
constexpr int kMaxDepth = 200;  ///< of elements, through all includes
constexpr std::size_t kMaxIncludedBytes = 16u << 20;
/// Brightness of a light of SMILE's usual strength, as in the export.
constexpr double kUsualDiffuse = 0.6;

/// Replaces `include` elements by the content of the files that they name.
class MjcfInclusion {
 public:
  MjcfInclusion(const ModelFiles& files, ImportFindings* findings)
      : files_(files), findings_(*findings) {}

  void Expand(SourceElement* element, int depth = 0) {
    if (depth > kMaxDepth) {
      element->children.clear();
      return findings_.Refuse(element->place(),
                              "found elements more than " + std::to_string(kMaxDepth) + " deep");
    }
    std::vector<SourceElement> children;
    for (SourceElement& child : element->children) {
      if (child.name == "include") {
        Include(child, depth, &children);
      } else {
        Expand(&child, depth + 1);
        children.push_back(std::move(child));
      }
    }
    element->children = std::move(children);
  }

 private:
  void Include(const SourceElement& include, int depth, std::vector<SourceElement>* children) {
    const std::string* name = include.FindAttribute("file");
    const auto path = files_.Find(name ? *name : "", include.place(), &findings_);
    if (!path) return;
    // As in MuJoCo, a file is included once; so no circle is endless.
    if (!included_.insert(*path).second || included_.size() > kMaxIncludes) {
      return findings_.Refuse(include.place(),
                              "found a file that is included twice, or more than " +
                                  std::to_string(kMaxIncludes) + " files");
    }
    std::optional<SourceElement> root = ParseIncluded(*path, *name);
    if (!root) return;
    Expand(&*root, depth + 1);
    for (SourceElement& child : root->children) children->push_back(std::move(child));
  }

  std::optional<SourceElement> ParseIncluded(const std::filesystem::path& path,
                                             const std::string& name) {
    const std::string text = ReadFile(path, kMaxIncludedBytes - num_bytes_);
    num_bytes_ += text.size();
    // The root of an included file may also be called mujocoinclude.
    const bool is_part = text.find("<mujocoinclude") != std::string::npos;
    return ParseSource(text, name, is_part ? "mujocoinclude" : "mujoco", &findings_);
  }

  const ModelFiles& files_;
  ImportFindings& findings_;
  std::set<std::filesystem::path> included_;
  std::size_t num_bytes_ = 0;
};

/// Reads the sections of a model and the tree of its bodies.
class MjcfReader {
 public:
  MjcfReader(const SourceElement& root, ModelFiles* files, ImportFindings* findings)
      : root_(root), findings_(*findings) {
    context_.mesh_shapes = &mesh_shapes_;
    context_.files = files;
    context_.findings = findings;
  }

  ForeignWorld Read() {
    if (const std::string* name = root_.FindAttribute("model")) world_.name = *name;
    for (const SourceElement& section : root_.children) ReadSettings(section);
    for (const SourceElement& section : root_.children) {
      if (section.name == "worldbody") {
        ReadContent(section, RigidTransform(), "", -1);
      } else {
        RemarkSection(section);
      }
    }
    return std::move(world_);
  }

 private:
  void ReadSettings(const SourceElement& section) {
    if (section.name == "compiler") {
      ReadMjcfCompiler(section, &findings_, &context_.compiler);
    } else if (section.name == "default") {
      context_.defaults.Add(section, &findings_);
    } else if (section.name == "asset") {
      for (const SourceElement& asset : section.children) ReadAsset(asset);
    }
  }

  void ReadAsset(const SourceElement& asset) {
    const std::string* name = asset.FindAttribute("name");
    if (asset.name == "mesh") {
      const std::string* file = asset.FindAttribute("file");
      const std::string stem = file ? std::filesystem::path(*file).stem().string() : "";
      context_.meshes[name ? *name : stem] = &asset;
    } else if (asset.name == "material" && name) {
      context_.materials[*name] = &asset;
    } else {
      findings_.Remark(asset.place(), "left out: an asset that scenes have no use for");
    }
  }

  /// Remarks what a section says that a scene cannot.
  void RemarkSection(const SourceElement& section) {
    const std::string& name = section.name;
    if (name == "compiler" || name == "default" || name == "asset") return;
    if (name == "option") return RemarkOptions(section);
    if (name == "statistic" || name == "visual" || name == "size") {
      return findings_.Remark(section.place(), "left out: settings of MuJoCo and its viewer");
    }
    for (const SourceElement& child : section.children) {
      findings_.Remark(child.place(), "left out: SMILE has no counterpart of what is in " +
                                          Printable(name.substr(0, 60)));
    }
  }

  void RemarkOptions(const SourceElement& option) {
    ElementReader reader(option, &findings_);
    const Vector3 gravity = reader.Vector("gravity", {0, 0, -9.81});
    if (!gravity.isApprox(Vector3(0, 0, -9.81), 1e-3)) {
      reader.Remark("changed: gravity is 9.81 m/s2 downwards in SMILE");
    }
    reader.RemarkRest({"timestep", "cone", "impratio", "integrator", "solver", "iterations",
                       "tolerance", "noslip_iterations", "jacobian"});
  }

  /// Reads what is inside a body, the world or a frame F.
  /// @param body  index; -1: the world.
  void ReadContent(const SourceElement& parent, const RigidTransform& X_WF,
                   const std::string& child_class, int body) {
    for (const SourceElement& child : parent.children) {
      const std::string* own = child.FindAttribute("childclass");
      const std::string& its_class = own ? *own : child_class;
      if (child.name == "body") {
        ReadBody(child, X_WF, its_class, body);
      } else if (child.name == "frame") {
        ElementReader reader(child, &findings_);
        ReadContent(child, X_WF * MjcfPoseOf(&reader, context_.compiler), its_class, body);
      } else if (child.name == "geom") {
        ReadGeom(child, X_WF, child_class, body);
      } else {
        ReadOther(child, X_WF, child_class, body);
      }
    }
  }

  void ReadOther(const SourceElement& child, const RigidTransform& X_WF,
                 const std::string& child_class, int body) {
    if (child.name == "joint" || child.name == "freejoint" || child.name == "inertial") {
      if (body < 0) findings_.Refuse(child.place(), "found it in worldbody, expected a body");
    } else if (child.name == "camera" && body < 0) {
      ReadCamera(child, X_WF, child_class);
    } else if (child.name == "light" && body < 0) {
      ReadLight(child, X_WF, child_class);
    } else {
      findings_.Remark(child.place(), "left out: SMILE has no counterpart of it here");
    }
  }

  void ReadBody(const SourceElement& element, const RigidTransform& X_WP,
                const std::string& child_class, int parent) {
    if (world_.bodies.size() == kMaxBodies) {
      return findings_.Refuse(element.place(),
                              "found more than " + std::to_string(kMaxBodies) + " bodies");
    }
    ElementReader reader(element, &findings_);
    ForeignBody body{.place = reader.place(), .name = reader.Text("name"), .parent = parent};
    body.X_WB = X_WP * MjcfPoseOf(&reader, context_.compiler);
    if (reader.Text("mocap") == "true") reader.Remark("changed: a mocap body, which stands fast");
    reader.RemarkRest({"childclass"});
    ReadJoints(element, child_class, &body);
    ReadInertial(element, &body);
    const int index = static_cast<int>(world_.bodies.size());
    world_.bodies.push_back(body);
    ReadContent(element, body.X_WB, child_class, index);
  }

  void ReadJoints(const SourceElement& element, const std::string& child_class, ForeignBody* body) {
    std::vector<SourceElement> joints;
    for (const SourceElement& child : element.children) {
      if (child.name != "joint" && child.name != "freejoint") continue;
      joints.push_back(context_.defaults.Completed(child, child_class, &findings_));
    }
    if (joints.empty()) return;
    body->joint = JointOf(joints[0], *body);
    if (joints.size() == 1) return;
    body->joint.kind = ForeignJointKind::kOther;
    body->joint.word = "group of " + std::to_string(joints.size()) + " joints";
  }

  ForeignJoint JointOf(const SourceElement& element, const ForeignBody& body) {
    ElementReader reader(element, &findings_);
    const bool is_free = element.name == "freejoint";
    ForeignJoint joint{.place = reader.place(),
                       .word = reader.Text("type", is_free ? "free" : "hinge")};
    if (joint.word == "free") joint.kind = ForeignJointKind::kFree;
    if (joint.word == "hinge" || joint.word == "ball") joint.kind = ForeignJointKind::kOther;
    if (joint.word == "slide") ReadSlide(&reader, body, &joint);
    if (joint.word == "free") reader.RemarkRest({"class", "group", "align", "user"});
    if (joint.kind == ForeignJointKind::kFixed) {
      reader.Refuse("found type=" + Quoted(joint.word) + ", expected free, ball, slide or hinge");
    }
    return joint;
  }

  void ReadSlide(ElementReader* reader, const ForeignBody& body, ForeignJoint* joint) {
    joint->kind = ForeignJointKind::kSlide;
    const Vector3 axis = reader->Vector("axis", Vector3::UnitZ());
    if (!(axis.norm() > 1e-9)) return reader->Refuse("found an axis of length 0");
    joint->axis_in_world = body.X_WB.rotation() * axis.normalized();
    joint->position = reader->Number("ref", 0);
    joint->damping = reader->Number("damping", 0);
    const std::vector<double> range = reader->Numbers("range", 2, 2);
    const std::string limited = reader->Text("limited", "auto");
    const bool is_limited =
        limited == "true" || (limited == "auto" && context_.compiler.has_automatic_limits);
    if (!range.empty() && is_limited) {
      joint->lower = range[0];
      joint->upper = range[1];
    }
    reader->RemarkRest({"class", "pos", "user"});
  }

  void ReadInertial(const SourceElement& element, ForeignBody* body) {
    const SourceElement* inertial = element.FindChild("inertial");
    if (!inertial || context_.compiler.ignores_inertial) return;
    ElementReader reader(*inertial, &findings_);
    const RigidTransform X_BI = MjcfPoseOf(&reader, context_.compiler);
    ForeignMass mass{.mass = reader.Number("mass", -1), .p_BBcm = X_BI.translation()};
    IsMass(mass.mass, reader.place(), &findings_);
    const std::vector<double> full = reader.Numbers("fullinertia", 6, 6);
    const std::vector<double> diagonal = reader.Numbers("diaginertia", 3, 3);
    Matrix3 I = Matrix3::Zero();
    if (!diagonal.empty()) I.diagonal() << diagonal[0], diagonal[1], diagonal[2];
    if (!full.empty()) {
      I << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
    }
    const Matrix3& R = X_BI.rotation();
    mass.inertia = R * I * R.transpose();
    body->mass = mass;
    reader.RemarkRest();
  }

  /// Reads a geom of a body; one of the world is a body of its own.
  void ReadGeom(const SourceElement& element, const RigidTransform& X_WF,
                const std::string& child_class, int body) {
    const SourceElement geom = context_.defaults.Completed(element, child_class, &findings_);
    std::vector<ForeignShape> shapes = MjcfShapesOf(geom, context_);
    if (shapes.empty()) return;
    if (body < 0) {
      if (world_.bodies.size() == kMaxBodies) return;
      world_.bodies.push_back({.place = geom.place(), .name = shapes[0].name, .X_WB = X_WF});
      world_.bodies.back().shapes = std::move(shapes);
      return;
    }
    ForeignBody& owner = world_.bodies[static_cast<std::size_t>(body)];
    MoveShapes(owner.X_WB.inverse() * X_WF, &shapes);
    if (owner.shapes.size() + shapes.size() > kMaxShapesOfBody) {
      return findings_.Refuse(geom.place(), "found more than " + std::to_string(kMaxShapesOfBody) +
                                                " shapes in a body");
    }
    owner.shapes.insert(owner.shapes.end(), shapes.begin(), shapes.end());
  }

  void ReadCamera(const SourceElement& element, const RigidTransform& X_WF,
                  const std::string& child_class) {
    const SourceElement completed = context_.defaults.Completed(element, child_class, &findings_);
    ElementReader reader(completed, &findings_);
    const RigidTransform X_FM = MjcfPoseOf(&reader, context_.compiler);
    // MuJoCo's cameras have y up and look along -z.
    const RigidTransform X_MC(Matrix3(Vector3(1, -1, -1).asDiagonal()), Vector3::Zero());
    const std::string mode = reader.Text("mode", "fixed");
    if (mode != "fixed") {
      return reader.Remark("left out: a camera that is not fixed, mode=" + Quoted(mode));
    }
    world_.cameras.push_back(
        {.place = reader.place(),
         .name = reader.Text("name"),
         .X_WC = X_WF * X_FM * X_MC,
         .vertical_field_of_view = reader.Number("fovy", 45) * std::numbers::pi / 180});
    reader.RemarkRest({"resolution", "class", "user", "ipd"});
  }

  void ReadLight(const SourceElement& element, const RigidTransform& X_WF,
                 const std::string& child_class) {
    const SourceElement completed = context_.defaults.Completed(element, child_class, &findings_);
    ElementReader reader(completed, &findings_);
    if (reader.Text("directional") != "true" && reader.Text("type") != "directional") {
      return reader.Remark("left out: a light that is not directional");
    }
    const Vector3 direction = reader.Vector("dir", {0, 0, -1});
    const Vector3 diffuse = reader.Vector("diffuse", {0.7, 0.7, 0.7}) / kUsualDiffuse;
    world_.lights.push_back({.place = reader.place(),
                             .direction_in_world = X_WF.rotation() * direction,
                             .color = {diffuse.x(), diffuse.y(), diffuse.z()}});
    // A directional light has no place.
    reader.RemarkRest({"class", "pos", "active"});
  }

  const SourceElement& root_;
  ImportFindings& findings_;
  std::map<std::string, std::vector<ForeignShape>> mesh_shapes_;
  MjcfContext context_;
  ForeignWorld world_;
};

}  // namespace

ForeignWorld ReadMjcf(const SourceElement& root, ModelFiles* files, ImportFindings* findings) {
  SourceElement expanded = root;
  MjcfInclusion(*files, findings).Expand(&expanded);
  findings->ThrowIfRefused();
  return MjcfReader(expanded, files, findings).Read();
}

}  // namespace smile::scene_import

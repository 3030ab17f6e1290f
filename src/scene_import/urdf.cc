#include <map>
#include <set>

#include "base/wording.h"
#include "scene_import/internal_link_shapes.h"
#include "scene_import/internal_model_readers.h"
#include "scene_import/internal_shapes.h"

// Reads URDF: http://wiki.ros.org/urdf/XML

namespace smile::scene_import {
namespace {

constexpr const char* kWorldLink = "world";

/// Returns a child element; an empty one if it is missing.
const SourceElement& ChildOrNone(const SourceElement& element, std::string_view name,
                                 const SourceElement& none) {
  const SourceElement* child = element.FindChild(name);
  return child ? *child : none;
}

class UrdfReader {
 public:
  UrdfReader(const SourceElement& root, ModelFiles* files, ImportFindings* findings)
      : root_(root), files_(*files), findings_(*findings) {
    none_.file = root.file;
    none_.line = root.line;
  }

  ForeignWorld Read() {
    for (const SourceElement& child : root_.children) Sort(child);
    const std::string root_link = RootLink();
    findings_.ThrowIfRefused();
    AddTree(root_link);
    findings_.Remark(root_.place(),
                     "changed: URDF has no friction; objects have 0.6, as the table");
    for (const auto& [name, link] : links_) {
      if (!indices_.contains(name)) {
        findings_.Refuse(link->place(), "found joints in a circle, expected a tree of links");
      }
    }
    return std::move(world_);
  }

 private:
  void Sort(const SourceElement& child) {
    ElementReader reader(child, &findings_);
    const std::string name = reader.Text("name");
    if (child.name == "link") {
      if (!links_.emplace(name, &child).second) reader.Refuse("found the name of another link");
    } else if (child.name == "joint") {
      const std::string its_link = LinkOf(child, "child");
      if (!joints_.emplace(its_link, &child).second) {
        reader.Refuse("found a second joint of the link " + Quoted(its_link));
      }
      children_[LinkOf(child, "parent")].push_back(its_link);
    } else if (child.name == "material") {
      materials_[name] = ColorOfMaterial(child);
    } else {
      reader.Remark("left out: SMILE has no counterpart of it");
    }
  }

  std::string LinkOf(const SourceElement& joint, std::string_view role) {
    return ElementReader(ChildOrNone(joint, role, none_), &findings_).Text("link");
  }

  std::string RootLink() {
    std::string root;
    for (const auto& [name, link] : links_) {
      if (joints_.contains(name)) continue;
      if (!root.empty()) {
        findings_.Refuse(link->place(), "found a second link without a joint, beside " +
                                            Quoted(root) + ", expected one tree");
      }
      root = name;
    }
    for (const auto& [name, joint] : joints_) {
      if (!links_.contains(name) || !links_.contains(LinkOf(*joint, "parent"))) {
        findings_.Refuse(joint->place(), "found a parent or child that is no link");
      }
    }
    if (root.empty()) findings_.Refuse(root_.place(), "found no link that is the root of a tree");
    return root;
  }

  /// Adds links, parents first. Each link has one joint, so that none comes twice.
  void AddTree(const std::string& root_link) {
    std::vector<std::string> waiting{root_link};
    while (!waiting.empty()) {
      const std::string name = waiting.back();
      waiting.pop_back();
      AddLink(name);
      const std::vector<std::string>& next = children_[name];
      waiting.insert(waiting.end(), next.rbegin(), next.rend());
    }
  }

  void AddLink(const std::string& name) {
    const SourceElement& link = *links_.at(name);
    ForeignBody body{.place = link.place(), .name = name};
    const auto joint = joints_.find(name);
    if (joint != joints_.end()) {
      ReadJoint(*joint->second, &body);
    } else if (name != kWorldLink && link.FindChild("inertial")) {
      body.joint.kind = ForeignJointKind::kFree;
    }
    ReadInertial(link, &body);
    for (const SourceElement& child : link.children) ReadLinkPart(child, &body);
    const bool is_world = name == kWorldLink && joint == joints_.end();
    indices_[name] = is_world ? -1 : static_cast<int>(world_.bodies.size());
    if (world_.bodies.size() == kMaxBodies) {
      return findings_.Refuse(body.place, "found more links than the import allows");
    }
    if (!is_world || !body.shapes.empty()) world_.bodies.push_back(std::move(body));
  }

  void ReadJoint(const SourceElement& element, ForeignBody* body) {
    ElementReader reader(element, &findings_);
    body->parent = indices_.at(LinkOf(element, "parent"));
    const RigidTransform X_WP = body->parent < 0
                                    ? RigidTransform()
                                    : world_.bodies[static_cast<std::size_t>(body->parent)].X_WB;
    body->X_WB = X_WP * OriginOf(element);
    ForeignJoint& joint = body->joint;
    joint.place = reader.place();
    joint.word = reader.Text("type");
    if (joint.word == "fixed") return;
    joint.kind = ForeignJointKind::kOther;
    if (joint.word == "floating") joint.kind = ForeignJointKind::kFree;
    if (joint.word == "prismatic") ReadPrismatic(element, body);
    const std::set<std::string> others{"floating", "prismatic", "revolute", "continuous", "planar"};
    if (!others.contains(joint.word)) {
      reader.Refuse("found type=" + Quoted(joint.word) +
                    ", expected fixed, floating, prismatic, revolute, continuous or planar");
    }
  }

  void ReadPrismatic(const SourceElement& element, ForeignBody* body) {
    ForeignJoint& joint = body->joint;
    joint.kind = ForeignJointKind::kSlide;
    ElementReader axis(ChildOrNone(element, "axis", none_), &findings_);
    const Vector3 direction = axis.Vector("xyz", Vector3::UnitX());
    if (!(direction.norm() > 1e-9)) return axis.Refuse("found an axis of length 0");
    joint.axis_in_world = body->X_WB.rotation() * direction.normalized();
    ElementReader limit(ChildOrNone(element, "limit", none_), &findings_);
    joint.lower = limit.Number("lower", 0);
    joint.upper = limit.Number("upper", 0);
    ElementReader dynamics(ChildOrNone(element, "dynamics", none_), &findings_);
    joint.damping = dynamics.Number("damping", 0);
    if (element.FindChild("mimic")) findings_.Remark(element.place(), "left out: its mimic");
  }

  RigidTransform OriginOf(const SourceElement& element) {
    ElementReader reader(ChildOrNone(element, "origin", none_), &findings_);
    const Vector3 p = reader.Vector("xyz", Vector3::Zero());
    const Vector3 rpy = reader.Vector("rpy", Vector3::Zero());
    IsPosition(p, reader.place(), &findings_);
    return {RollPitchYawRotation(rpy.x(), rpy.y(), rpy.z()), p};
  }

  void ReadInertial(const SourceElement& link, ForeignBody* body) {
    // A link without a mass adds none.
    body->mass = ForeignMass();
    const SourceElement* inertial = link.FindChild("inertial");
    if (!inertial) return;
    const RigidTransform X_BI = OriginOf(*inertial);
    ElementReader mass(ChildOrNone(*inertial, "mass", none_), &findings_);
    body->mass->mass = mass.Number("value", 0);
    body->mass->p_BBcm = X_BI.translation();
    IsMass(body->mass->mass, mass.place(), &findings_);
    ElementReader inertia(ChildOrNone(*inertial, "inertia", none_), &findings_);
    const auto part = [&inertia](const char* name) { return inertia.Number(name, 0); };
    Matrix3 I;
    I << part("ixx"), part("ixy"), part("ixz"), part("ixy"), part("iyy"), part("iyz"), part("ixz"),
        part("iyz"), part("izz");
    body->mass->inertia = X_BI.rotation() * I * X_BI.rotation().transpose();
  }

  void ReadLinkPart(const SourceElement& part, ForeignBody* body) {
    if (part.name == "inertial") return;
    if (part.name != "visual" && part.name != "collision") {
      return findings_.Remark(part.place(), "left out: SMILE has no counterpart of it");
    }
    ElementReader reader(part, &findings_);
    ForeignShape traits{.place = part.place(), .name = reader.Text("name")};
    traits.collides = part.name == "collision";
    traits.is_seen = !traits.collides;
    if (const SourceElement* material = part.FindChild("material")) {
      traits.color = ColorOfMaterial(*material);
    }
    const SourceElement& geometry = ChildOrNone(part, "geometry", none_);
    if (geometry.children.empty()) return reader.Refuse("found no geometry");
    AddLinkShapes(OriginOf(part), ShapesOf(geometry.children[0], traits.collides), traits, body,
                  &findings_);
  }

  std::vector<ForeignShape> ShapesOf(const SourceElement& shape, bool collides) {
    ElementReader reader(shape, &findings_);
    if (shape.name == "mesh") return MeshShapes(&reader, collides);
    if (shape.name == "box") {
      const Vector3 size = reader.Vector("size", Vector3::Zero());
      if (!AreSpans({size.x(), size.y(), size.z()}, reader.place(), &findings_)) return {};
      return {BlockShape(size)};
    }
    const double radius = reader.Number("radius", 0);
    const double length = shape.name == "sphere" ? 1 : reader.Number("length", 0);
    if (!AreSpans({radius, length}, reader.place(), &findings_)) return {};
    if (shape.name == "sphere") return {SphereShape(radius)};
    if (shape.name == "cylinder") return {CylinderShape(radius, length)};
    if (shape.name == "capsule") return CapsuleShapes(radius, length);
    reader.Refuse("found " + Quoted(shape.name) +
                  ", expected box, cylinder, sphere, capsule or mesh");
    return {};
  }

  std::vector<ForeignShape> MeshShapes(ElementReader* mesh, bool collides) {
    if (!collides) {
      mesh->Remark("left out: a mesh that is only seen; SMILE shows what collides");
      return {};
    }
    const Vector3 scale = mesh->Vector("scale", {1, 1, 1});
    if (!(scale.cwiseAbs().minCoeff() > 1e-9) || scale.cwiseAbs().maxCoeff() > kMaxLength) {
      mesh->Refuse("found a scale of 0 or beyond 1e5");
      return {};
    }
    const auto shape = files_.MeshShape(FileNameOfUri(mesh->Text("filename"), files_), scale,
                                        mesh->place(), &findings_);
    return shape ? std::vector{*shape} : std::vector<ForeignShape>();
  }

  /// Returns the color of a material, which may stand elsewhere in the file.
  std::optional<Color> ColorOfMaterial(const SourceElement& material) {
    if (material.FindChild("texture")) {
      findings_.Remark(material.place(), "left out: its texture; SMILE paints in plain colors");
    }
    if (const SourceElement* color = material.FindChild("color")) {
      return ColorOfNumbers(ElementReader(*color, &findings_).Numbers("rgba", 4, 4));
    }
    const std::string* name = material.FindAttribute("name");
    const auto known = materials_.find(name ? *name : "");
    return known == materials_.end() ? std::nullopt : known->second;
  }

  const SourceElement& root_;
  ModelFiles& files_;
  ImportFindings& findings_;
  SourceElement none_{.name = "robot"};
  std::map<std::string, const SourceElement*> links_;   // by name
  std::map<std::string, const SourceElement*> joints_;  // by child
  std::map<std::string, std::vector<std::string>> children_;
  std::map<std::string, std::optional<Color>> materials_;
  std::map<std::string, int> indices_;  // of bodies
  ForeignWorld world_;
};

}  // namespace

ForeignWorld ReadUrdf(const SourceElement& root, ModelFiles* files, ImportFindings* findings) {
  return UrdfReader(root, files, findings).Read();
}

}  // namespace smile::scene_import

#include "robot/internal_model_builder.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <iterator>
#include <set>
#include <type_traits>

#include "base/wording.h"
#include "robot/internal_urdf_values.h"

// Makes a RobotModel of one URDF or several: depth first from the root. Links behind fixed joints
// merge with the moving link that carries them: their shapes, masses and frames are expressed in
// its frame L. What remains are links with one degree of freedom each.

namespace smile::robot::internal {
namespace {

// Limits of the whole robot: shapes, and named frames.
constexpr std::size_t kMaxSolids = 4096;
constexpr std::size_t kMaxFrames = 2048;

/// Mass properties of all links that are fixed to one moving link L, summed about L's origin.
struct MassSum {
  const UrdfPart* part = nullptr;     ///< part of the moving link …
  std::string name;                   ///< … and its name there
  double mass = 0;                    ///< [kg]
  Vector3 moment = Vector3::Zero();   ///< sum of mass * p_LLcm [kg m]
  Matrix3 inertia = Matrix3::Zero();  ///< along L's axes [kg m2]

  // Returns the inertia of a point mass at p about the origin (parallel axis theorem).
  static Matrix3 OfPoint(double mass, const Vector3& p) {
    return mass * (p.squaredNorm() * Matrix3::Identity() - p * p.transpose());
  }
  void Add(const UrdfInertial& piece, const RigidTransform& X_LI) {
    const Matrix3& R_LI = X_LI.rotation();
    const Vector3& p_LI = X_LI.translation();
    mass += piece.mass;
    moment += piece.mass * p_LI;
    inertia += R_LI * piece.inertia * R_LI.transpose() + OfPoint(piece.mass, p_LI);
  }
};

class ModelBuilder {
 public:
  ModelBuilder(const std::vector<UrdfPart>& parts, bool has_shapes, RobotFileSet* files)
      : parts_(parts), has_shapes_(has_shapes), files_(*files) {}

  BuiltModel Build() {
    built_.is_used.resize(parts_.size());
    const urdf::ModelInterface& main = parts_[0].document->model();
    model().name = main.getName();
    AddLink(parts_[0], *main.getRoot(), -1, RigidTransform());
    // Masses are complete only when all fixed attachments have been added.
    for (std::size_t i = 0; i < masses_.size(); ++i) FinishMass(masses_[i], &model().links[i]);
    for (const scene::LinkSpec& link : model().links) {
      // A side file may replace this start.
      model().q_start.push_back(std::clamp(0.0, link.lower, link.upper));
    }
    return std::move(built_);
  }

 private:
  /// A joint below a link, in the link's file or in that of an attached part.
  struct Branch {
    std::string name;
    const UrdfPart* part;
    const urdf::Joint* joint;
    const urdf::Link* child;
  };

  RobotModel& model() { return built_.model; }

  /// Adds a link, its fixed attachments and its joints.
  /// @param carrier  the moving link L that carries this one, whose frame is F; -1 = the base.
  void AddLink(const UrdfPart& part, const urdf::Link& link, int carrier,
               const RigidTransform& X_LF) {
    const std::string name = part.prefix + link.name;
    const UrdfElement element(*part.document, "link", link.name);
    const bool is_new = names_.insert(name).second;
    if (!is_new) element.Fail("link " + Quoted(name) + " already exists");
    if (names_.size() > kMaxFrames) {
      element.Fail("the robot has more than " + std::to_string(kMaxFrames) + " links");
    }
    const int frame = static_cast<int>(model().frames.size());
    // Frames of merged links stay addressable by name, for tools, cameras and attachments.
    model().frames.push_back({name, carrier, X_LF});
    AddContents(part, link, carrier, X_LF);
    std::vector<Branch> branches = BranchesOf(part, link);
    // Parts attached to this link: their roots merge with it.
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      const UrdfPart& hung = parts_[i];
      if (hung.to != name) continue;
      const urdf::Link& root = *hung.document->model().getRoot();
      built_.is_used[i] = true;
      built_.part_roots.emplace_back(hung.prefix + root.name, frame);
      AddContents(hung, root, carrier, X_LF);
      std::ranges::move(BranchesOf(hung, root), std::back_inserter(branches));
    }
    // Sorted by name: indices of links must not depend on the order in files.
    std::ranges::stable_sort(branches, {}, &Branch::name);
    for (const Branch& branch : branches) AddJoint(branch, carrier, X_LF);
  }

  static std::vector<Branch> BranchesOf(const UrdfPart& part, const urdf::Link& link) {
    std::vector<Branch> branches;
    for (std::size_t i = 0; i < link.child_joints.size(); ++i) {
      const urdf::Joint& joint = *link.child_joints[i];
      branches.push_back({part.prefix + joint.name, &part, &joint, link.child_links[i].get()});
    }
    return branches;
  }

  void AddContents(const UrdfPart& part, const urdf::Link& link, int carrier,
                   const RigidTransform& X_LF) {
    const UrdfElement element(*part.document, "link", link.name);
    if (has_shapes_) AddShapes(part, link, element, carrier, X_LF);
    // The base never moves, so its mass does not matter.
    if (!link.inertial || carrier < 0) return;
    const UrdfInertial piece = element.ReadInertial(*link.inertial);
    masses_[static_cast<std::size_t>(carrier)].Add(piece, X_LF * piece.X_FI);
  }

  void AddShapes(const UrdfPart& part, const urdf::Link& link, const UrdfElement& element,
                 int carrier, const RigidTransform& X_LF) {
    for (const auto& collision : link.collision_array) {
      auto& solids = carrier < 0 ? model().base_solids : model().links[carrier].solids;
      for (scene::Solid solid :
           SolidsOf(part, element, collision->geometry.get(), collision->origin)) {
        Count(element);
        solid.X_BS = X_LF * solid.X_BS;
        solids.push_back(std::move(solid));
      }
    }
    for (const auto& visual : link.visual_array) {
      Count(element);
      LinkVisual drawn{.link = carrier, .shape = {}, .color = {}, .X_LV = {}};
      if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(visual->geometry.get())) {
        const Vector3 scale = element.ReadScale(*mesh);
        // Drawn as it is; only collision shapes are cut into convex pieces.
        drawn.shape = scene::DrawnMesh{FetchMesh(
            element, *mesh, [&] { return files_.FetchDrawn(part.file, mesh->filename, scale); })};
        drawn.X_LV = X_LF * element.ReadPose(visual->origin);
      } else {
        const scene::Solid solid = element.ReadSolid(visual->geometry.get(), visual->origin);
        drawn.shape = scene::VisualShapeOf(solid.shape);
        drawn.X_LV = X_LF * solid.X_BS;
      }
      drawn.color = ColorOf(part, element, *visual);
      model().visuals.push_back(std::move(drawn));
    }
  }

  static Color ColorOf(const UrdfPart& part, const UrdfElement& element,
                       const urdf::Visual& visual) {
    const std::string& material = visual.material_name;
    if (!material.empty() && !part.document->model().getMaterial(material)) {
      element.Fail("material " + Quoted(material) + " is not defined");
    }
    // Textures are not read; the parser's color beside one is black unless it is specified.
    if (!visual.material || !visual.material->texture_filename.empty()) return {};
    return element.ReadColor(visual.material->color);
  }

  std::vector<scene::Solid> SolidsOf(const UrdfPart& part, const UrdfElement& element,
                                     const urdf::Geometry* geometry, const urdf::Pose& origin) {
    const auto* mesh = dynamic_cast<const urdf::Mesh*>(geometry);
    if (!mesh) return {element.ReadSolid(geometry, origin)};
    const Vector3 scale = element.ReadScale(*mesh);
    const RigidTransform X_FS = element.ReadPose(origin);
    std::vector<scene::Solid> solids;
    FetchMesh(element, *mesh, [&] {
      for (const scene::Hull& hull : files_.FetchPieces(part.file, mesh->filename, scale)) {
        solids.push_back({.shape = hull, .X_BS = X_FS});
      }
      return 0;
    });
    return solids;
  }

  template <class Fetch>
  static std::invoke_result_t<Fetch> FetchMesh(const UrdfElement& element, const urdf::Mesh& mesh,
                                               Fetch fetch) {
    try {
      return fetch();
    } catch (const BadReference& error) {
      element.Fail("the mesh " + Quoted(mesh.filename) + error.what());
    }
  }

  void Count(const UrdfElement& element) {
    if (++num_shapes_ <= kMaxSolids) return;
    element.Fail("the robot has more than " + std::to_string(kMaxSolids) + " shapes");
  }

  void AddJoint(const Branch& branch, int parent, const RigidTransform& X_PF) {
    const UrdfPart& part = *branch.part;
    const urdf::Joint& joint = *branch.joint;
    const UrdfElement element(*part.document, "joint", joint.name);
    // P is the moving link that carries the joint, and F the frame of the parent link in the file.
    const RigidTransform X_PJ = X_PF * element.ReadPose(joint.parent_to_joint_origin_transform);
    // A link behind a fixed joint merges with the link that carries it.
    if (joint.type == urdf::Joint::FIXED) return AddLink(part, *branch.child, parent, X_PJ);

    scene::LinkSpec link;
    link.name = part.prefix + branch.child->name;
    link.joint_name = branch.name;
    // The parent comes earlier in the list, so parents precede children.
    link.parent = parent;
    link.X_PJ = X_PJ;
    // Prefixes of attached parts could make names equal.
    if (FindJoint(model(), link.joint_name)) {
      element.Fail("joint " + Quoted(link.joint_name) + " already exists");
    }
    element.ReadMotion(joint, &link);
    if (joint.mimic) {
      built_.mimics.push_back({branch.name, part.prefix + joint.mimic->joint_name,
                               joint.mimic->multiplier, joint.mimic->offset});
    }
    model().links.push_back(std::move(link));
    // Before AddLink(), which adds the masses of the child to it.
    masses_.push_back({.part = &part, .name = branch.child->name});
    AddLink(part, *branch.child, model().num_joints() - 1, RigidTransform());
  }

  /// Converts the sum about the link's origin to the center of mass (parallel axis theorem), and
  /// checks it.
  static void FinishMass(const MassSum& sum, scene::LinkSpec* link) {
    const UrdfElement element(*sum.part->document, "link", sum.name);
    if (!(sum.mass > 0)) {
      element.Fail("it moves but has no mass, expected <inertial> with a mass above 0");
    }
    link->mass = sum.mass;
    link->p_LLcm = sum.moment / sum.mass;
    link->inertia = sum.inertia - MassSum::OfPoint(sum.mass, link->p_LLcm);
    // Principal moments of a body are positive; others would make the dynamics unstable.
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(link->inertia, Eigen::EigenvaluesOnly);
    if (!(solver.eigenvalues().minCoeff() > 0)) {
      element.Fail("inertia is not positive definite, expected that of a body");
    }
  }

  const std::vector<UrdfPart>& parts_;
  const bool has_shapes_;
  RobotFileSet& files_;
  BuiltModel built_;
  std::set<std::string> names_;
  std::vector<MassSum> masses_;  ///< one for each moving link
  std::size_t num_shapes_ = 0;
};

}  // namespace

BuiltModel BuildModel(const std::vector<UrdfPart>& parts, bool has_shapes, RobotFileSet* files) {
  return ModelBuilder(parts, has_shapes, files).Build();
}

}  // namespace smile::robot::internal

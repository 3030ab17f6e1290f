#include "robot/urdf_reader.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <string>
#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "robot/internal_side_file.h"
#include "robot/internal_urdf_parse.h"
#include "robot/internal_urdf_values.h"

namespace smile::robot {
namespace {

using internal::UrdfDocument;
using internal::UrdfElement;
using internal::UrdfInertial;

constexpr std::size_t kMaxFileBytes = 4 << 20;
constexpr std::size_t kMaxSolids = 4096;

/// What hangs rigidly together on one moving link L, summed up about L's origin.
struct MassSum {
  double mass = 0;                    ///< [kg]
  Vector3 moment = Vector3::Zero();   ///< sum of mass * p_LLcm [kg m]
  Matrix3 inertia = Matrix3::Zero();  ///< along L's axes [kg m2]

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

/// Walks the tree from the root and puts everything where it belongs.
class ModelBuilder {
 public:
  explicit ModelBuilder(const UrdfDocument& document) : document_(document) {}

  RobotModel Build() {
    model_.name = document_.model().getName();
    AddLink(*document_.model().getRoot(), -1, RigidTransform());
    for (std::size_t i = 0; i < masses_.size(); ++i) FinishMass(masses_[i], &model_.links[i]);
    for (const physics::LinkSpec& link : model_.links) {
      model_.q_start.push_back(std::clamp(0.0, link.lower, link.upper));
    }
    return std::move(model_);
  }

 private:
  /// @param carrier  the moving link L that carries this one, whose frame is F; -1 = the base.
  void AddLink(const urdf::Link& link, int carrier, const RigidTransform& X_LF) {
    const UrdfElement element(document_, "link", link.name);
    model_.frames.push_back({link.name, carrier, X_LF});
    AddShapes(link, element, carrier, X_LF);
    // The base never moves: what it weighs does not matter.
    if (link.inertial && carrier >= 0) {
      const UrdfInertial piece = element.ReadInertial(*link.inertial);
      masses_[static_cast<std::size_t>(carrier)].Add(piece, X_LF * piece.X_FI);
    }
    for (std::size_t i = 0; i < link.child_joints.size(); ++i) {
      AddJoint(*link.child_joints[i], *link.child_links[i], carrier, X_LF);
    }
  }

  void AddShapes(const urdf::Link& link, const UrdfElement& element, int carrier,
                 const RigidTransform& X_LF) {
    num_solids_ += link.collision_array.size() + link.visual_array.size();
    if (num_solids_ > kMaxSolids) {
      element.Fail("the robot has more than " + std::to_string(kMaxSolids) + " shapes");
    }
    for (const auto& collision : link.collision_array) {
      scene::Solid solid = element.ReadSolid(collision->geometry.get(), collision->origin);
      solid.X_BS = X_LF * solid.X_BS;
      (carrier < 0 ? model_.base_solids : model_.links[carrier].solids).push_back(solid);
    }
    for (const auto& visual : link.visual_array) {
      const scene::Solid solid = element.ReadSolid(visual->geometry.get(), visual->origin);
      LinkVisual drawn{
          .link = carrier, .shape = scene::VisualShapeOf(solid.shape), .X_LV = X_LF * solid.X_BS};
      const std::string& material = visual->material_name;
      if (!material.empty() && !document_.model().getMaterial(material)) {
        element.Fail("material " + Quoted(material) + " is nowhere defined");
      }
      if (visual->material) drawn.color = element.ReadColor(visual->material->color);
      model_.visuals.push_back(std::move(drawn));
    }
  }

  void AddJoint(const urdf::Joint& joint, const urdf::Link& child, int parent,
                const RigidTransform& X_PF) {
    const UrdfElement element(document_, "joint", joint.name);
    const RigidTransform X_PJ = X_PF * element.ReadPose(joint.parent_to_joint_origin_transform);
    if (joint.type == urdf::Joint::FIXED) return AddLink(child, parent, X_PJ);

    physics::LinkSpec link;
    link.name = child.name;
    link.joint_name = joint.name;
    link.parent = parent;
    link.X_PJ = X_PJ;
    element.ReadMotion(joint, &link);
    model_.links.push_back(std::move(link));
    masses_.emplace_back();
    AddLink(child, model_.num_joints() - 1, RigidTransform());
  }

  /// From the sum about the link's origin to the centre of mass (parallel-axis theorem).
  void FinishMass(const MassSum& sum, physics::LinkSpec* link) const {
    const UrdfElement element(document_, "link", link->name);
    if (!(sum.mass > 0)) {
      element.Fail("it moves but has no mass, expected <inertial> with a mass above 0");
    }
    link->mass = sum.mass;
    link->p_LLcm = sum.moment / sum.mass;
    link->inertia = sum.inertia - MassSum::OfPoint(sum.mass, link->p_LLcm);
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(link->inertia, Eigen::EigenvaluesOnly);
    if (!(solver.eigenvalues().minCoeff() > 0)) {
      element.Fail("inertia is not positive definite, expected that of a body");
    }
  }

  const UrdfDocument& document_;
  RobotModel model_;
  std::vector<MassSum> masses_;  ///< one for each moving link
  std::size_t num_solids_ = 0;
};

}  // namespace

RobotModel ReadRobot(const std::filesystem::path& urdf_path) {
  const UrdfDocument document(ReadFile(urdf_path, kMaxFileBytes), urdf_path.string());
  RobotModel model = ModelBuilder(document).Build();

  std::filesystem::path side_path = urdf_path;
  side_path.replace_extension(".robot.json");
  if (std::filesystem::exists(side_path)) internal::ReadSideFile(side_path, &model);
  return model;
}

}  // namespace smile::robot

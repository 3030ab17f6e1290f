#include "robot/baxter_look.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/wording.h"
#include "robot/internal_baxter_links.h"

namespace smile::robot {
namespace internal {

LookPiece PieceOf(const Color& color, const std::vector<scene::SurfaceMesh>& surfaces) {
  return {color, std::make_shared<const scene::CustomMesh>(
                     scene::CustomMesh{.surface = mesh::Joined(surfaces)})};
}

RigidTransform AlongMinusY() {
  Matrix3 R;
  R.col(0) = Vector3::UnitX();
  R.col(1) = Vector3::UnitZ();
  R.col(2) = -Vector3::UnitY();
  return {R, Vector3::Zero()};
}

RigidTransform AlongX() {
  Matrix3 R;
  R.col(0) = Vector3::UnitY();
  R.col(1) = Vector3::UnitZ();
  R.col(2) = Vector3::UnitX();
  return {R, Vector3::Zero()};
}

}  // namespace internal

namespace {

using internal::LinkLook;

/// Every part of the look, by the name of its link; names of arms lack their side.
struct BaxterLook {
  std::vector<std::pair<std::string, LinkLook>> body{{"torso", internal::TorsoLook()},
                                                     {"pedestal", internal::PedestalLook()},
                                                     {"head", internal::HeadLook()}};
  std::vector<std::pair<std::string, LinkLook>> arm{
      {"upper_shoulder", internal::UpperShoulderLook()},
      {"lower_shoulder", internal::LowerShoulderLook()},
      {"upper_elbow", internal::UpperElbowLook()},
      {"lower_elbow", internal::LowerElbowLook()},
      {"upper_forearm", internal::UpperForearmLook()},
      {"lower_forearm", internal::LowerForearmLook()},
      {"wrist", internal::WristLook()}};
  LinkLook palm = internal::ClassicPalmLook();
  LinkLook left_finger = internal::ClassicFingerLook(true);
  LinkLook right_finger = internal::ClassicFingerLook(false);
};

/// Made once: the meshes are large, never change, and cameras know them by their address.
const BaxterLook& Look() {
  static const BaxterLook look;
  return look;
}

void AddAt(int frame, const LinkLook& look, RobotModel* model) {
  const Frame& at = model->frames[frame];
  for (const internal::LookPiece& piece : look) {
    model->visuals.push_back({.link = at.link,
                              .shape = scene::DrawnMesh{piece.mesh},
                              .color = piece.color,
                              .X_LV = at.X_LF,
                              .mood = piece.mood});
  }
}

void AddTo(const std::string& link, const LinkLook& look, RobotModel* model) {
  const auto frame = FindFrame(*model, link);
  if (!frame) throw std::invalid_argument("the robot has no link " + Quoted(link));
  AddAt(*frame, look, model);
}

}  // namespace

void AddBaxterLook(RobotModel* model) {
  for (const auto& [link, look] : Look().body) AddTo(link, look, model);
  for (const std::string side : {"left", "right"}) {
    for (const auto& [link, look] : Look().arm) AddTo(side + "_" + link, look, model);
  }
}

void AddClassicGripperLook(const std::string& prefix, RobotModel* model) {
  AddTo(prefix + "gripper_base", Look().palm, model);
  AddTo(prefix + "gripper_left_finger", Look().left_finger, model);
  AddTo(prefix + "gripper_right_finger", Look().right_finger, model);
}

}  // namespace smile::robot

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

/// A finger of the classic gripper collides as one box.
bool IsClassicFinger(const RobotModel& model, int frame) {
  const int link = model.frames[frame].link;
  if (link < 0 || model.links[link].solids.size() != 1) return false;
  const auto* box = std::get_if<scene::Block>(&model.links[link].solids[0].shape);
  return box != nullptr && box->size == Vector3(0.04, 0.03, 0.15);
}

void AddClassicGripper(const std::string& side, RobotModel* model) {
  const auto palm = FindFrame(*model, side + "_gripper_base");
  const auto left = FindFrame(*model, side + "_gripper_left_finger");
  const auto right = FindFrame(*model, side + "_gripper_right_finger");
  if (!palm || !left || !right) return;
  if (!IsClassicFinger(*model, *left) || !IsClassicFinger(*model, *right)) return;
  AddAt(*palm, Look().palm, model);
  AddAt(*left, Look().left_finger, model);
  AddAt(*right, Look().right_finger, model);
}

}  // namespace

void AddBaxterLook(RobotModel* model) {
  for (const auto& [link, look] : Look().body) AddTo(link, look, model);
  for (const std::string side : {"left", "right"}) {
    for (const auto& [link, look] : Look().arm) AddTo(side + "_" + link, look, model);
    AddClassicGripper(side, model);
  }
}

}  // namespace smile::robot

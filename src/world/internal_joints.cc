#include "world/internal_joints.h"

#include <algorithm>

namespace smile::world {
namespace {

/// Distance of a chain's anchor from the middle of an end piece, towards the other end [units].
constexpr double kEndAnchorUnits = 0.1;
/// Members of a slider that initially overlap by more than this do not collide [m].
constexpr double kMaxMemberOverlap = 0.001;

void AddBall(physics::BodyId a, const Vector3& p_AQ, physics::BodyId b, const Vector3& p_BQ,
             physics::World* world) {
  // A joint between two bodies that never move has no effect, and the solver no unknowns for it.
  if (world->body(a).is_static() && world->body(b).is_static()) return;
  world->AddJoint(physics::BallJointSpec{.a = a, .b = b, .p_AQ = p_AQ, .p_BQ = p_BQ});
}

}  // namespace

void AddChainJoints(const scene::ChainSpec& chain, double meters_per_unit,
                    const std::vector<Object>& objects, physics::World* world) {
  const physics::BodyId start = objects[chain.first_object].body;
  const physics::BodyId end = objects[chain.first_object + 1].body;
  // Links extend along their y axis.
  const Vector3 to_end(0, chain.link_size.y() / 2, 0);
  const Vector3 anchor(0, kEndAnchorUnits * meters_per_unit, 0);
  // The scene lists both end pieces before the links.
  const std::size_t first_link = chain.first_object + 2;
  physics::BodyId previous = start;
  Vector3 p_PreviousQ = anchor;
  for (std::size_t i = 0; i < chain.link_ids.size(); ++i) {
    const physics::BodyId link = objects[first_link + i].body;
    AddBall(previous, p_PreviousQ, link, -to_end, world);
    previous = link;
    p_PreviousQ = to_end;
  }
  AddBall(previous, p_PreviousQ, end, -anchor, world);
}

void AddSliderJoint(const scene::SliderSpec& slider, const std::vector<Object>& objects,
                    physics::World* world) {
  const physics::BodyId a = objects[slider.first_object].body;
  const physics::BodyId b = objects[slider.first_object + 1].body;
  // J is the joint frame on the first member and K on the second; the poses in scenes are those of
  // the members in the joint frame.
  // The offset counts along -x of the rail in scenes, along +x in physics.
  world->AddJoint(physics::SliderJointSpec{.a = a,
                                           .b = b,
                                           .X_AJ = slider.X_JA.inverse(),
                                           .X_BK = slider.X_JB.inverse(),
                                           .lower = -slider.max_offset,
                                           .upper = -slider.min_offset,
                                           .do_collide = slider.do_members_collide,
                                           .damping = slider.damping,
                                           .restitution = slider.restitution,
                                           .softness = slider.softness});
  if (!slider.do_members_collide) return;
  // Contacts would push apart members that the rail holds together, without end.
  const auto blockers =
      world->OverlapsAt(b, world->body(b).pose_in_world(), kMaxMemberOverlap).bodies;
  if (std::ranges::find(blockers, a) != blockers.end()) world->IgnoreCollisionUntilSeparated(a, b);
}

}  // namespace smile::world

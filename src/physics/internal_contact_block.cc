#include "physics/internal_contact_block.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Projected Gauss-Seidel over contact points. At each point: first the normal impulse, at least 0,
// that gives the bodies the speed wanted there; then the friction that stops them in the plane,
// drawn back to Coulomb's cone; then that against rolling. docs/decisions/physics.md explains the
// numbers.

namespace smile::physics {
namespace {

/// Part of the depth, and of the distance from the point where a contact stuck, that is corrected
/// in a step.
constexpr double kDepthCorrection = 0.1;
constexpr double kAnchorCorrection = 0.2;
/// Part of the greatest possible friction from which on a contact slips.
constexpr double kSlipping = 0.999;
/// Friction of a point without any [N s]; its square is not 0.
constexpr double kBarelyOutside = std::numeric_limits<float>::min();

/// Bodies that the impulses of the last step leave slower than this stand still [m/s, rad/s], if no
/// contact is deeper than this [m].
constexpr double kStillSpeed = 1e-5;
constexpr double kStillAngularSpeed = 1e-4;
constexpr double kStillDepth = 1e-4;

bool IsStill(const btVector3& linear, const btVector3& angular) {
  return linear.length2() < kStillSpeed * kStillSpeed &&
         angular.length2() < kStillAngularSpeed * kStillAngularSpeed;
}

bool IsMovable(const btSolverBody& body) { return body.m_invMass[0] != 0; }

/// Returns the friction of the last step, whose axes were others, in the world.
btVector3 LastFriction(const btManifoldPoint& point) {
  return point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
         point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2;
}

}  // namespace

void ContactBlock::Begin(std::span<const Contacts> contacts, bool may_rest,
                         const btContactSolverInfo& info,
                         btAlignedObjectArray<btSolverBody>* bodies) {
  info_ = info;
  bodies_ = bodies;
  patches_.clear();
  points_.clear();
  rolling_.clear();
  if (may_rest && StayAtRest(contacts)) return;
  for (const Contacts& one : contacts) AddPatch(one);
}

/// Lets the bodies stand still if they do already, and would with the last impulses.
bool ContactBlock::StayAtRest(std::span<const Contacts> contacts) {
  const auto bodies = All(*bodies_);
  // Kinematic bodies are among them: what they push is not at rest.
  const auto is_still = [](const btSolverBody& body) {
    return IsStill(body.m_linearVelocity, body.m_angularVelocity);
  };
  if (!std::ranges::all_of(bodies, is_still)) return false;

  is_held_.assign(bodies.size(), false);
  for (const auto& [manifold, a, b] : contacts) {
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      if (point.getDistance() < -kStillDepth) return false;
      const btVector3 impulse =
          point.m_appliedImpulse * point.m_normalWorldOnB + LastFriction(point);
      for (const auto& [index, sign] : {std::pair(a, 1.0), std::pair(b, -1.0)}) {
        btSolverBody& body = bodies[index];
        if (!IsMovable(body)) continue;
        is_held_[index] = true;
        const btVector3 arm = point.m_positionWorldOnB - body.m_worldTransform.getOrigin();
        body.m_deltaLinearVelocity += sign * body.m_invMass * impulse;
        body.m_deltaAngularVelocity +=
            body.m_originalBody->getInvInertiaTensorWorld() * arm.cross(sign * impulse);
      }
    }
  }
  bool stay = true;
  for (std::size_t i = 0; i < bodies.size() && stay; ++i) {
    const btSolverBody& body = bodies[i];
    if (!IsMovable(body)) continue;
    stay = is_held_[i] &&
           IsStill(
               body.m_linearVelocity + body.m_externalForceImpulse + body.m_deltaLinearVelocity,
               body.m_angularVelocity + body.m_externalTorqueImpulse + body.m_deltaAngularVelocity);
  }
  for (btSolverBody& body : bodies) {
    const bool stop = stay && IsMovable(body);
    const btVector3 none(0, 0, 0);
    body.m_deltaLinearVelocity =
        stop ? -(body.m_linearVelocity + body.m_externalForceImpulse) : none;
    body.m_deltaAngularVelocity =
        stop ? -(body.m_angularVelocity + body.m_externalTorqueImpulse) : none;
  }
  return stay;
}

ContactBlock::Side ContactBlock::SideOf(int body, const btVector3& center) const {
  const btSolverBody& one = (*bodies_)[body];
  Side side{body, one.m_invMass[0], btMatrix3x3(0, 0, 0, 0, 0, 0, 0, 0, 0),
            center - one.m_worldTransform.getOrigin()};
  // A static or kinematic body does not answer to impulses.
  if (IsMovable(one)) side.inverse_inertia = one.m_originalBody->getInvInertiaTensorWorld();
  return side;
}

ContactBlock::Responses ContactBlock::ResponsesOf(const Patch& patch) {
  Responses responses;
  for (int i = 0; i < 3; ++i) {
    btVector3 unit(0, 0, 0);
    unit[i] = 1;
    for (const Side& side : patch.sides) {
      const btVector3 turned_by_force = side.inverse_inertia * side.arm.cross(unit);
      const btVector3 turned_by_torque = side.inverse_inertia * unit;
      responses[i].Add(1, Vector6::Of(side.inverse_mass * unit + turned_by_force.cross(side.arm),
                                      turned_by_force));
      responses[3 + i].Add(1, Vector6::Of(turned_by_torque.cross(side.arm), turned_by_torque));
    }
  }
  return responses;
}

Vector6 ContactBlock::ResponseTo(const Vector6& impulse, const Responses& responses) {
  Vector6 response;
  const btVector3 linear = impulse.linear(), angular = impulse.angular();
  for (int i = 0; i < 3; ++i) {
    response.Add(linear[i], responses[i]);
    response.Add(angular[i], responses[3 + i]);
  }
  return response;
}

ContactBlock::Friction ContactBlock::FrictionAlong(const Vector6& axis_1, const Vector6& axis_2,
                                                   const Responses& responses) {
  Friction friction{.axes = {axis_1, axis_2},
                    .responses = {ResponseTo(axis_1, responses), ResponseTo(axis_2, responses)}};
  const double xx = axis_1.Dot(friction.responses[0]);
  const double xy = axis_1.Dot(friction.responses[1]);
  const double yy = axis_2.Dot(friction.responses[1]);
  const double determinant = xx * yy - xy * xy;
  friction.inverse = {yy / determinant, -xy / determinant, xx / determinant};
  return friction;
}

/// Returns the velocity of A relative to B at a point.
btVector3 ContactBlock::VelocityAt(const Patch& patch, const btVector3& from_center,
                                   bool with_forces) const {
  btVector3 velocity(0, 0, 0);
  double sign = 1;
  for (const Side& side : patch.sides) {
    const btSolverBody& body = (*bodies_)[side.body];
    btVector3 linear = body.m_linearVelocity, angular = body.m_angularVelocity;
    if (with_forces) {
      linear += body.m_externalForceImpulse;
      angular += body.m_externalTorqueImpulse;
    }
    velocity += sign * (linear + angular.cross(side.arm + from_center));
    sign = -1;
  }
  return velocity;
}

void ContactBlock::AddPatch(const Contacts& contacts) {
  btPersistentManifold* manifold = contacts.manifold;
  const btScalar threshold = manifold->getContactProcessingThreshold();
  btVector3 center(0, 0, 0);
  int count = 0;
  for (int k = 0; k < manifold->getNumContacts(); ++k) {
    const btManifoldPoint& point = manifold->getContactPoint(k);
    if (point.getDistance() > threshold) continue;
    center += point.m_positionWorldOnB;
    ++count;
  }
  const bool is_movable = IsMovable((*bodies_)[contacts.a]) || IsMovable((*bodies_)[contacts.b]);
  if (count == 0 || !is_movable) return;
  center /= count;

  const Patch patch{
      {SideOf(contacts.a, center), SideOf(contacts.b, center)},
      static_cast<int>(points_.size()),
      count,
      btManifoldResult::calculateCombinedFriction(manifold->getBody0(), manifold->getBody1())};
  const Responses responses = ResponsesOf(patch);
  Vector6 start;
  for (int k = 0; k < manifold->getNumContacts(); ++k) {
    btManifoldPoint& source = manifold->getContactPoint(k);
    if (source.getDistance() > threshold) continue;
    AddPoint(patch, responses, center, &source);
    const Point& point = points_.back();
    start.Add(point.impulse, point.normal);
    for (int i = 0; i < 2; ++i) start.Add(point.sliding.impulse[i], point.sliding.axes[i]);
  }
  Apply(patch, start);
  patches_.push_back(patch);
}

void ContactBlock::AddPoint(const Patch& patch, const Responses& responses, const btVector3& center,
                            btManifoldPoint* source) {
  const btVector3 from_center = source->m_positionWorldOnB - center;
  const auto along = [&from_center](const btVector3& direction) {
    return Vector6::Of(direction, from_center.cross(direction));
  };
  const btVector3& normal = source->m_normalWorldOnB;
  btVector3 lateral[2];
  btPlaneSpace1(normal, lateral[0], lateral[1]);
  const btVector3 before_forces = VelocityAt(patch, from_center, /*with_forces=*/false);
  const btVector3 velocity = VelocityAt(patch, from_center, /*with_forces=*/true);
  const btScalar step_seconds = info_.m_timeStep;

  Point& point = points_.emplace_back();
  point.source = source;
  point.normal = along(normal);
  point.response = ResponseTo(point.normal, responses);
  point.inverse = 1 / point.normal.Dot(point.response);
  point.impulse = info_.m_warmstartingFactor * source->m_appliedImpulse;
  // A gap may close in this step; depth is corrected in part; fast bodies bounce.
  const btScalar distance = source->getDistance();
  point.wanted =
      -velocity.dot(normal) - distance / step_seconds * (distance > 0 ? 1 : kDepthCorrection);
  const btScalar approach = -before_forces.dot(normal);
  if (approach > info_.m_restitutionVelocityThreshold) {
    point.wanted += source->m_combinedRestitution * approach;
  }

  point.sliding = FrictionAlong(along(lateral[0]), along(lateral[1]), responses);
  const btVector3 from_anchor = source->m_positionWorldOnA - source->m_positionWorldOnB;
  const btVector3 last = info_.m_warmstartingFactor * LastFriction(*source);
  for (int i = 0; i < 2; ++i) {
    point.sliding.wanted[i] =
        -lateral[i].dot(velocity + from_anchor * (kAnchorCorrection / step_seconds));
    point.sliding.impulse[i] = lateral[i].dot(last);
  }

  point.rolling = -1;
  if (source->m_combinedRollingFriction <= 0) return;
  point.rolling = static_cast<int>(rolling_.size());
  const btVector3 none(0, 0, 0);
  Rolling& rolling = rolling_.emplace_back(Rolling{
      source->m_combinedRollingFriction,
      FrictionAlong(Vector6::Of(none, lateral[0]), Vector6::Of(none, lateral[1]), responses)});
  const btSolverBody &a = (*bodies_)[patch.sides[0].body], &b = (*bodies_)[patch.sides[1].body];
  const btVector3 angular = a.m_angularVelocity + a.m_externalTorqueImpulse - b.m_angularVelocity -
                            b.m_externalTorqueImpulse;
  rolling.friction.wanted = {-lateral[0].dot(angular), -lateral[1].dot(angular)};
  rolling.friction.impulse = {0, 0};
}

void ContactBlock::Apply(const Patch& patch, const Vector6& impulse) {
  double sign = 1;
  for (const Side& side : patch.sides) {
    if (side.inverse_mass != 0) {
      btSolverBody& body = (*bodies_)[side.body];
      const btVector3 linear = sign * impulse.linear(), angular = sign * impulse.angular();
      body.m_deltaLinearVelocity += side.inverse_mass * linear;
      body.m_deltaAngularVelocity += side.inverse_inertia * (angular + side.arm.cross(linear));
    }
    sign = -1;
  }
}

[[gnu::always_inline]] inline void ContactBlock::Sweep(Friction* friction, double limit,
                                                       Vector6* velocity, Vector6* impulse) {
  const double x = friction->wanted[0] - friction->axes[0].Dot(*velocity);
  const double y = friction->wanted[1] - friction->axes[1].Dot(*velocity);
  const auto [xx, xy, yy] = friction->inverse;
  std::array<double, 2> next = {friction->impulse[0] + xx * x + xy * y,
                                friction->impulse[1] + xy * x + yy * y};
  const double squared = next[0] * next[0] + next[1] * next[1];
  if (squared > limit * limit) {
    const double share = limit / std::sqrt(squared);
    for (double& one : next) one *= share;
  }
  for (int i = 0; i < 2; ++i) {
    const double change = next[i] - friction->impulse[i];
    friction->impulse[i] = next[i];
    velocity->Add(change, friction->responses[i]);
    impulse->Add(change, friction->axes[i]);
  }
}

[[gnu::always_inline]] inline double ContactBlock::Sweep(Point* point, double coefficient,
                                                         Vector6* velocity, Vector6* impulse) {
  const double missing = point->wanted - point->normal.Dot(*velocity);
  const double change = std::max(missing * point->inverse, -point->impulse);
  point->impulse += change;
  velocity->Add(change, point->response);
  impulse->Add(change, point->normal);
  Sweep(&point->sliding, coefficient * point->impulse, velocity, impulse);
  if (point->rolling >= 0) {
    Rolling& rolling = rolling_[point->rolling];
    Sweep(&rolling.friction, rolling.lever * point->impulse, velocity, impulse);
  }
  return std::abs(change);
}

double ContactBlock::Sweep() {
  double greatest = 0;
  for (const Patch& patch : patches_) {
    const auto& [a, b] = patch.sides;
    const btSolverBody &body_a = (*bodies_)[a.body], &body_b = (*bodies_)[b.body];
    Vector6 velocity =
        Vector6::Of(body_a.m_deltaLinearVelocity + body_a.m_deltaAngularVelocity.cross(a.arm) -
                        body_b.m_deltaLinearVelocity - body_b.m_deltaAngularVelocity.cross(b.arm),
                    body_a.m_deltaAngularVelocity - body_b.m_deltaAngularVelocity);
    Vector6 impulse;
    for (Point& point : std::span(points_).subspan(patch.first, patch.count)) {
      greatest = std::max(greatest, Sweep(&point, patch.friction, &velocity, &impulse));
    }
    Apply(patch, impulse);
  }
  return greatest;
}

void ContactBlock::NoteImpulses() const {
  for (const Patch& patch : patches_) {
    for (const Point& point : std::span(points_).subspan(patch.first, patch.count)) {
      btManifoldPoint& source = *point.source;
      const auto [x, y] = point.sliding.impulse;
      source.m_appliedImpulse = point.impulse;
      source.m_appliedImpulseLateral1 = x;
      source.m_appliedImpulseLateral2 = y;
      source.m_lateralFrictionDir1 = point.sliding.axes[0].linear();
      source.m_lateralFrictionDir2 = point.sliding.axes[1].linear();
      // Bullet keeps a point as it was first found while its friction lies within the cone. One
      // that slips, rolls or bears nothing is to be taken as it is found in the next step: outside
      // of a cone of no width.
      const double limit = kSlipping * patch.friction * point.impulse;
      const bool sticks = point.rolling < 0 && x * x + y * y < limit * limit;
      source.m_combinedFriction = sticks ? patch.friction : 0;
      if (x == 0 && y == 0 && !sticks) source.m_appliedImpulseLateral1 = kBarelyOutside;
    }
  }
}

}  // namespace smile::physics

#include "impulses/contact_solver.h"

#include <algorithm>
#include <cmath>

#include "impulses/internal_plane.h"
#include "impulses/support.h"

// Projected Gauss-Seidel over contacts. At each contact: first the normal impulse, at least 0, that
// gives the bodies the speed wanted there; then the friction that stops them in the plane, drawn
// back to Coulomb's cone; then that against rolling. docs/decisions/physics.md explains the
// numbers.

namespace smile::impulses {
namespace {

/// Part of the depth, and of the way back to the point where a contact stuck, that is corrected in
/// a step.
constexpr double kDepthCorrection = 0.1;
constexpr double kAnchorCorrection = 0.2;
/// Part of the greatest possible friction from which on a contact slips.
constexpr double kSlipping = 0.999;

/// Points have a load across their plane if the squares of their weights add up to this.
constexpr double kLeastWeights = 0.1;

/// Bodies that may roll, and turn faster than this against each other, roll [rad/s].
constexpr double kRollingSpeed = 0.01;

/// Bodies that the impulses of the last step leave slower than this stand still [m/s, rad/s], if no
/// contact is deeper than this [m].
constexpr double kStillSpeed = 1e-5;
constexpr double kStillAngularSpeed = 1e-4;
constexpr double kStillDepth = 1e-4;

bool IsStill(const Vector3& linear, const Vector3& angular) {
  return linear.squaredNorm() < kStillSpeed * kStillSpeed &&
         angular.squaredNorm() < kStillAngularSpeed * kStillAngularSpeed;
}

/// Returns the change of angular velocity by an angular impulse. A sum of columns, since Eigen's
/// product is not inlined at -O2.
Vector3 TurnedBy(const Vector3& angular_impulse, const Body& body) {
  const Matrix3& inverse = body.inverse_inertia;
  return angular_impulse.x() * inverse.col(0) + angular_impulse.y() * inverse.col(1) +
         angular_impulse.z() * inverse.col(2);
}

/// Returns true if friction against rolling, of at most this angular impulse, can stop a rotation.
bool CanStop(const Vector3& w, const Body& body, double most) {
  return most > 0 && (body.inverse_inertia.inverse() * w).squaredNorm() < most * most;
}

}  // namespace

bool ContactSolver::Begin(const Config& config, std::span<const Body> bodies,
                          std::span<const Patch> patches, std::span<Contact> contacts,
                          bool may_rest) {
  config_ = config;
  rows_.clear();
  points_.clear();
  rolling_.clear();
  if (may_rest && StayAtRest(bodies, patches, contacts)) return true;
  for (const Patch& patch : patches) {
    const Body &a = bodies[patch.a], &b = bodies[patch.b];
    if (!a.is_movable() && !b.is_movable()) continue;
    const std::span<Contact> own = contacts.subspan(patch.first, patch.count);
    Vector3 center = Vector3::Zero();
    for (const Contact& contact : own) center += contact.p_WB / patch.count;
    AddRows({Side{&a, center - a.p_WBcm}, Side{&b, center - b.p_WBcm}}, patch.friction, center,
            own);
  }
  if (may_rest && config.finds_loads) FindLoads(bodies);
  return false;
}

/// Changes the normal impulses of patches that bore something in the last step.
void ContactSolver::FindLoads(std::span<const Body> bodies) {
  loaded_.clear();
  loads_.clear();
  for (const Rows& rows : rows_) {
    Loaded& loaded = loaded_.emplace_back(LoadedOf(rows, PointsOf(rows)));
    loaded.first_load = static_cast<int>(loads_.size());
    // Two points, or points in line, hold nothing against tipping in one direction.
    const int num_loads = loaded.count > 2 ? 3 : std::min(loaded.count, 1);
    for (int load = 0; load < num_loads; ++load) AddLoad(bodies, &loaded, load);
  }
  load_solver_.Solve(static_cast<int>(bodies.size()), loads_);
  for (const Loaded& loaded : loaded_) ApplyLoads(loaded);
}

ContactSolver::Loaded ContactSolver::LoadedOf(const Rows& rows, std::span<const Point> points) {
  Loaded loaded{.rows = &rows};
  const Contact* first = nullptr;
  for (const Point& point : points) {
    if (point.impulse == 0) continue;
    if (first == nullptr) first = point.contact;
    loaded.p_WQ += point.contact->p_WB;
    loaded.most = std::max(loaded.most, point.impulse);
    ++loaded.count;
  }
  if (first == nullptr) return loaded;
  loaded.p_WQ /= loaded.count;
  double squared = 0;
  for (const Point& point : points) {
    if (point.impulse != 0) squared += (point.contact->p_WB - loaded.p_WQ).squaredNorm();
  }
  // Weights are about 1.
  loaded.across = AxesOfPlane(first->normal);
  for (Vector3& axis : loaded.across) {
    if (squared > 0) axis /= std::sqrt(squared / loaded.count);
  }
  return loaded;
}

/// Returns the part of a unit of a load that acts at a point. The first load acts at all points
/// alike, the others turn about the two axes of the plane.
double ContactSolver::Loaded::WeightOf(const Point& point, int load) const {
  return load == 0 ? 1 : across[load - 1].dot(point.contact->p_WB - p_WQ);
}

/// Adds a load of a patch, unless its points are too close to each other in this direction.
void ContactSolver::AddLoad(std::span<const Body> bodies, Loaded* loaded, int load) {
  Vector6 unit;
  double wanted = 0, squared_weights = 0;
  for (const Point& point : PointsOf(*loaded->rows)) {
    if (point.impulse == 0) continue;
    const double weight = loaded->WeightOf(point, load);
    squared_weights += weight * weight;
    unit.Add(weight, point.normal);
    // Depth is left to the sweeps: what is jammed cannot be pushed apart.
    const double depth = std::max(-point.contact->distance, 0.0);
    wanted += weight * (point.wanted - depth * kDepthCorrection / config_.step_seconds);
  }
  if (squared_weights < kLeastWeights) return;
  LoadSolver::Load& added = loads_.emplace_back();
  for (int k = 0; k < 2; ++k) {
    const auto& [body, arm] = loaded->rows->sides[k];
    added.sides[k].body = static_cast<int>(body - bodies.data());
    if (!body->is_movable()) continue;
    const double sign = k == 0 ? 1 : -1;
    const Vector3 linear = sign * unit.linear();
    const Vector3 angular = sign * unit.angular() + arm.cross(linear);
    added.sides[k].jacobian = Vector6::Of(linear, angular);
    added.sides[k].response = Vector6::Of(body->inverse_mass * linear, TurnedBy(angular, *body));
    wanted -= linear.dot(ChangeOfV(*body)) + angular.dot(ChangeOfW(*body));
  }
  added.wanted = wanted;
  added.most = loaded->most;
  loaded->kinds[loaded->num_loads++] = load;
}

void ContactSolver::ApplyLoads(const Loaded& loaded) {
  Vector6 impulse;
  for (Point& point : PointsOf(*loaded.rows)) {
    if (point.impulse == 0) continue;
    double change = 0;
    for (int i = 0; i < loaded.num_loads; ++i) {
      change += loads_[loaded.first_load + i].change * loaded.WeightOf(point, loaded.kinds[i]);
    }
    change = std::max(change, -point.impulse);
    point.impulse += change;
    impulse.Add(change, point.normal);
  }
  Apply(*loaded.rows, impulse);
}

/// Lets the bodies stand still if they do already, and would with the last impulses.
bool ContactSolver::StayAtRest(std::span<const Body> bodies, std::span<const Patch> patches,
                               std::span<const Contact> contacts) {
  // Carried bodies are among them: what they push is not at rest.
  const auto is_still = [](const Body& body) { return IsStill(body.v, body.w); };
  const auto is_shallow = [](const Contact& contact) { return contact.distance >= -kStillDepth; };
  if (contacts.empty() || !std::ranges::all_of(bodies, is_still) ||
      !std::ranges::all_of(contacts, is_shallow)) {
    return false;
  }
  // About the centers of mass.
  impulses_.assign(bodies.size(), Vector6());
  against_rolling_.assign(bodies.size(), 0);
  for (const Patch& patch : patches) {
    const Vector3 &center_a = bodies[patch.a].p_WBcm, &center_b = bodies[patch.b].p_WBcm;
    for (const Contact& contact : contacts.subspan(patch.first, patch.count)) {
      const Vector3 impulse = contact.impulse * contact.normal + contact.friction;
      const Vector3 from_a = contact.p_WB - center_a, from_b = contact.p_WB - center_b;
      impulses_[patch.a].Add(1, Vector6::Of(impulse, from_a.cross(impulse)));
      impulses_[patch.b].Add(-1, Vector6::Of(impulse, from_b.cross(impulse)));
      for (const int body : {patch.a, patch.b}) {
        against_rolling_[body] += contact.rolling_friction * contact.impulse;
      }
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    if (!body.is_movable()) continue;
    const Vector3 v = body.v + body.forced_v + body.inverse_mass * impulses_[i].linear();
    const Vector3 w = body.w + body.forced_w + TurnedBy(impulses_[i].angular(), body);
    if (!IsStill(v, CanStop(w, body, against_rolling_[i]) ? Vector3::Zero() : w)) return false;
  }
  for (const Body& body : bodies) {
    if (!body.is_movable()) continue;
    ChangeOfV(body) = -(body.v + body.forced_v);
    ChangeOfW(body) = -(body.w + body.forced_w);
  }
  return true;
}

ContactSolver::Responses ContactSolver::ResponsesOf(const Rows& rows) {
  Responses responses;
  for (int i = 0; i < 3; ++i) {
    const Vector3 unit = Vector3::Unit(i);
    for (const auto& [body, arm] : rows.sides) {
      const Vector3 turned_by_force = TurnedBy(arm.cross(unit), *body);
      const Vector3 turned_by_torque = body->inverse_inertia.col(i);
      responses[i].Add(
          1, Vector6::Of(body->inverse_mass * unit + turned_by_force.cross(arm), turned_by_force));
      responses[3 + i].Add(1, Vector6::Of(turned_by_torque.cross(arm), turned_by_torque));
    }
  }
  return responses;
}

Vector6 ContactSolver::ResponseTo(const Vector6& impulse, const Responses& responses) {
  Vector6 response;
  const Vector3 linear = impulse.linear(), angular = impulse.angular();
  for (int i = 0; i < 3; ++i) {
    response.Add(linear[i], responses[i]);
    response.Add(angular[i], responses[3 + i]);
  }
  return response;
}

ContactSolver::Friction ContactSolver::FrictionAlong(const Vector6& axis_1, const Vector6& axis_2,
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
Vector3 ContactSolver::VelocityAt(const Rows& rows, const Vector3& from_center, bool with_forces) {
  Vector3 velocity = Vector3::Zero();
  double sign = 1;
  for (const auto& [body, arm] : rows.sides) {
    Vector3 linear = body->v, angular = body->w;
    if (with_forces) {
      linear += body->forced_v;
      angular += body->forced_w;
    }
    velocity += sign * (linear + angular.cross(arm + from_center));
    sign = -1;
  }
  return velocity;
}

void ContactSolver::AddRows(const std::array<Side, 2>& sides, double friction,
                            const Vector3& center, std::span<Contact> contacts) {
  const Rows& rows = rows_.emplace_back(
      Rows{sides, static_cast<int>(points_.size()), static_cast<int>(contacts.size()), friction});
  const Responses responses = ResponsesOf(rows);
  Vector6 start;
  for (Contact& contact : contacts) {
    AddPoint(rows, responses, center, &contact);
    const Point& point = points_.back();
    start.Add(point.impulse, point.normal);
    for (int i = 0; i < 2; ++i) start.Add(point.sliding.impulse[i], point.sliding.axes[i]);
  }
  Apply(rows, start);
}

void ContactSolver::AddPoint(const Rows& rows, const Responses& responses, const Vector3& center,
                             Contact* contact) {
  const Vector3 from_center = contact->p_WB - center;
  const auto along = [&from_center](const Vector3& direction) {
    return Vector6::Of(direction, from_center.cross(direction));
  };
  const Vector3& normal = contact->normal;
  const std::array<Vector3, 2> across = AxesOfPlane(normal);
  const Vector3 before_forces = VelocityAt(rows, from_center, /*with_forces=*/false);
  const Vector3 velocity = VelocityAt(rows, from_center, /*with_forces=*/true);

  Point& point = points_.emplace_back();
  point.contact = contact;
  point.normal = along(normal);
  point.response = ResponseTo(point.normal, responses);
  point.inverse = 1 / point.normal.Dot(point.response);
  point.impulse = config_.warm_start * contact->impulse;
  // A gap may close in this step; depth is corrected in part; fast bodies bounce.
  const double closing = contact->distance * (contact->distance > 0 ? 1 : kDepthCorrection);
  point.wanted = -velocity.dot(normal) - closing / config_.step_seconds;
  const double approach = -before_forces.dot(normal);
  if (approach > config_.bounce_speed) point.wanted += contact->restitution * approach;

  point.sliding = FrictionAlong(along(across[0]), along(across[1]), responses);
  const Vector3 sliding = velocity + contact->p_BA_W * (kAnchorCorrection / config_.step_seconds);
  for (int i = 0; i < 2; ++i) {
    point.sliding.wanted[i] = -across[i].dot(sliding);
    point.sliding.impulse[i] = config_.warm_start * across[i].dot(contact->friction);
  }

  point.rolling = -1;
  if (contact->rolling_friction <= 0) return;
  point.rolling = static_cast<int>(rolling_.size());
  const Vector6 turn_1 = Vector6::Of(Vector3::Zero(), across[0]);
  const Vector6 turn_2 = Vector6::Of(Vector3::Zero(), across[1]);
  Friction& rolling = rolling_
                          .emplace_back(Rolling{contact->rolling_friction,
                                                FrictionAlong(turn_1, turn_2, responses)})
                          .friction;
  const Body &a = *rows.sides[0].body, &b = *rows.sides[1].body;
  const Vector3 angular = a.w + a.forced_w - b.w - b.forced_w;
  rolling.wanted = {-across[0].dot(angular), -across[1].dot(angular)};
  rolling.impulse = {0, 0};
}

void ContactSolver::Apply(const Rows& rows, const Vector6& impulse) {
  double sign = 1;
  for (const auto& [body, arm] : rows.sides) {
    if (body->is_movable()) {
      const Vector3 linear = sign * impulse.linear(), angular = sign * impulse.angular();
      ChangeOfV(*body) += body->inverse_mass * linear;
      ChangeOfW(*body) += TurnedBy(angular + arm.cross(linear), *body);
    }
    sign = -1;
  }
}

// Inlined, these two keep the velocity in registers through all points of a patch.

[[gnu::always_inline]] inline void ContactSolver::Sweep(Friction* friction, double limit,
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

[[gnu::always_inline]] inline double ContactSolver::Sweep(Point* point, double coefficient,
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

double ContactSolver::Sweep() {
  double greatest = 0;
  for (const Rows& rows : rows_) {
    const auto& [a, b] = rows.sides;
    const Vector3 linear = ChangeOfV(*a.body) + ChangeOfW(*a.body).cross(a.arm) -
                           ChangeOfV(*b.body) - ChangeOfW(*b.body).cross(b.arm);
    Vector6 velocity = Vector6::Of(linear, ChangeOfW(*a.body) - ChangeOfW(*b.body));
    Vector6 impulse;
    for (Point& point : std::span(points_).subspan(rows.first, rows.count)) {
      greatest = std::max(greatest, Sweep(&point, rows.friction, &velocity, &impulse));
    }
    Apply(rows, impulse);
  }
  return greatest;
}

/// Returns true if friction is not at its limit.
bool ContactSolver::IsBelow(double limit, const Friction& friction) {
  const auto& [x, y] = friction.impulse;
  return x * x + y * y < kSlipping * kSlipping * limit * limit;
}

void ContactSolver::End() {
  const auto turning_of = [](const Side& side) {
    return Vector3(side.body->w + side.body->forced_w + ChangeOfW(*side.body));
  };
  for (const Rows& rows : rows_) {
    const Vector3 turning = turning_of(rows.sides[0]) - turning_of(rows.sides[1]);
    for (const Point& point : std::span(points_).subspan(rows.first, rows.count)) {
      const std::array<Vector6, 2>& axes = point.sliding.axes;
      const std::array<double, 2>& friction = point.sliding.impulse;
      Contact& contact = *point.contact;
      contact.impulse = point.impulse;
      contact.friction = friction[0] * axes[0].linear() + friction[1] * axes[1].linear();
      contact.sticks = point.impulse > 0 ? IsBelow(rows.friction * point.impulse, point.sliding)
                                         : IsUnmoved(contact);
      const Vector3 rolling = turning - turning.dot(contact.normal) * contact.normal;
      const bool rolls =
          point.rolling >= 0 && rolling.squaredNorm() > kRollingSpeed * kRollingSpeed;
      contact.sticks = contact.sticks && !rolls;
    }
  }
}

}  // namespace smile::impulses

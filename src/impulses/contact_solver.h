#pragma once

#include <array>
#include <span>
#include <vector>

#include "impulses/body.h"
#include "impulses/load_solver.h"
#include "impulses/vector6.h"

namespace smile::impulses {

/// Point at which two bodies, A and B, may touch.
struct Contact {
  Vector3 p_WB = Vector3::Zero();     ///< on body B [m]
  Vector3 p_BA_W = Vector3::Zero();   ///< from there to the point of A that stuck to it [m]
  Vector3 normal = Vector3::UnitZ();  ///< from B to A
  double distance = 0;                ///< along the normal [m]; negative: depth
  double restitution = 0;             ///< part of the speed with which bodies part again
  double rolling_friction = 0;        ///< torque against rolling per normal force [m]
  double impulse = 0;  ///< along the normal, on A [N s]: of the last step, then of this
  Vector3 friction = Vector3::Zero();  ///< impulse in the plane, likewise
  bool sticks = false;                 ///< result: bears something, and neither slips nor rolls
};

/// The contacts of two bodies.
struct Patch {
  int a = 0, b = 0;          ///< indices of the bodies
  int first = 0, count = 0;  ///< of its contacts
  double friction = 0;       ///< coefficient
};

/// Iterative solver for the contacts between the bodies of an island.
///
/// A sweep through the contacts of a patch needs only the relative velocity of the two bodies, 6
/// numbers, where a row for each contact and direction needs both bodies' 12. A contact has one
/// normal impulse, and one friction impulse in its plane, at most friction times normal in whatever
/// direction.
class ContactSolver {
 public:
  struct Config {
    double step_seconds = 1.0 / 480;
    double warm_start = 0.85;   ///< part of the last impulses to begin with
    double bounce_speed = 0.2;  ///< slower bodies do not bounce [m/s]
    /// The loads of patches are found all together before the sweeps, where nothing but contacts
    /// acts: see LoadSolver.
    bool finds_loads = true;
  };

  /// Begins a step of an island with the impulses of the last step.
  ///
  /// If these hold every body at rest, as they are, nothing is left to do: the bodies stand still,
  /// and sweeps change nothing.
  /// @param bodies, contacts  stay the caller's until End().
  /// @param may_rest  false if anything but contacts acts on the island.
  /// @returns true if all bodies stand still.
  bool Begin(const Config& config, std::span<const Body> bodies, std::span<const Patch> patches,
             std::span<Contact> contacts, bool may_rest);
  /// Sweeps once through all patches, in their order.
  /// @returns the greatest change of a normal impulse [N s], 0 once nothing changes.
  double Sweep();
  /// Writes the results into the contacts.
  void End();

 private:
  /// What one body contributes to a patch.
  struct Side {
    const Body* body;
    Vector3 arm;  ///< from its center of mass to the patch's center
  };
  /// A patch whose points are being solved.
  struct Rows {
    std::array<Side, 2> sides;
    int first, count;  ///< of its points
    double friction;   ///< coefficient
  };
  /// Friction against sliding or rolling: two unit impulses, and the velocity along them.
  struct Friction {
    std::array<Vector6, 2> axes;
    std::array<Vector6, 2> responses;  ///< relative velocity that each causes
    std::array<double, 3> inverse;     ///< of the matrix of responses along the axes: xx, xy, yy
    std::array<double, 2> wanted;      ///< change of velocity
    std::array<double, 2> impulse;     ///< so far
  };
  struct Point {
    Vector6 normal;    ///< unit impulse along the normal
    Vector6 response;  ///< relative velocity that it causes
    double inverse;    ///< of the response along the normal
    double wanted;     ///< change of velocity [m/s]
    double impulse;    ///< so far [N s]
    Friction sliding;
    int rolling;  ///< index among rolling_; -1: rolls freely
    Contact* contact;
  };
  struct Rolling {
    double lever;  ///< torque per normal force [m]
    Friction friction;
  };
  /// A patch that bore something in the last step, with its points that did.
  struct Loaded {
    const Rows* rows;
    Vector3 p_WQ = Vector3::Zero();     ///< the mean of these points [m]
    std::array<Vector3, 2> across;      ///< weights of the points by their places, as vectors [1/m]
    double most = 0;                    ///< of the points' impulses [N s]
    int count = 0;                      ///< of these points
    int first_load = 0, num_loads = 0;  ///< what AddLoad() added
    std::array<int, 3> kinds{};         ///< of these loads: see WeightOf()

    double WeightOf(const Point& point, int load) const;
  };
  /// Relative velocity at a patch's center that each unit impulse there causes.
  using Responses = std::array<Vector6, 6>;

  bool StayAtRest(std::span<const Body> bodies, std::span<const Patch> patches,
                  std::span<const Contact> contacts);
  void FindLoads(std::span<const Body> bodies);
  static Loaded LoadedOf(const Rows& rows, std::span<const Point> points);
  void AddLoad(std::span<const Body> bodies, Loaded* loaded, int load);
  void ApplyLoads(const Loaded& loaded);
  std::span<Point> PointsOf(const Rows& rows) {
    return std::span(points_).subspan(rows.first, rows.count);
  }
  void AddRows(const std::array<Side, 2>& sides, double friction, const Vector3& center,
               std::span<Contact> contacts);
  void AddPoint(const Rows& rows, const Responses& responses, const Vector3& center,
                Contact* contact);
  static Vector3 VelocityAt(const Rows& rows, const Vector3& from_center, bool with_forces);
  static Responses ResponsesOf(const Rows& rows);
  static Vector6 ResponseTo(const Vector6& impulse, const Responses& responses);
  static Friction FrictionAlong(const Vector6& axis_1, const Vector6& axis_2,
                                const Responses& responses);
  static bool IsBelow(double limit, const Friction& friction);
  static void Apply(const Rows& rows, const Vector6& impulse);
  static void Sweep(Friction* friction, double limit, Vector6* velocity, Vector6* impulse);
  double Sweep(Point* point, double coefficient, Vector6* velocity, Vector6* impulse);

  Config config_;
  std::vector<Rows> rows_;
  std::vector<Point> points_;
  std::vector<Rolling> rolling_;
  std::vector<Vector6> impulses_;        ///< by body; scratch space of StayAtRest()
  std::vector<double> against_rolling_;  ///< likewise
  std::vector<Loaded> loaded_;           ///< scratch space of FindLoads()
  std::vector<LoadSolver::Load> loads_;  ///< likewise
  LoadSolver load_solver_;
};

}  // namespace smile::impulses

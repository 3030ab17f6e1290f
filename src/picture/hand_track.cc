#include "picture/hand_track.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/diagnostic.h"
#include "math/angles.h"
#include "picture/surface_probe.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"

namespace smile::picture {
namespace {

constexpr double kPeakSpeed = 1.0;  ///< between contacts, if there is time [m/s]
/// Ratio of peak to mean speed of a minimum-jerk motion from rest to rest. Source: T. Flash, N.
/// Hogan, "The Coordination of Arm Movements" (1985).
constexpr double kPeakOverMean = 1.875;
constexpr double kMinMotionSeconds = 0.5;  ///< [s]
constexpr double kShortestRest = 0.6;      ///< [s]
constexpr double kFastestTurn = 7;         ///< of a hand; faster than objects are turned [rad/s]
constexpr double kFastestFinger = 0.35;    ///< [m/s]
constexpr double kRelaxed = 0.028;         ///< half an opening [m]
constexpr double kOpened = 0.016;  ///< clearance to the object to be taken, on each side [m]
/// Largest rotation of a wrist with the object that it holds; beyond it, the object turns within
/// the hand.
constexpr double kMostTwist = DegreesToRadians(70);

/// Returns the minimum-jerk profile: position from 0 to 1 at time u from 0 to 1.
double Smooth(double u) {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

/// Returns `from`, changed towards `to` by at most `most`.
double Towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

/// Returns the rotation of a relaxed hand over the table: its fingers point away from the shoulder,
/// towards the robot.
Matrix3 NaturalRotation(HandSide side, const Vector3& p_WH, double table_edge) {
  constexpr double kRaised = DegreesToRadians(14);  // the wrist, above the knuckles
  Vector3 ahead = p_WH - ShoulderAt(side, table_edge + 0.25);
  ahead.z() = 0;
  // Never backwards over the shoulder.
  ahead.y() = std::min(ahead.y(), -0.25);
  ahead.normalize();
  const Vector3 up = Vector3::UnitZ();
  Matrix3 R_WH;
  R_WH.col(0) = std::cos(kRaised) * ahead - std::sin(kRaised) * up;
  R_WH.col(2) = std::cos(kRaised) * up + std::sin(kRaised) * ahead;
  R_WH.col(1) = R_WH.col(2).cross(R_WH.col(0));
  return R_WH;
}

/// Returns `from` rotated towards `to` by at most `most` [rad].
Matrix3 TurnedTowards(const Matrix3& from, const Matrix3& to, double most) {
  const Eigen::AngleAxisd turn(Matrix3(from.transpose() * to));
  if (turn.angle() <= most) return to;
  return from * Eigen::AngleAxisd(most, turn.axis()).toRotationMatrix();
}

/// Returns the reach of the digits around an object of this thickness [m].
std::array<double, kDigits> Reach(double thumb, double fingers) {
  return {thumb, fingers, fingers, fingers, fingers};
}

/// Desired posture of a hand; p_WQ is the place of its grip, or of its fingertip.
struct Aim {
  Vector3 p_WQ = Vector3::Zero();
  Matrix3 R_WH = Matrix3::Identity();
  double lift = 0;  ///< of the hand above that place, along its z [m]
  std::array<double, kDigits> reach = Reach(kRelaxed, kRelaxed);
  double pointing = 0;
};

/// Motion of one hand: at each tick it computes the desired posture and follows it within the
/// limits of speed. Depends only on the schedule and the ticks so far, so it is deterministic.
class HandPlayer {
 public:
  HandPlayer(HandSide side, const std::vector<ContactInterval>& intervals,
             const SurfaceProbe& probe, double table_edge)
      : side_(side), intervals_(intervals), probe_(probe), edge_(table_edge) {
    for (const ContactInterval& interval : intervals_) {
      // The yaw is chosen once per contact: a hand that holds an object must not turn about it.
      yaws_.push_back(interval.kind == ContactInterval::Kind::kTouch ? 0 : BestYaw(interval));
    }
    ComputeNextAim();
  }

  /// Advances to a tick and returns the posture.
  HandPosture GoTo(std::uint64_t tick, const scene::VisualState& state) {
    while (next_ < intervals_.size() && intervals_[next_].first <= tick) {
      now_ = next_++;
      left_ = AimAt(*now_, intervals_[*now_].begin);
      ComputeNextAim();
    }
    const bool is_at_it = now_ && tick <= intervals_[*now_].last;
    const Aim aim = is_at_it ? AimAt(*now_, state) : AimBetween(tick);
    if (is_at_it) left_ = aim;
    // A huge first step: the first posture is taken as it is.
    const double dt = is_begun_ ? sim::SecondsOf(tick - tick_) : 1e9;
    is_begun_ = true;
    tick_ = tick;
    Follow(aim, dt);
    return {.X_WH = RigidTransform(is_.R_WH, p_WH_), .reach = is_.reach, .pointing = is_.pointing};
  }

 private:
  /// Follows the aim within the speed limits: measured distances to objects may jump from tick to
  /// tick, a hand must not.
  void Follow(const Aim& aim, double dt) {
    is_.R_WH = TurnedTowards(is_.R_WH, aim.R_WH, kFastestTurn * dt);
    is_.lift = Towards(is_.lift, aim.lift, kFastestFinger * dt);
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
      is_.reach[digit] = Towards(is_.reach[digit], aim.reach[digit], kFastestFinger * dt);
    }
    is_.pointing = Towards(is_.pointing, aim.pointing, 5 * dt);
    // The aimed place in the hand's frame: between the grip (origin) and the index fingertip, below
    // by the lift.
    const Vector3 p_HQ = is_.pointing * IndexTip(side_) - Vector3(0, 0, is_.lift);
    const Vector3 step = aim.p_WQ - is_.R_WH * p_HQ - p_WH_;
    p_WH_ += step * std::min(1.0, kFastestHand * dt / std::max(step.norm(), 1e-9));
  }

  /// Returns the posture of rest beyond the table's edge, beside the body.
  Aim Rest() const {
    Aim aim;
    aim.p_WQ = Vector3(side_ == HandSide::kLeft ? 0.20 : -0.20, edge_ + 0.10, 0.06);
    aim.R_WH = NaturalRotation(side_, aim.p_WQ, edge_);
    return aim;
  }

  /// Returns the rotation about the hand's z axis at which the object is thinnest between thumb and
  /// fingers, with a cost on bending the wrist. Exhaustive search in steps, since the thickness is
  /// not smooth.
  double BestYaw(const ContactInterval& interval) const {
    constexpr double kStep = DegreesToRadians(4);
    constexpr double kPerRadian = 0.02;  // of thickness that a bent wrist is worth [m]
    const RigidTransform& X_WB = interval.begin.poses[interval.frame];
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (int k = -14; k <= 14; ++k) {
      Aim aim = BeginOf(interval, k * kStep);
      FitGrip(interval, X_WB, interval.begin.variants, &aim);
      const double cost = aim.reach[0] + aim.reach[1] + kPerRadian * std::abs(k * kStep) +
                          2 * std::max(0.0, aim.lift);
      if (cost >= least - 1e-6) continue;
      least = cost;
      best = k * kStep;
    }
    return best;
  }

  /// Returns the aim at the begin of a contact, before the object is measured.
  Aim BeginOf(const ContactInterval& interval, double yaw) const {
    Aim aim;
    aim.p_WQ = interval.begin.poses[interval.frame] * interval.p_BQ;
    aim.R_WH = NaturalRotation(side_, aim.p_WQ, edge_) *
               Eigen::AngleAxisd(yaw, Vector3::UnitZ()).toRotationMatrix();
    return aim;
  }

  /// Closes the hand on an object: as deep as the fingers reach, or lays it on top if the object is
  /// too thick.
  void FitGrip(const ContactInterval& interval, const RigidTransform& X_WB,
               const std::vector<int>& variants, Aim* aim) const {
    constexpr double kDeepest = 0.042;  // fingertips below the top [m]
    const Matrix3 R_BH = X_WB.rotation().transpose() * aim->R_WH;
    const Vector3 p_BQ = X_WB.inverse() * aim->p_WQ;
    const double depth = probe_.Around(interval.frame, variants, p_BQ, R_BH.col(2)).to;
    if (interval.kind == ContactInterval::Kind::kTouch) {
      aim->lift = depth;
      aim->pointing = 1;
      return;
    }
    aim->lift = std::max(0.0, depth - kDeepest);
    const Vector3 p_BH = p_BQ + aim->lift * R_BH.col(2);
    const Span across = probe_.Around(interval.frame, variants, p_BH, R_BH.col(0));
    if (across.to - across.from > kWidestGrip) {
      aim->lift = depth + kFingertipRadius;
    } else {
      // Near an edge, shifts the hand towards the middle of the object so that the fingers reach
      // both sides.
      const double middle = (across.to + across.from) / 2;
      const double room = kWidestGrip / 2 - (across.to - across.from) / 2;
      const double shift = middle - std::clamp(middle, -room, room);
      aim->p_WQ += shift * aim->R_WH.col(0);
      aim->reach = Reach(shift - across.from, across.to - shift);
      for (std::size_t digit = 0; digit < kDigits; ++digit) {
        const Vector3 p_BDigit = p_BH + R_BH * (GripLine(side_, digit) + Vector3(shift, 0, 0));
        const Span along = probe_.Around(interval.frame, variants, p_BDigit, R_BH.col(0));
        const double at = digit == 0 ? -along.from : along.to;
        if (at > 0) aim->reach[digit] = std::min(at, kWidestGrip);
      }
    }
    // Raises the hand so that the fingertips do not enter the table.
    const double lowest = kFingertipRadius - aim->p_WQ.z();
    if (aim->p_WQ.y() < edge_ && aim->p_WQ.z() > -0.05) aim->lift = std::max(aim->lift, lowest);
  }

  Aim AimAt(std::size_t index, const scene::VisualState& state) const {
    const ContactInterval& interval = intervals_[index];
    const RigidTransform& X_WB = state.poses[interval.frame];
    Aim aim = BeginOf(interval, yaws_[index]);
    // A holding hand rotates with the object, but no farther than the wrist allows from its natural
    // rotation.
    if (interval.kind == ContactInterval::Kind::kHold) {
      const Matrix3 R_begin = interval.begin.poses[interval.frame].rotation();
      const Matrix3 R_with_it = X_WB.rotation() * R_begin.transpose() * aim.R_WH;
      aim.p_WQ = X_WB * interval.p_BQ;
      const Matrix3 R_natural = NaturalRotation(side_, aim.p_WQ, edge_);
      aim.R_WH = TurnedTowards(R_natural, R_with_it, kMostTwist);
    }
    aim.p_WQ = X_WB * interval.p_BQ;
    FitGrip(interval, X_WB, state.variants, &aim);
    return aim;
  }

  /// Computes the aim at the begin of the next contact, which the motion towards it needs.
  void ComputeNextAim() {
    ahead_ = next_ < intervals_.size() ? std::optional(AimAt(next_, intervals_[next_].begin))
                                       : std::nullopt;
  }

  /// Returns the time for a motion at the desired peak speed [s].
  static double MotionSeconds(const Aim& from, const Aim& to) {
    const double distance = (to.p_WQ - from.p_WQ).norm();
    return std::max(kMinMotionSeconds, distance * kPeakOverMean / kPeakSpeed);
  }

  /// Returns the aim on the way between two aims.
  /// @param u  fraction of its time that has passed.
  /// @param seconds  duration of the motion.
  static Aim AimDuringMotion(const Aim& from, const Aim& to, double u, double seconds) {
    constexpr double kRise = 0.4;  // share of the time for going up, and again for going down
    const double s = Smooth(u);
    // The hand rises at the begin and descends at the end; fingers open by the same profile.
    const double raised = Smooth(u / kRise) * Smooth((1 - u) / kRise);
    Aim aim;
    aim.p_WQ = from.p_WQ + s * (to.p_WQ - from.p_WQ);
    aim.p_WQ.z() += raised * std::min(0.12, 0.16 * seconds);
    aim.R_WH = from.R_WH;
    const Eigen::AngleAxisd turn(Matrix3(from.R_WH.transpose() * to.R_WH));
    aim.R_WH = from.R_WH * Eigen::AngleAxisd(s * turn.angle(), turn.axis()).toRotationMatrix();
    aim.lift = from.lift + s * (to.lift - from.lift);
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
      aim.reach[digit] =
          from.reach[digit] + s * (to.reach[digit] - from.reach[digit]) + kOpened * raised;
    }
    aim.pointing = from.pointing + Smooth(2 * u - 0.5) * (to.pointing - from.pointing);
    return aim;
  }

  /// Returns the aim between two contacts, before the first or after the last: rests in between if
  /// there is time for both ways, otherwise moves directly.
  Aim AimBetween(std::uint64_t tick) const {
    const Aim rest = Rest();
    const std::optional<Aim>& to = ahead_;
    const double since = now_ ? sim::SecondsOf(tick - intervals_[*now_].last) : 0;
    const double until = to ? sim::SecondsOf(intervals_[next_].first - tick) : 0;
    const double back = now_ ? MotionSeconds(left_, rest) : 0,
                 there = to ? MotionSeconds(rest, *to) : 0;
    if (now_ && to && since + until < back + kShortestRest + there) {
      const double seconds = std::max(since + until, MotionSeconds(left_, *to));
      return AimDuringMotion(left_, *to, since / seconds, seconds);
    }
    if (now_ && since < back) return AimDuringMotion(left_, rest, since / back, back);
    if (to && until < there) return AimDuringMotion(rest, *to, 1 - until / there, there);
    return rest;
  }

  HandSide side_;
  const std::vector<ContactInterval>& intervals_;
  const SurfaceProbe& probe_;
  double edge_;
  std::vector<double> yaws_;  ///< one per interval
  std::size_t next_ = 0;
  std::optional<std::size_t> now_;  ///< the last one that has begun
  std::optional<Aim> ahead_;        ///< at the begin of the next contact
  Aim left_;                        ///< at the end of the last contact
  Aim is_;                          ///< present state, except position: p_WH_
  Vector3 p_WH_ = Vector3::Zero();
  std::uint64_t tick_ = 0;
  bool is_begun_ = false;
};

}  // namespace

HandTrack::HandTrack(const recording::Recording& recording) {
  const model::Model& model = *recording.model;
  const SurfaceProbe probe(model);
  schedule_ = HandScheduleOf(recording, probe);
  const double edge = recording.scene().table.y_span / 2;
  HandPlayer left(HandSide::kLeft, schedule_.of[0], probe, edge);
  HandPlayer right(HandSide::kRight, schedule_.of[1], probe, edge);
  recording::TraceReader trace(recording);
  while (const auto moment = trace.Next()) {
    const scene::VisualState state = recording::VisualStateAt(*moment, model);
    samples_.push_back(
        {moment->tick, {left.GoTo(moment->tick, state), right.GoTo(moment->tick, state)}});
  }
  if (samples_.empty()) {
    throw InputError({(recording.directory / "trace.bin").string(), 0, "", "contains no moment"});
  }
}

const std::array<HandPosture, kHandSides.size()>& HandTrack::At(std::uint64_t tick) const {
  const auto after = std::upper_bound(
      samples_.begin(), samples_.end(), tick,
      [](std::uint64_t value, const Sample& sample) { return value < sample.tick; });
  return (after == samples_.begin() ? after : after - 1)->hands;
}

}  // namespace smile::picture

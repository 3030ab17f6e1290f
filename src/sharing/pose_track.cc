#include "sharing/pose_track.h"

#include <cmath>
#include <utility>

#include "base/diagnostic.h"
#include "scene/units.h"

// Each tick is the number of frames that moved, and for each of them the distance of its number
// from that of the frame before and seven differences from its last pose. Numbers are written in
// groups of seven bits, the lowest first; differences alternate in sign (0, -1, 1, -2, …), so small
// ones are short. A resting world costs one byte per tick.

namespace smile::sharing {
namespace {

constexpr std::size_t kNumbersPerPose = 7;
constexpr double kMaxSteps = 1e12;  // far from overflow, and from any table

}  // namespace

void PoseTrack::Fail(const std::string& message) const {
  throw InputError(Diagnostic{.file = file_, .message = message});
}

std::int64_t PoseTrack::Rounded(double steps) const {
  // Written so that NaN is refused, too.
  if (!(std::abs(steps) < kMaxSteps)) Fail("has an object far out of the world");
  return std::llround(steps);
}

PoseTrack::Steps PoseTrack::StepsOf(const RigidTransform& X_WF) const {
  const Vector3 p = scene::ToFileUnits(X_WF.translation(), meters_per_unit_);
  const Quaternion q = X_WF.quaternion();
  Steps steps;
  steps.reserve(kNumbersPerPose);
  for (const double number : {p.x(), p.y(), p.z()})
    steps.push_back(Rounded(number * kPositionSteps));
  for (const double number : {q.x(), q.y(), q.z(), q.w()})
    steps.push_back(Rounded(number * kRotationSteps));
  return steps;
}

void PoseTrack::Add(const scene::FramePoses& poses) {
  if (num_ticks_ == kMaxTicks) Fail("is longer than an hour, the most that can be shared");
  if (sent_.empty()) sent_.assign(poses.size(), Steps(kNumbersPerPose, 0));
  std::vector<std::pair<std::size_t, Steps>> moved;
  for (std::size_t frame = 1; frame < poses.size(); ++frame) {
    Steps now = StepsOf(poses[frame]);
    if (num_ticks_ == 0 || now != sent_[frame]) moved.emplace_back(frame, std::move(now));
  }
  num_poses_ += moved.size();
  if (num_poses_ > kMaxPoses) Fail("has more motion than can be shared");
  ++num_ticks_;
  Put(moved.size());
  std::size_t frame_before = 0;
  for (auto& [frame, now] : moved) {
    Put(frame - std::exchange(frame_before, frame));
    for (std::size_t k = 0; k < kNumbersPerPose; ++k) PutDifference(now[k] - sent_[frame][k]);
    sent_[frame] = std::move(now);
  }
}

void PoseTrack::Put(std::uint64_t number) {
  constexpr std::uint64_t kMore = 0x80;
  for (; number >= kMore; number >>= 7) bytes_.push_back(static_cast<char>(number | kMore));
  bytes_.push_back(static_cast<char>(number));
}

void PoseTrack::PutDifference(std::int64_t difference) {
  Put((static_cast<std::uint64_t>(difference) << 1) ^ static_cast<std::uint64_t>(difference >> 63));
}

}  // namespace smile::sharing

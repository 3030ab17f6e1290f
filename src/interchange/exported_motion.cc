#include "interchange/exported_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/diagnostic.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"

namespace smile::interchange {
namespace {

/// Limit of poses in a file, which has about 100 bytes for each.
constexpr std::size_t kMaxPoses = 5'000'000;

/// Collects the motion of a model, moment by moment.
class MotionCollector {
 public:
  explicit MotionCollector(const model::Model& model) : model_(model) {
    const scene::VisualModel& visible = model.visual_model();
    for (int frame = 0; frame < visible.num_frames; ++frame) {
      motion_.frames.push_back({.name = NameOf(static_cast<std::size_t>(frame))});
    }
    for (const scene::Visual& visual : visible.visuals) Add(visual);
    is_shown_.resize(motion_.frames.size());
    hidden_since_.resize(motion_.frames.size());
  }

  void Append(double seconds, const scene::VisualState& state, bool is_robot_shown) {
    const auto moment = static_cast<std::uint32_t>(motion_.seconds.size());
    motion_.seconds.push_back(seconds);
    for (std::size_t f = 0; f < motion_.frames.size(); ++f) {
      MovingFrame& frame = motion_.frames[f];
      const bool is_hidden = IsOfRobot(f) && !is_robot_shown;
      bool is_any_shown = frame.visuals.empty();
      for (MovingVisuals& group : frame.visuals) {
        const bool is_shown = !is_hidden && IsIn(group, state);
        if (group.shown.empty() || group.shown.back().second != is_shown) {
          group.shown.emplace_back(moment, is_shown);
        }
        is_any_shown |= is_shown;
      }
      AppendPose(moment, state.poses[f], is_any_shown, f);
    }
  }

  std::size_t num_poses() const { return num_poses_; }

  ExportedMotion Take() {
    for (MovingFrame& frame : motion_.frames) {
      if (frame.moments.empty()) frame = {frame.name, {0}, {RigidTransform()}, frame.visuals};
      std::erase_if(frame.visuals, [](const MovingVisuals& group) {
        return group.shown.size() == 1 && !group.shown.front().second;
      });
    }
    return std::move(motion_);
  }

 private:
  std::string NameOf(std::size_t frame) const {
    if (frame == 0) return "table";
    if (!IsOfRobot(frame)) return model_.id(*model_.object_of(model::FrameIndex(frame)));
    const std::size_t first = *model_.robot_frames().begin();
    return frame == first ? "robot_base" : model_.robot()->links[frame - first - 1].name;
  }

  bool IsOfRobot(std::size_t frame) const {
    return frame > 0 && !model_.object_of(model::FrameIndex(frame)).has_value();
  }

  void Add(const scene::Visual& visual) {
    auto& groups = motion_.frames[static_cast<std::size_t>(visual.frame)].visuals;
    const auto found = std::ranges::find_if(groups, [&](const MovingVisuals& group) {
      return group.choice == visual.choice && group.variant == visual.variant;
    });
    if (found != groups.end()) {
      found->visuals.push_back(visual);
    } else {
      groups.push_back({.choice = visual.choice, .variant = visual.variant, .visuals = {visual}});
    }
  }

  static bool IsIn(const MovingVisuals& group, const scene::VisualState& state) {
    return group.choice < 0 ||
           state.variants[static_cast<std::size_t>(group.choice)] == group.variant;
  }

  /// A frame that is hidden has no pose; it waits where it will appear.
  void AppendPose(std::uint32_t moment, const RigidTransform& X_WF, bool is_shown, std::size_t f) {
    const bool appears = is_shown && !is_shown_[f];
    if (!is_shown && is_shown_[f]) hidden_since_[f] = moment;
    is_shown_[f] = is_shown;
    MovingFrame& frame = motion_.frames[f];
    if (!is_shown || (!frame.X_WF.empty() && frame.X_WF.back() == X_WF)) return;
    if (!frame.moments.empty()) {
      // It rested until now; or it was away, and comes back somewhere else.
      const std::uint32_t end_of_rest = appears ? hidden_since_[f] : moment - 1;
      if (frame.moments.back() < end_of_rest) PushPose(end_of_rest, frame.X_WF.back(), &frame);
      if (appears && frame.moments.back() + 1 < moment) PushPose(moment - 1, X_WF, &frame);
    }
    PushPose(moment, X_WF, &frame);
  }

  /// The pose is a copy, since it may be one of the frame's own.
  void PushPose(std::uint32_t moment, RigidTransform X_WF, MovingFrame* frame) {
    frame->X_WF.push_back(std::move(X_WF));
    frame->moments.push_back(moment);
    ++num_poses_;
  }

  const model::Model& model_;
  ExportedMotion motion_;
  std::vector<bool> is_shown_;               ///< of each frame, at the last moment
  std::vector<std::uint32_t> hidden_since_;  ///< of each frame that is hidden: the moment
  std::size_t num_poses_ = 0;
};

/// Moves the bodies and the robot of a world to where a recording is.
void MoveTo(const recording::TraceTick& moment, const scene::VisualState& state,
            ExportedWorld* world) {
  for (ExportedBody& body : world->bodies) {
    if (body.frame > 0) body.spec.X_WB = state.poses[static_cast<std::size_t>(body.frame)];
  }
  if (world->robot) world->robot->q = moment.joints;
}

}  // namespace

std::vector<Quaternion> MovingFrame::Rotations() const {
  std::vector<Quaternion> rotations;
  for (const RigidTransform& pose : X_WF) {
    Quaternion q = pose.quaternion();
    if (!rotations.empty() && q.dot(rotations.back()) < 0) q.coeffs() = -q.coeffs();
    rotations.push_back(q);
  }
  return rotations;
}

ExportedScene SceneOf(const sim::RunningModel& running) {
  MotionCollector collector(*running.model());
  collector.Append(0, running.visual_state(), /*is_robot_shown=*/true);
  return {.world = WorldOf(running), .motion = collector.Take()};
}

ExportedScene SceneAfter(double seconds, std::shared_ptr<const model::Model> model) {
  sim::RunningModel running(std::move(model));
  for (long tick = std::lround(seconds * sim::kTicksPerSecond); tick > 0; --tick) running.Tick();
  return SceneOf(running);
}

ExportedScene SceneOf(const recording::Recording& recording, const recording::TimeRange& range,
                      double rate) {
  const recording::TickRange ticks = TicksOf(range, recording);
  ExportedScene scene{.world = WorldOf(sim::RunningModel(recording.model))};
  MotionCollector collector(*recording.model);
  recording::TraceReader trace(recording);
  std::uint64_t frame = 0;
  for (auto moment = trace.At(ticks.first); moment && moment->tick <= ticks.last;
       moment = trace.Next()) {
    const std::uint64_t since = moment->tick - ticks.first;
    const bool is_due = recording::IsFrameDue(frame, since, rate);
    if (!is_due && moment->tick != ticks.last) continue;
    if (is_due) ++frame;
    const scene::VisualState state = VisualStateAt(*moment, *recording.model);
    if (since == 0) MoveTo(*moment, state, &scene.world);
    collector.Append(sim::SecondsOf(since), state, moment->is_robot_shown);
    if (collector.num_poses() > kMaxPoses) {
      throw InputError({recording.directory.string(), 0, "",
                        "there are more than " + std::to_string(kMaxPoses) +
                            " poses; choose a smaller --rate or a part"});
    }
  }
  scene.motion = collector.Take();
  scene.world.left_out = {"the hands of the demonstrator"};
  return scene;
}

}  // namespace smile::interchange

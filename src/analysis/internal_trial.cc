#include "analysis/internal_trial.h"

#include <algorithm>
#include <type_traits>
#include <variant>

#include "sim/command.h"

namespace smile::analysis {
namespace {

constexpr double kMeters = 0.001;

Vector3 InMeters(const std::array<int, 2>& shift_mm) {
  return {kMeters * shift_mm[0], kMeters * shift_mm[1], 0};
}

/// Displaces the points of a command.
void ShiftCommand(const Vector3& shift, sim::Command* command) {
  std::visit(
      [&shift]<class Kind>(Kind& one) {
        if constexpr (std::is_same_v<Kind, sim::MoveTo>) one.p_WH += shift;
        if constexpr (requires { one.p_WQ; }) {
          if (one.p_WQ) *one.p_WQ += shift;
        }
      },
      *command);
}

scene::ObjectSpec& ObjectIn(scene::SceneSpec* scene, const std::string& id) {
  return *std::ranges::find(scene->objects, id, &scene::ObjectSpec::id);
}

}  // namespace

std::string KeyOf(const Trial& trial) {
  std::string key = "order";
  for (const std::size_t subtask : trial.order) key += " " + std::to_string(subtask + 1);
  if (trial.shift_mm != std::array{0, 0}) {
    key += ", shift " + std::to_string(trial.shift_mm[0]) + " " + std::to_string(trial.shift_mm[1]);
  }
  if (trial.repaint) {
    key += ", color " + ToString(trial.repaint->color) + " of " + trial.repaint->object;
  }
  return key;
}

std::shared_ptr<const model::Model> StartModelOf(const Trial& trial,
                                                 const recording::Recording& recording) {
  if (trial.shift_mm == std::array{0, 0} && !trial.repaint) return recording.start_model;
  scene::SceneSpec scene = recording.start_scene();
  for (scene::ObjectSpec& object : scene.objects) {
    if (object.is_static()) continue;
    object.whole.X_PE =
        RigidTransform(object.pose_in_world().rotation(),
                       object.pose_in_world().translation() + InMeters(trial.shift_mm));
  }
  if (trial.repaint) ObjectIn(&scene, trial.repaint->object).whole.color = trial.repaint->color;
  return std::make_shared<const model::Model>(std::move(scene), recording.robot());
}

void ShiftHands(const std::array<int, 2>& shift_mm, recording::Demonstration* demonstration) {
  const Vector3 shift = InMeters(shift_mm);
  for (recording::LoggedCommand& one : demonstration->past) ShiftCommand(shift, &one.command);
  for (recording::EditableSegment& segment : demonstration->segments) {
    for (recording::SegmentCommand& one : segment.commands) ShiftCommand(shift, &one.command);
  }
}

texts::UserMessage WhyNotShifted(const recording::Recording& recording) {
  const scene::SceneSpec& scene = recording.start_scene();
  if (!scene.sliders.empty() || !scene.chains.empty()) return texts::Say("analysis.hasLinks");
  const bool is_changed = std::ranges::any_of(recording.commands, [](const auto& one) {
    return std::holds_alternative<sim::Spawn>(one.command) ||
           std::holds_alternative<sim::Load>(one.command);
  });
  if (is_changed) return texts::Say("analysis.isChanged");
  return {};
}

}  // namespace smile::analysis

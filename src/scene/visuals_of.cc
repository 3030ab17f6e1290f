#include <cstddef>

#include "base/overloaded.h"
#include "scene/internal_lights.h"
#include "scene/solid.h"
#include "scene/visual_model.h"

namespace smile::scene {
namespace {

/// Collects the visible pieces. Most are the collision shapes; meshes and lights differ from these.
class VisualCollector {
 public:
  void Append(const Part& part, Visual place) {
    // Parts without an id belong to the innermost part that has one.
    if (!part.id.empty()) place.part_id = part.id;
    std::visit(
        Overloaded{[&](const Composite& composite) { AppendAll(composite.parts, place); },
                   // Drawn as its exact surface, while collisions use convex pieces.
                   [&](const Custom& custom) {
                     place.shape = DrawnMesh{custom.mesh, custom.scale};
                     place.color = part.color;
                     visuals_.push_back(place);
                   },
                   // Lights and the parts of a custom control are visible only in their
                   // state.
                   [&](const IndicatorLights& lights) {
                     place.choice = num_controls_++;
                     for (std::size_t variant = 0; variant < lights.states.size(); ++variant) {
                       place.variant = static_cast<int>(variant);
                       AppendLights(lights, lights.states[variant], place);
                     }
                   },
                   [&](const CustomControl& control) {
                     place.choice = num_controls_++;
                     for (std::size_t variant = 0; variant < control.states.size(); ++variant) {
                       place.variant = static_cast<int>(variant);
                       AppendAll(control.states[variant].parts, place);
                     }
                   },
                   [&](const ToggleSwitch&) {
                     const int number = num_controls_++;
                     AppendAsFelt(part, place, number);
                   },
                   [&](const auto&) { AppendAsFelt(part, place, place.choice); }},
        part.shape);
  }

  std::vector<Visual> Take() { return std::move(visuals_); }

 private:
  void AppendAll(const std::vector<Part>& parts, const Visual& place) {
    for (const Part& child : parts) {
      // Children inherit choice, variant and part from the element around them.
      Visual there = place;
      there.X_FV = place.X_FV * child.X_PE;
      Append(child, there);
    }
  }

  /// Appends the part's own solids; a switch has a variant for each of its positions.
  void AppendAsFelt(const Part& part, const Visual& place, int choice) {
    for (const Solid& solid : SolidsOf(part)) {
      Visual visual = place;
      visual.shape = VisualShapeOf(solid.shape);
      visual.color = solid.color;
      visual.X_FV = place.X_FV * solid.X_BS;
      visual.choice = choice;
      if (solid.control >= 0) visual.variant = solid.variant;
      // The button's id is made of that of the switch.
      if (!part.id.empty()) visual.button = solid.button;
      visuals_.push_back(visual);
    }
  }

  void AppendLights(const IndicatorLights& lights, const IndicatorLights::State& state,
                    const Visual& place) {
    for (const Light& light : state.lights) {
      Visual visual = place;
      visual.shape = DiscOf(lights);
      visual.color = light.color;
      visual.glows = true;
      visual.X_FV = place.X_FV * PoseOfLight(lights, light.number);
      visuals_.push_back(visual);
    }
  }

  std::vector<Visual> visuals_;
  int num_controls_ = 0;
};

}  // namespace

VisualShape VisualShapeOf(const SolidShape& shape) {
  return std::visit([](const auto& solid) { return VisualShape(solid); }, shape);
}

std::vector<Visual> VisualsOf(const Part& whole) {
  VisualCollector collector;
  collector.Append(whole, {});
  return collector.Take();
}

}  // namespace smile::scene

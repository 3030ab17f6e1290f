#pragma once

#include <variant>

#include "scene/shape.h"

namespace smile::scene {

/// Calls `visit` with each child of a part: those of a composite, and those of all states of a
/// custom control.
template <class Visit>
void ForEachChild(const Part& part, const Visit& visit) {
  if (const auto* composite = std::get_if<Composite>(&part.shape)) {
    for (const Part& child : composite->parts) visit(child);
  }
  if (const auto* control = std::get_if<CustomControl>(&part.shape)) {
    for (const CustomControl::State& state : control->states) {
      for (const Part& child : state.parts) visit(child);
    }
  }
}

/// Calls `visit` with the part and everything in it, parents first.
template <class Visit>
void ForEachPart(const Part& part, const Visit& visit) {
  visit(part);
  ForEachChild(part, [&visit](const Part& child) { ForEachPart(child, visit); });
}

}  // namespace smile::scene

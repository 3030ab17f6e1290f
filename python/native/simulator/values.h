#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "arrays.h"
#include "image/image.h"
#include "sim/event.h"
#include "sim/eye.h"

// Events and pictures as values of Python.

namespace smile::python {

/// An event and the tick after which it happened.
struct DatedEvent {
  std::uint64_t tick = 0;
  sim::Event event;
};
py::dict EventDict(const DatedEvent& dated);

/// What a picture shows.
struct PictureRequest {
  sim::EyeSpec spec;  ///< size, and a camera or a view for people
  sim::Channels channels;
};

/// Renders a moment of a model, with the interpreter's lock released.
/// @param state           of the model; called without the lock.
/// @param q               of the robot's joints [rad or m]; empty without one.
/// @returns (rgb or None, depth or None, id or None, K, X_WC).
/// @throws std::invalid_argument if there is no such camera or view.
py::tuple Render(const model::Model& model, const std::function<scene::VisualState()>& state,
                 std::span<const double> q, bool is_robot_shown, const PictureRequest& request);

}  // namespace smile::python

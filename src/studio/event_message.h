#pragma once

#include "base/json.h"
#include "model/model.h"
#include "sim/event.h"

namespace smile::studio {

/// Returns the message `{"t":"event",…}`: the kind and the fields that the event has.
/// @param model  of the scene in which it happened.
Json EventMessage(const sim::Event& event, std::uint64_t tick, const model::Model& model);

}  // namespace smile::studio

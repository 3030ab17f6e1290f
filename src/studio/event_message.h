#pragma once

#include "base/json.h"
#include "sim/simulation.h"

namespace smile::studio {

/// `{"t":"event",…}`: the kind, and what there is to tell of it.
Json EventMessage(const sim::Event& event, const sim::Simulation& simulation);

}  // namespace smile::studio

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/simulation_state.h"

namespace smile::checkpoint {

/// Returns a hash of all that a state needs of its model: the scene, its version of physics, and
/// the files and options of the robot.
std::uint64_t ModelHash(const model::Model& model);

/// Returns a state as a self-contained byte string, for a file or another process of the same
/// build. A simulation that continues from it makes the same bits.
std::vector<std::byte> Serialize(const sim::SimulationState& state);

/// Returns the state that Serialize() wrote.
/// @param start_model  not null; equal to that with which the state's simulation began.
/// @throws std::invalid_argument if the bytes are damaged, written by another version of the
///         format, or the state of another model.
sim::SimulationState ParseState(std::span<const std::byte> bytes,
                                std::shared_ptr<const model::Model> start_model);

}  // namespace smile::checkpoint

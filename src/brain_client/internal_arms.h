#pragma once

#include <vector>

#include "brain_client/brain.h"

namespace smile::brain_client {

/// Return the arms of INIT and STEP; empty if the message has none.
std::vector<Arm> ArmsOf(const Fields& init);
std::vector<ArmSensor> SensedArms(const Fields& step, const std::vector<Arm>& arms);

/// Returns commands of full size, all zero.
std::vector<ArmMotor> StillArms(const std::vector<Arm>& arms);
/// Returns true if a command is other than zero, or has a length in time.
bool AreSet(const std::vector<ArmMotor>& motor);

/// Adds the initial postures of the arms that have one.
/// @throws std::invalid_argument naming the field if it has the wrong size, as does AddArms().
void AddInitJoints(wire::MessageWriter& writer, const std::vector<Arm>& arms, const Aux& aux);
/// Adds the commands for all arms.
void AddArms(wire::MessageWriter& writer, const std::vector<Arm>& arms,
             const std::vector<ArmMotor>& motor);

}  // namespace smile::brain_client

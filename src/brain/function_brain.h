#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/temporary_directory.h"
#include "brain/brain_values.h"

namespace smile::brain {

/// Takes a question as a message of docs/brain-protocol.md (INIT, then STEP after STEP), and
/// returns the answer as one: INIT_DONE, MOTOR, FINAL_MOTOR or ERROR.
using MessageFunction = std::function<std::vector<std::byte>(std::span<const std::byte> question)>;

/// Brain in this process: a function that gets the messages that a process would get. It has no
/// timeouts.
class FunctionBrain {
 public:
  explicit FunctionBrain(MessageFunction function) : function_(std::move(function)) {}

  /// Returns the answer; a BrainError if it is not valid. Throws what the function throws.
  BrainAnswer Answer(const BrainQuestion& question);

 private:
  BrainAnswer Init(const Aux& aux);
  BrainAnswer Step(const Sensor& sensor);

  MessageFunction function_;
  TemporaryDirectory files_;  ///< of the robot
  std::uint32_t sequence_ = 0;
  std::vector<ArmDescription> arms_;  ///< as sent
  std::vector<std::string> cameras_;  ///< as requested
};

}  // namespace smile::brain

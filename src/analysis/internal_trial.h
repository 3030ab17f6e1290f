#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "math/color.h"
#include "model/model.h"
#include "recording/demonstration.h"
#include "recording/recording.h"

namespace smile::analysis {

/// Order of some or all subtasks of a demonstration.
using SubtaskOrder = std::vector<std::size_t>;

/// Object in another color.
struct Repaint {
  std::string object;  ///< id
  Color color;
};

/// Another way of a demonstration, to be simulated.
struct Trial {
  SubtaskOrder order;
  std::array<int, 2> shift_mm{};   ///< of all loose objects and the hands, along x and y
  std::optional<Repaint> repaint;  ///< of one object
};

/// Returns a text that tells trials of a demonstration apart.
std::string KeyOf(const Trial& trial);

/// Returns the model with which a trial starts.
std::shared_ptr<const model::Model> StartModelOf(const Trial& trial,
                                                 const recording::Recording& recording);

/// Displaces the points of all commands of hands.
void ShiftHands(const std::array<int, 2>& shift_mm, recording::Demonstration* demonstration);

/// Returns why a demonstration cannot be displaced as a whole, in words; empty if it can.
texts::UserMessage WhyNotShifted(const recording::Recording& recording);

}  // namespace smile::analysis

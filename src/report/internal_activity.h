#pragma once

#include <string>
#include <vector>

#include "recording/recording.h"
#include "report/markup.h"

namespace smile::report {

/// Interval in which a hand or gripper held an object.
struct Carry {
  std::string object;
  std::string who;            ///< `right hand`, `left gripper`
  double begin = 0, end = 0;  ///< [s since the demonstration began]
};

/// Returns what hands and grippers held in a recording, in the order of release.
/// @throws InputError if its trace cannot be read.
std::vector<Carry> CarriesOf(const recording::Recording& recording);

/// Returns a timeline with a row for each object and a bar for each interval in which it was held.
/// @param seconds  length of the recording.
Markup TimelineOf(const std::vector<Carry>& carries, double seconds, const std::string& words);

}  // namespace smile::report

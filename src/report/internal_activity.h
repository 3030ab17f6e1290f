#pragma once

#include <string>
#include <vector>

#include "recording/recording.h"
#include "report/markup.h"

namespace smile::report {

/// Somebody held something.
struct Carry {
  std::string object;
  std::string who;            ///< `right hand`, `left gripper`
  double begin = 0, end = 0;  ///< [s since the demonstration began]
};

/// What hands and grippers held in a recording, in the order in which it was let go.
/// @throws InputError if its trace cannot be read.
std::vector<Carry> CarriesOf(const recording::Recording& recording);

/// When each object was held: a row each.
/// @param seconds  how long all took.
Markup TimelineOf(const std::vector<Carry>& carries, double seconds, const std::string& words);

}  // namespace smile::report

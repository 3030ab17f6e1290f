#pragma once

#include <string>
#include <vector>

#include "study/participants.h"

namespace smile::study {

/// Result of checking the data of a study.
struct CheckResult {
  std::vector<std::string> notes;     ///< how many participants there are, and how far they are
  std::vector<std::string> findings;  ///< what is missing or unbalanced; empty: nothing

  bool is_good() const { return findings.empty(); }
};

/// Checks that the orders of complete participants are balanced, and that nothing of them is
/// missing: consent, answers, and trials with a recording.
CheckResult Check(const StudyData& data);

}  // namespace smile::study

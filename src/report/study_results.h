#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/statistics.h"

namespace smile::report {

/// A condition of a study with participants.
struct StudyCondition {
  std::string name;
  std::size_t trials = 0, successes = 0;
};

/// One number for each condition and participant.
struct StudyMeasure {
  std::string name;  ///< with its unit
  int digits = 1;    ///< after the point
  /// By condition, then by participant; nullopt if a participant has none.
  std::vector<std::vector<std::optional<double>>> numbers;
};

/// Results of a study in which each participant meets several conditions.
struct StudyResults {
  std::string title;
  std::size_t num_participants = 0;
  std::vector<StudyCondition> conditions;
  std::vector<StudyMeasure> measures;
};

/// Difference between two conditions, within participants.
struct PairedEffect {
  Mean difference;  ///< second minus first, with its interval
  /// Cohen's d_z: the mean of the differences in units of their standard deviation (D. Lakens,
  /// "Calculating and reporting effect sizes to facilitate cumulative science", Frontiers in
  /// Psychology 4 (2013)). nullopt if all differences are equal.
  std::optional<double> cohens_dz;
};

/// Returns the numbers that exist.
std::vector<double> Present(const std::vector<std::optional<double>>& numbers);

/// Compares two conditions by the participants who have both numbers; nullopt if fewer than two do.
std::optional<PairedEffect> EffectOf(const std::vector<std::optional<double>>& first,
                                     const std::vector<std::optional<double>>& second);

}  // namespace smile::report

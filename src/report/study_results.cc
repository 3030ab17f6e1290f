#include "report/study_results.h"

#include <algorithm>
#include <cmath>

namespace smile::report {

std::vector<double> Present(const std::vector<std::optional<double>>& numbers) {
  std::vector<double> present;
  for (const auto& number : numbers) {
    if (number) present.push_back(*number);
  }
  return present;
}

std::optional<PairedEffect> EffectOf(const std::vector<std::optional<double>>& first,
                                     const std::vector<std::optional<double>>& second) {
  std::vector<double> differences;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
    if (first[k] && second[k]) differences.push_back(*second[k] - *first[k]);
  }
  if (differences.size() < 2) return std::nullopt;
  PairedEffect effect{.difference = *MeanOf(differences)};
  double squares = 0;
  for (const double difference : differences) {
    squares += std::pow(difference - effect.difference.value, 2);
  }
  const double deviation = std::sqrt(squares / static_cast<double>(differences.size() - 1));
  if (deviation > 0) effect.cohens_dz = effect.difference.value / deviation;
  return effect;
}

}  // namespace smile::report

#include "mechanics/slider_damping.h"

#include <cmath>

namespace smile::mechanics {
namespace {

/// Returns the fraction of the speed that a soft slider keeps in this step: in the outer part of
/// its range the speed towards the limit falls in proportion to the remaining displacement
/// (implicit Euler).
double SoftFractionKept(const SliderJointSpec& slider, double offset, double speed,
                        double seconds) {
  const double middle = (slider.lower + slider.upper) / 2;
  const double half = (slider.upper - slider.lower) / 2;
  const double from_middle = std::abs(offset - middle);
  const double approach = offset > middle ? speed : -speed;
  const double remaining = half - from_middle;
  if (from_middle <= slider.softness * half || remaining <= 0 || approach <= 0) return 1;
  return 1 / (1 + approach * seconds / remaining);
}

}  // namespace

double FractionKept(const SliderJointSpec& slider, double offset, double speed, bool is_carried,
                    double seconds) {
  double kept = SoftFractionKept(slider, offset, speed, seconds);
  if (!is_carried) kept *= std::pow(1 - slider.damping, seconds);
  return kept;
}

}  // namespace smile::mechanics

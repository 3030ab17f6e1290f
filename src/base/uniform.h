#pragma once

#include <random>

namespace smile {

/// Returns a number uniformly distributed between `low` and `high`. The C++ library's distributions
/// differ between implementations; this one does not.
inline double Uniform(std::mt19937_64* random, double low, double high) {
  return low + (high - low) * (static_cast<double>((*random)() >> 11) * 0x1.0p-53);
}

}  // namespace smile

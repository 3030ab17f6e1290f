#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace smile {

/// 64-bit hash of a state, fed value by value in a fixed order.
///
/// Numbers enter by their bits: two states with equal hashes agree to the last bit of everything
/// fed (up to a collision, about 1 in 2^64). Not for cryptography. The mixing step is a
/// multiplication by 2^64 divided by the golden ratio followed by a fold, as in D. Knuth, TAOCP
/// vol. 3, section 6.4.
class StateHash {
 public:
  void Add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9E3779B97F4A7C15u;
    value_ ^= value_ >> 32;
  }
  void Add(double number) { Add(std::bit_cast<std::uint64_t>(number)); }
  void Add(std::span<const double> numbers) {
    for (double number : numbers) Add(number);
  }
  void Add(std::string_view text) {
    Add(std::uint64_t{text.size()});
    for (char letter : text) Add(std::uint64_t{static_cast<unsigned char>(letter)});
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace smile

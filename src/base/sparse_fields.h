#pragma once

#include <cmath>
#include <cstdint>

#include "base/bytes.h"

// A value of which many fields are 0, such as a contact point, takes less room if these are left
// out. In both functions, Fields::Visit(value, visit) calls `visit` with each number of a value, of
// which there are at most 64, always in the same order.

namespace smile {

/// Writes a bit for each field, u64, and then those that are not 0. -0 is not 0 here.
template <class Fields, class T>
void PutSparse(const T& value, ByteWriter* out) {
  const auto is_zero = [](auto number) { return number == 0 && !std::signbit(number); };
  std::uint64_t bits = 0, bit = 1;
  Fields::Visit(value, [&](auto number) {
    if (!is_zero(number)) bits |= bit;
    bit <<= 1;
  });
  out->Put(bits);
  Fields::Visit(value, [&](auto number) {
    if (!is_zero(number)) out->Put(number);
  });
}

/// Reads all fields of a value that PutSparse() wrote.
template <class Fields, class T>
void GetSparse(ByteReader* in, T* value) {
  auto bits = in->Get<std::uint64_t>();
  Fields::Visit(*value, [&]<class Number>(Number& number) {
    number = (bits & 1) != 0 ? in->Get<Number>() : Number();
    bits >>= 1;
  });
}

}  // namespace smile

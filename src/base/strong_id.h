#pragma once

#include <compare>
#include <cstdint>

namespace smile {

/// A small number that names one thing of one kind; 0 names nothing. `Tag` keeps kinds apart.
template <class Tag>
struct StrongId {
  std::uint32_t value = 0;

  explicit operator bool() const { return value != 0; }
  auto operator<=>(const StrongId&) const = default;
};

}  // namespace smile

#pragma once

#include <compare>
#include <cstdint>

namespace smile {

/// Small number that identifies one thing of one kind; 0 identifies none. `Tag` distinguishes
/// kinds.
template <class Tag>
struct StrongId {
  std::uint32_t value = 0;

  explicit operator bool() const { return value != 0; }
  auto operator<=>(const StrongId&) const = default;
};

}  // namespace smile

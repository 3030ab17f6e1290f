#pragma once

#include <cstdint>
#include <string>

namespace smile {

/// Returns a hash as 16 hexadecimal digits.
std::string HashText(std::uint64_t hash);

}  // namespace smile

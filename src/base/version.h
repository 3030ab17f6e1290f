#pragma once

#include <string>

namespace smile {

/// Returns `smile 0.1.0`.
std::string ProgramName();

}  // namespace smile

#pragma once

#include <nlohmann/json.hpp>

namespace smile {

/// JSON with the order of keys as written: logs and results read the way they were meant.
using Json = nlohmann::ordered_json;

}  // namespace smile

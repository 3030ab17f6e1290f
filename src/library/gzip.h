#pragma once

#include <string>
#include <string_view>

namespace smile::library {

/// Compresses bytes as a gzip file without name and time: same bytes, same file.
/// @throws std::runtime_error with the reason.
std::string Gzipped(std::string_view bytes);

}  // namespace smile::library

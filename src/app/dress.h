#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "record/recording.h"
#include "record/redraw.h"

namespace smile::app {

/// Copies a recording with another demonstrator in its pictures, and tells how far it is.
/// @returns how many pictures it has.
/// @throws as record::Redraw(); std::runtime_error when the user does not want to wait for it.
std::size_t Dress(const record::Recording& recording, const std::filesystem::path& out,
                  const record::RedrawOptions& copy);

/// Copies of a recording, one for each demonstrator, in a folder:
///
///     forearm/         the recording
///     forearm.json     what it depends on; written last
///
/// What is there already is made again only if it depends on something else; then it moves aside.
/// @param looks       each another.
/// @param depends_on  what the copies depend on, but for the demonstrator.
/// @returns where they are.
std::vector<std::filesystem::path> DressAll(const std::string& demo,
                                            const std::vector<std::string>& looks, bool has_symbols,
                                            const std::filesystem::path& folder,
                                            const Json& depends_on);

}  // namespace smile::app

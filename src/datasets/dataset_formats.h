#pragma once

#include <array>
#include <string_view>

namespace smile::datasets {

/// Formats of datasets that the Python package writes; see docs/datasets.md.
inline constexpr std::array<std::string_view, 7> kDatasetFormats{
    "lerobot-v3.0", "lerobot-v2.1", "robomimic", "zarr", "mcap", "rrd", "csv"};

}  // namespace smile::datasets

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "classic/redraw.h"
#include "experiment/callbacks.h"
#include "recording/recording.h"

namespace smile::experiment {

/// Copies a recording with another demonstrator in its pictures.
/// @returns the number of pictures.
/// @throws as classic::Redraw(), also when it is cancelled.
std::size_t Rerender(const recording::Recording& recording, const std::filesystem::path& out,
                     const classic::RedrawOptions& copy, const Callbacks& callbacks = {});

/// Copies of a recording, one for each demonstrator.
struct DemonstratorCopies {
  std::filesystem::path demonstration;
  std::vector<std::string>
      demonstrators;        ///< words of recording::DemonstratorAppearance, each once
  bool has_symbols = true;  ///< the texts of the classic view
  Json depends_on;          ///< everything the copies depend on, except the demonstrator
};

/// Makes the copies in a folder:
///
///     forearm/         the recording
///     forearm.json     what it depends on; written last
///
/// Finished copies are kept; one that depends on something else moves aside.
/// @returns their paths, in order.
std::vector<std::filesystem::path> MakeCopies(const DemonstratorCopies& copies,
                                              const std::filesystem::path& folder,
                                              const Callbacks& callbacks = {});

}  // namespace smile::experiment

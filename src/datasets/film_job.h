#pragma once

#include <filesystem>

#include "datasets/job_queue.h"
#include "library/library.h"
#include "page/requests.h"

namespace smile::datasets {

/// Returns the job that films a recording, as a page requests it: `smile render` makes
/// `films/NAME.mp4` in the folder of the library.
/// @param program  executable with `render`.
/// @throws page::RequestError if a field is faulty, or there is a film of this name.
Job FilmJob(const page::Request& request, const library::Library& library,
            const std::filesystem::path& program);

}  // namespace smile::datasets

#pragma once

#include "library/library.h"
#include "page/requests.h"
#include "studio/background_jobs.h"

namespace smile::studio {

/// Adds the requests of a library: `library`, `rename`, `bin`, `unbin`, `open`, `analyze`,
/// `try_edit`, `edit` and `cancel`. Slow ones are background jobs, whose deferred messages the
/// table returns.
///
/// Both must outlive the table, and the library must outlive the jobs.
void AddLibraryRequests(const library::Library* library, BackgroundJobs* jobs,
                        page::RequestTable* table);

}  // namespace smile::studio

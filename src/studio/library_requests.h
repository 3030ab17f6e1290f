#pragma once

#include "library/library.h"
#include "page/requests.h"
#include "studio/workshop.h"

namespace smile::studio {

/// Puts in what may be asked of a library: `library`, `rename`, `bin`, `unbin`, `open`, `try_edit`,
/// `edit` and `cancel`. What takes its time is done in the workshop, whose letters the table passes
/// on.
///
/// Both must outlive the table, and the library the workshop.
void AddLibraryRequests(const library::Library* library, Workshop* workshop,
                        page::RequestTable* table);

}  // namespace smile::studio

#pragma once

#include "page/requests.h"

namespace smile::page {

/// Adds `keep_control`, by which the controller refuses a client `from` that asked for control; the
/// client receives `{"t":"control_kept"}`.
void AddControlRequests(RequestTable* table);

}  // namespace smile::page

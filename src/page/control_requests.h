#pragma once

#include "page/requests.h"

namespace smile::page {

/// Lets the controller answer a client who asked for control: `keep_control` with `from`, the
/// client, who is told `{"t":"control_kept"}`.
void AddControlRequests(RequestTable* table);

}  // namespace smile::page

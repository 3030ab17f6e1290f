#pragma once

#include "studio/requests.h"

namespace smile::studio {

/// Lets the controller answer a client who asked for control: `keep_control` with `from`, the
/// client, who is told `{"t":"control_kept"}`.
void AddControlRequests(RequestTable* table);

}  // namespace smile::studio

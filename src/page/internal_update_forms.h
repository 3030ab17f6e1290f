#pragma once

#include <vector>

#include "page/page_protocol.h"

namespace smile::page {

/// Makes what UpdateForms() returns.
std::vector<UpdateForm> MakeUpdateForms();

}  // namespace smile::page

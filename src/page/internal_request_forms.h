#pragma once

#include <vector>

#include "page/page_protocol.h"

namespace smile::page {

/// Makes what RequestForms() returns.
std::vector<RequestForm> MakeRequestForms();

}  // namespace smile::page

#pragma once

#include <vector>

#include "page/page_protocol.h"

namespace smile::page {

/// What RequestForms() returns.
std::vector<RequestForm> MakeRequestForms();

}  // namespace smile::page

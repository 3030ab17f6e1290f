#pragma once

#include <vector>

#include "page/page_protocol.h"

namespace smile::page {

/// Returns the table for RequestForms().
std::vector<RequestForm> MakeRequestForms();

}  // namespace smile::page

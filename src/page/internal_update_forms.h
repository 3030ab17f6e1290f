#pragma once

#include <vector>

#include "page/page_protocol.h"

namespace smile::page {

/// Returns the table for UpdateForms().
std::vector<UpdateForm> MakeUpdateForms();

}  // namespace smile::page

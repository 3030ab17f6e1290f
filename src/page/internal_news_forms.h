#pragma once

#include <vector>

#include "page/page_protocol.h"

namespace smile::page {

/// What NewsForms() returns.
std::vector<NewsForm> MakeNewsForms();

}  // namespace smile::page

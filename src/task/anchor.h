#pragma once

#include "task/structure.h"

namespace smile::task {

/// Determines what a demonstration has in mind as the place of its structure, and sets `anchor` and
/// `landmark` of the structure; adds the landmark to its objects.
///
/// Usually a structure may stand anywhere. But if it stood, freely placed, before the demonstration
/// began, then nothing of it distinguishes the end from the begin: an object was pushed, put beside
/// another one or exchanged with it. What was shown is then the place relative to what stayed: to
/// the nearest object that the demonstration did not move, or to the table if there is none.
void FindAnchor(const Episode& demonstration, Structure* structure);

}  // namespace smile::task

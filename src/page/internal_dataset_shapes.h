#pragma once

#include "base/json_shape.h"

namespace smile::page {

// Shapes of generated sets, datasets and the jobs that make them; all are named types.

JsonShape GeneratedSetShape();
JsonShape SetAttemptShape();
JsonShape JobShape();
JsonShape VariationShape();

}  // namespace smile::page

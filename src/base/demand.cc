#include "base/demand.h"

#include <cstdio>
#include <cstdlib>

namespace smile::internal {

void FailDemand(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: assertion failed: %s (a bug in SMILE)\n", file, line, condition);
  // No exception: a handler would continue with a state that is known to be wrong.
  std::abort();
}

}  // namespace smile::internal

#pragma once

/// Aborts the program if a condition does not hold, which is a bug of its own; in every build.
#define SMILE_DEMAND(condition) \
  ((condition) ? void(0) : ::smile::internal::FailDemand(#condition, __FILE__, __LINE__))

/// The same check, only in builds with assertions.
#ifdef NDEBUG
#define SMILE_ASSERT(condition) void(0)
#else
#define SMILE_ASSERT(condition) SMILE_DEMAND(condition)
#endif

namespace smile::internal {
[[noreturn]] void FailDemand(const char* condition, const char* file, int line);
}  // namespace smile::internal

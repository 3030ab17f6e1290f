#pragma once

/// Stops where one of our own bugs shows, in every build.
#define SMILE_DEMAND(condition) \
  ((condition) ? void(0) : ::smile::internal::FailDemand(#condition, __FILE__, __LINE__))

/// The same, in builds with assertions only.
#ifdef NDEBUG
#define SMILE_ASSERT(condition) void(0)
#else
#define SMILE_ASSERT(condition) SMILE_DEMAND(condition)
#endif

namespace smile::internal {
[[noreturn]] void FailDemand(const char* condition, const char* file, int line);
}  // namespace smile::internal

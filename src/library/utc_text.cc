#include "library/utc_text.h"

#include <ctime>

namespace smile::library {

std::string UtcText(std::int64_t nanoseconds) {
  const std::time_t seconds = nanoseconds / 1'000'000'000LL;
  std::tm utc{};
  char text[40];
  if (gmtime_r(&seconds, &utc) == nullptr) return "";
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

}  // namespace smile::library

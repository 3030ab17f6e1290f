#include "datasets/picture_fields.h"

#include <algorithm>

namespace smile::datasets {
namespace {

constexpr std::uint64_t kMinPixels = 16, kMaxPixels = 1920;

}  // namespace

std::uint64_t WholeFrom(const page::RequestFields& fields, const char* name, std::uint64_t low,
                        std::uint64_t high) {
  const std::uint64_t number = fields.Whole(name, high);
  if (number >= low) return number;
  throw page::RequestError("\"" + std::string(name) + "\" is " + std::to_string(number) +
                           ", expected a number from " + std::to_string(low) + " to " +
                           std::to_string(high));
}

std::string SizeArgument(const page::RequestFields& fields) {
  return std::to_string(WholeFrom(fields, "width", kMinPixels, kMaxPixels)) + "x" +
         std::to_string(WholeFrom(fields, "height", kMinPixels, kMaxPixels));
}

std::string RateArgument(const page::RequestFields& fields) {
  const std::uint64_t rate = fields.Whole("rate", kRates.back());
  if (std::ranges::find(kRates, rate) != kRates.end()) return std::to_string(rate);
  throw page::RequestError("\"rate\" is " + std::to_string(rate) + ", expected a divisor of 60");
}

}  // namespace smile::datasets

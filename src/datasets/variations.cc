#include "datasets/variations.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "base/wording.h"
#include "page/requests.h"

namespace smile::datasets {
namespace {

struct Degree {
  std::string_view name;
  std::string_view ranges;  ///< value of the option
};

struct Kind {
  std::string_view name;
  std::string_view option;  ///< of `smile generate`
  std::span<const Degree> degrees;
};

constexpr std::array kNoiseDegrees{Degree{"mild", "joints=0..0.003,image=0..0.01"},
                                   Degree{"strong", "joints=0..0.01,image=0..0.03"}};
constexpr std::array kLookDegrees{
    Degree{"mild", "brightness=0.9..1.1,turn=-45..45,hue=-8..8,table=0.9..1"},
    Degree{"strong",
           "brightness=0.7..1.15,warmth=-0.3..0.3,turn=-90..90,hue=-15..15,value=0.8..1,"
           "table=0.8..1"}};
constexpr std::array kPatternDegrees{Degree{"any", "plain,stripes,checks"}};
constexpr std::array kCameraDegrees{Degree{"mild", "shift=-0.05..0.05,tilt=-0.5..0.5"}};
constexpr std::array kSpeedDegrees{Degree{"slower", "0.6..1"}};
constexpr std::array kOrderDegrees{Degree{"any", "order"}};
constexpr std::array kDisturbanceDegrees{Degree{"some", "fraction=0.3"}};

constexpr std::array kKinds{Kind{"noise", "--noise", kNoiseDegrees},
                            Kind{"looks", "--looks", kLookDegrees},
                            Kind{"pattern", "--pattern", kPatternDegrees},
                            Kind{"cameras", "--jitter", kCameraDegrees},
                            Kind{"speed", "--speed", kSpeedDegrees},
                            Kind{"order", "--choices", kOrderDegrees},
                            Kind{"disturbances", "--disturb", kDisturbanceDegrees}};

/// Returns the item of this name.
template <class Items>
const auto& Named(const Items& items, const std::string& name, const char* what) {
  const auto found = std::ranges::find(items, name, [](const auto& item) { return item.name; });
  if (found != items.end()) return *found;
  throw page::RequestError("\"variations\": there is no " + std::string(what) + " " + Quoted(name));
}

}  // namespace

Json DescribeVariations() {
  Json kinds = Json::array();
  for (const Kind& kind : kKinds) {
    Json degrees = Json::array();
    for (const Degree& degree : kind.degrees) {
      degrees.push_back({{"name", degree.name}, {"ranges", degree.ranges}});
    }
    kinds.push_back({{"kind", kind.name}, {"degrees", std::move(degrees)}});
  }
  return kinds;
}

std::vector<std::string> VariationArguments(const Json& chosen) {
  std::vector<std::string> arguments;
  for (const auto& [name, degree] : chosen.items()) {
    const Kind& kind = Named(kKinds, name, "kind");
    if (!degree.is_string()) {
      throw page::RequestError("\"variations\": " + Quoted(name) + " is " + degree.type_name() +
                               ", expected the name of a degree");
    }
    const std::string_view ranges =
        Named(kind.degrees, degree.get<std::string>(), kind.name.data()).ranges;
    arguments.insert(arguments.end(), {std::string(kind.option), std::string(ranges)});
  }
  return arguments;
}

}  // namespace smile::datasets

#include "base/json.h"

#include <stdexcept>

namespace smile {

Json ParseJson(std::string_view text) {
  constexpr int kMaxDepth = 32, kMaxKeys = 10'000;
  int num_keys = 0;
  const auto check = [&num_keys](int depth, Json::parse_event_t event, Json&) {
    if (depth > kMaxDepth) throw std::invalid_argument("this JSON is nested deeper than 32 levels");
    if (event == Json::parse_event_t::key && ++num_keys > kMaxKeys) {
      throw std::invalid_argument("this JSON has more than 10000 keys");
    }
    return true;
  };
  try {
    return Json::parse(text, check);
  } catch (const Json::exception&) {
    throw std::invalid_argument("this is not JSON");
  }
}

std::string ToText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace smile

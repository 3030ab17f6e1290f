#include "base/json.h"

#include <stdexcept>

namespace smile {
namespace {

/// Looks at the parser's events and keeps nothing. (A callback of the parser that keeps values
/// looks through the whole array around each of them that ends: hours, for ten megabytes.)
class LimitCheck : public Json::json_sax_t {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override {
    constexpr int kMaxKeys = 10'000;
    if (++num_keys_ <= kMaxKeys) return true;
    throw std::invalid_argument("this JSON has more than 10000 keys");
  }
  bool start_object(std::size_t) override { return Begin(); }
  bool start_array(std::size_t) override { return Begin(); }
  bool end_object() override { return End(); }
  bool end_array() override { return End(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    throw std::invalid_argument("this is not JSON");
  }

 private:
  bool Begin() {
    constexpr int kMaxDepth = 32;
    if (++depth_ <= kMaxDepth) return true;
    throw std::invalid_argument("this JSON is nested deeper than 32 levels");
  }
  bool End() {
    --depth_;
    return true;
  }

  int depth_ = 0;
  int num_keys_ = 0;
};

}  // namespace

Json ParseJson(std::string_view text) {
  LimitCheck limits;
  Json::sax_parse(text, &limits);
  return Json::parse(text);
}

std::string ToText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace smile

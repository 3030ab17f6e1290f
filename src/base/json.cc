#include "base/json.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace smile {
namespace {

/// Looks at the parser's events and keeps nothing. (A callback of the parser that keeps values
/// looks through the whole array around each of them that ends: hours, for ten megabytes.)
class LimitCheck : public Json::json_sax_t {
 public:
  explicit LimitCheck(int max_keys) : max_keys_(max_keys) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override {
    // Each key of an object is looked for among all before it.
    const int limit = std::min(max_keys_, kMaxJsonKeys);
    if (++num_keys_ > max_keys_ || ++keys_of_object_[depth_] > limit) {
      throw std::invalid_argument("this JSON has more than " +
                                  std::to_string(num_keys_ > max_keys_ ? max_keys_ : limit) +
                                  " keys");
    }
    return true;
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
    if (++depth_ > kMaxDepth) {
      throw std::invalid_argument("this JSON is nested deeper than 32 levels");
    }
    keys_of_object_[depth_] = 0;
    return true;
  }
  bool End() {
    --depth_;
    return true;
  }

  static constexpr int kMaxDepth = 32;

  int max_keys_;
  int depth_ = 0;
  int num_keys_ = 0;
  std::array<int, kMaxDepth + 1> keys_of_object_{};
};

}  // namespace

Json ParseJson(std::string_view text, int max_keys) {
  LimitCheck limits(max_keys);
  Json::sax_parse(text, &limits);
  return Json::parse(text);
}

std::string ToText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace smile

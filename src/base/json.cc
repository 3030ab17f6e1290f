// Two passes over untrusted text: the first checks limits, the second builds the value. The library
// itself has limits for neither depth nor keys.

#include "base/json.h"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/wording.h"

namespace smile {
namespace {

/// Checks limits from the parser's events without keeping values. (A callback of the parser that
/// keeps them searches the whole enclosing array whenever a value in it ends: hours, for ten
/// megabytes.)
class LimitCheck : public Json::json_sax_t {
 public:
  LimitCheck(std::string_view text, int max_keys) : text_(text), max_keys_(max_keys) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t& name) override {
    // Each key of an object is compared to all before it, so the number of keys per object is
    // limited.
    // A key that occurs twice is refused, since readers disagree about which value counts.
    const int limit = std::min(max_keys_, kMaxJsonKeys);
    Keys& keys = keys_of_object_[depth_];
    if (++num_keys_ > max_keys_ || ++keys.count > limit) {
      throw std::invalid_argument("this JSON has more than " +
                                  std::to_string(num_keys_ > max_keys_ ? max_keys_ : limit) +
                                  " keys");
    }
    keys.last = name;
    if (!keys.names.insert(std::move(name)).second) {
      throw std::invalid_argument("the key " + Quoted(keys.last) + " appears twice" + Where());
    }
    return true;
  }
  bool start_object(std::size_t) override { return Begin(); }
  bool start_array(std::size_t) override { return Begin(); }
  bool end_object() override { return End(); }
  bool end_array() override { return End(); }
  bool parse_error(std::size_t position, const std::string&, const Json::exception&) override {
    // The library reports bytes; people look for lines.
    const std::string_view before = text_.substr(0, position);
    const auto num_ends = std::count(before.begin(), before.end(), '\n');
    throw std::invalid_argument(
        "this is not JSON" +
        (num_ends > 0 ? " from line " + std::to_string(num_ends + 1) + " on" : std::string()));
  }

 private:
  bool Begin() {
    if (++depth_ > kMaxDepth) {
      throw std::invalid_argument("this JSON is nested deeper than 32 levels");
    }
    // Arrays have an entry, too; it has no keys.
    keys_of_object_[depth_] = {};
    return true;
  }
  bool End() {
    --depth_;
    return true;
  }

  /// Returns ` in "arms"`: the nearest key around this object.
  std::string Where() const {
    for (int around = depth_ - 1; around > 0; --around) {
      // Levels of arrays are skipped.
      if (keys_of_object_[around].count > 0) return " in " + Quoted(keys_of_object_[around].last);
    }
    return {};
  }

  static constexpr int kMaxDepth = 32;

  struct Keys {  // of an object that has not ended
    int count = 0;
    std::set<std::string> names;
    std::string last;
  };

  std::string_view text_;
  int max_keys_;
  int depth_ = 0;
  int num_keys_ = 0;
  std::array<Keys, kMaxDepth + 1> keys_of_object_;
};

}  // namespace

Json ParseJson(std::string_view text, int max_keys) {
  LimitCheck limits(text, max_keys);
  // The second pass builds the value. It cannot fail, as it reads the same text.
  Json::sax_parse(text, &limits);
  return Json::parse(text);
}

std::string ToText(const Json& json, int indent) {
  // Bytes that are not UTF-8 are replaced, as exceptions would prevent any message about them.
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace smile

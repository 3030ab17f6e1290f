#include "scene_xml/internal_expression.h"

#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include "base/wording.h"
#include "scene_xml/internal_letters.h"

// Expressions of the original program, including its single precision and Java's syntax and output
// of numbers: coordinates of old scenes must come out with the same digits. Text comes from files,
// so depth and length are bounded.

namespace smile::scene_xml {
namespace {

constexpr int kMaxParentheses = 64;  // inside one another
constexpr std::size_t kMaxOperandBytes = 100;

bool IsGap(char letter) { return letter == ' ' || letter == '\t'; }
bool IsTokenLetter(char letter) { return IsIdLetter(letter) || letter == '.'; }
bool IsOneOf(char letter, std::string_view letters) {
  return letters.find(letter) != std::string_view::npos;
}

std::string_view WithoutGaps(std::string_view text) {
  while (!text.empty() && IsGap(text.front())) text.remove_prefix(1);
  while (!text.empty() && IsGap(text.back())) text.remove_suffix(1);
  return text;
}

/// Parses digits with optional point and exponent to the nearest float. from_chars() reports
/// overflow and underflow alike; these become infinity and zero.
std::optional<float> ParseDecimal(std::string_view text) {
  // std::from_chars also reads signs, `inf` and `nan`, which are not decimals here.
  if (text.empty() || !(IsDigit(text[0]) || text[0] == '.')) return std::nullopt;
  // The wider type distinguishes too large from too small; its value is not used otherwise.
  long double wide = 0;
  float number = 0;
  const char* const end = text.data() + text.size();
  const auto [narrow_end, narrow_error] = std::from_chars(text.data(), end, number);
  if (narrow_error == std::errc()) {
    return narrow_end == end ? std::optional(number) : std::nullopt;
  }
  const auto [wide_end, wide_error] = std::from_chars(text.data(), end, wide);
  if (wide_error != std::errc() || wide_end != end) return std::nullopt;
  // Beyond the range of float: larger than 1 means too large, anything else too small.
  return wide > 1 ? std::numeric_limits<float>::infinity() : 0.0f;
}

/// Parses a number without sign, as the original program (Java) does: `2`, `.5`, `5.`, `1e-3`,
/// `2d`, `Infinity`.
std::optional<float> ParseUnsigned(std::string_view text) {
  if (text.size() > kMaxOperandBytes) return std::nullopt;
  if (text == "NaN") return std::numeric_limits<float>::quiet_NaN();
  if (text == "Infinity") return std::numeric_limits<float>::infinity();
  // Java's suffixes of types; the value is single precision anyway.
  if (!text.empty() && IsOneOf(text.back(), "dDfF")) text.remove_suffix(1);
  return ParseDecimal(text);
}

/// Parses the value of a variable in arithmetic, with optional sign and blanks.
std::optional<float> ParseValue(std::string_view text) {
  text = WithoutGaps(text);
  const bool is_negative = !text.empty() && text[0] == '-';
  if (!text.empty() && IsOneOf(text[0], "+-")) text.remove_prefix(1);
  const std::optional<float> size = ParseUnsigned(text);
  return size && is_negative ? -*size : size;
}

/// Recursive-descent evaluator of the grammar in the header: one function per rule, without
/// building a tree. After the first fault, functions return without effect.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, Variables* variables)
      : text_(text), variables_(*variables) {}

  /// Returns the value as text; meaningless after a fault.
  std::string Read() {
    if (const std::string* value = ValueOfLoneName()) return *value;
    if (has_fault_) return {};
    const float number = Expression();
    SkipBlanks();
    if (!text_.empty()) Fail(Quoted(text_) + " after a value", "an operator + - * /");
    return has_fault_ ? std::string() : SinglePrecisionText(number);
  }

  bool has_fault() const { return has_fault_; }
  const std::string& fault() const { return fault_; }

 private:
  /// Returns the value of an expression that is a single name, which need not be a number; nullptr
  /// for all other expressions and after a fault.
  const std::string* ValueOfLoneName() {
    const std::string_view name = WithoutGaps(text_);
    for (char letter : name) {
      if (!IsTokenLetter(letter)) return nullptr;
    }
    // A number is arithmetic, so that it is written in the original's form: `$1e3$` is 1000.
    if (name.empty() || ParseUnsigned(name)) return nullptr;
    return Find(name);
  }

  /// Returns the value of a variable; nullptr, with a fault, if it is missing or faulty.
  const std::string* Find(std::string_view name) {
    const Variables::Binding binding = variables_.Find(name);
    if (binding.is_faulty) {
      has_fault_ = true;
      return nullptr;
    }
    if (!binding.value) {
      Fail("the unknown variable " + Quoted(name),
           "one of the instance, of its def or of an instance around it" +
               DidYouMean(name, variables_.SomeNames()));
    }
    return binding.value;
  }

  float Expression() {
    float sum = Term();
    // accepted_ is read before the operand is parsed, which overwrites it.
    while (Accept("+-")) sum = accepted_ == '+' ? sum + Term() : sum - Term();
    return sum;
  }

  float Term() {
    float product = Factor();
    while (Accept("*/")) product = accepted_ == '*' ? product * Factor() : product / Factor();
    return product;
  }

  // A sign binds tighter than * and /, and no blank may follow it.
  float Factor() {
    SkipBlanks();
    const bool is_negative = !text_.empty() && text_[0] == '-';
    if (!text_.empty() && IsOneOf(text_[0], "+-")) text_.remove_prefix(1);
    const float size = !text_.empty() && text_[0] == '(' ? Parenthesis() : Token();
    return is_negative ? -size : size;
  }

  float Parenthesis() {
    if (++num_parentheses_ > kMaxParentheses) {
      Fail("more than " + std::to_string(kMaxParentheses) + " parentheses inside one another",
           "fewer");
      return 0;
    }
    text_.remove_prefix(1);
    const float value = Expression();
    if (!Accept(")")) Fail(WhatFollows(), "an operator + - * / or )");
    --num_parentheses_;
    return value;
  }

  float Token() {
    const std::string_view token = TakeToken();
    if (token.empty()) {
      Fail(WhatFollows(), "a number, a variable or (");
      return 0;
    }
    if (const std::optional<float> number = ParseUnsigned(token)) return *number;
    // Not after a fault: Find() evaluates variables, with findings of their own.
    const std::string* value = has_fault_ ? nullptr : Find(token);
    if (!value) return 0;
    const std::optional<float> number = ParseValue(*value);
    if (!number) Fail(std::string(token) + "=" + Quoted(*value) + " in arithmetic", "a number");
    return number.value_or(0);
  }

  /// Removes and returns the longest token. A sign inside a number is possible only behind an
  /// exponent's e.
  std::string_view TakeToken() {
    std::size_t size = 0;
    while (size < text_.size() && IsTokenLetter(text_[size])) ++size;
    // The sign of an exponent: `1e-3`.
    // The letters before the e must be a number: in `size-1` the minus is an operator.
    const bool ends_in_e = size > 1 && IsOneOf(text_[size - 1], "eE") &&
                           ParseDecimal(text_.substr(0, size - 1)).has_value();
    if (ends_in_e && size + 1 < text_.size() && IsOneOf(text_[size], "+-") &&
        IsDigit(text_[size + 1])) {
      for (++size; size < text_.size() && IsTokenLetter(text_[size]);) ++size;
    }
    const std::string_view token = text_.substr(0, size);
    text_.remove_prefix(size);
    return token;
  }

  /// Removes the next letter, after blanks, if it is one of these; remembers it in accepted_.
  bool Accept(std::string_view letters) {
    SkipBlanks();
    if (has_fault_ || text_.empty() || !IsOneOf(text_[0], letters)) return false;
    accepted_ = text_[0];
    text_.remove_prefix(1);
    return true;
  }

  void SkipBlanks() {
    while (!text_.empty() && IsGap(text_[0])) text_.remove_prefix(1);
  }

  std::string WhatFollows() const { return text_.empty() ? "the end" : Quoted(text_); }

  void Fail(const std::string& found, const std::string& expected) {
    if (has_fault_) return;
    has_fault_ = true;
    fault_ = "with " + found + ", expected " + expected;
  }

  std::string_view text_;  // what is left of it
  Variables& variables_;
  char accepted_ = 0;
  int num_parentheses_ = 0;
  bool has_fault_ = false;
  std::string fault_;
};

struct Group {
  std::size_t begin, end;  // of the two $
};

/// Returns the next pair of $ on one line, at or after `from`. A $ whose partner is on another line
/// stays literal.
std::optional<Group> FindGroup(std::string_view text, std::size_t from) {
  std::size_t begin = text.find('$', from);
  while (begin != std::string_view::npos) {
    const std::size_t end = text.find_first_of("$\r\n", begin + 1);
    if (end == std::string_view::npos) return std::nullopt;
    if (text[end] == '$') return Group{begin, end};
    // The line ended first: the search continues on the next one.
    begin = text.find('$', end);
  }
  return std::nullopt;
}

Substitution Faulty(std::string_view text, std::string fault) {
  return {std::string(text), true, std::move(fault)};
}

}  // namespace

bool HoldsExpression(std::string_view text) { return FindGroup(text, 0).has_value(); }

Substitution Substitute(std::string_view text, std::size_t max_bytes, Variables* variables) {
  std::string result;
  std::size_t from = 0;
  while (const std::optional<Group> group = FindGroup(text, from)) {
    ExpressionReader reader(text.substr(group->begin + 1, group->end - group->begin - 1),
                            variables);
    const std::string value = reader.Read();
    if (reader.has_fault()) return Faulty(text, reader.fault());
    result += text.substr(from, group->begin - from);
    result += value;
    from = group->end + 1;
    // Checked within the loop, so that many short expressions cannot make a huge text first.
    if (result.size() > max_bytes) break;
  }
  result += text.substr(from);
  if (result.size() > max_bytes) {
    return Faulty(text, "with a text that exceeds the limits of a scene, expected less");
  }
  // Values are not expanded again; a result that contains an expression would mean something else
  // when the scene is written and read again.
  if (HoldsExpression(result)) {
    return Faulty(
        text, "with $ in the value of a variable, expected no nested " + std::string("expression"));
  }
  return {std::move(result)};
}

}  // namespace smile::scene_xml

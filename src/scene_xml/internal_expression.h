#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smile::scene_xml {

/// Variables visible to an expression.
class Variables {
 public:
  virtual ~Variables() = default;

  struct Binding {
    const std::string* value = nullptr;  ///< nullptr if the variable does not exist
    bool is_faulty = false;              ///< it exists, but its value is faulty
  };
  virtual Binding Find(std::string_view name) = 0;
  /// Returns some of the names, for spelling suggestions.
  virtual std::vector<std::string_view> SomeNames() const = 0;
};

/// Result of a substitution: a text with values in place of expressions.
struct Substitution {
  std::string text;        ///< unchanged after a fault
  bool has_fault = false;  ///< then nothing was substituted
  std::string fault;  ///< `with …, expected …`; empty if the fault of a variable is the cause
};

/// True if the text contains `$…$` within one line. A single `$` is literal.
bool HoldsExpression(std::string_view text);

/// Replaces the expressions `$…$` of a text by their values.
///
/// A single name stands for its value, whatever that is: a color, a location, the id 007. All other
/// expressions are arithmetic in single precision, as in the original program:
///
///     expression = term { (+|-) term }
///     term       = factor { (*|/) factor }
///     factor     = [+|-] ( "(" expression ")" | number | name )
///
/// with blanks before factors and around operators, but not behind a sign. The value of a name must
/// then be a number. SinglePrecisionText() writes the result.
///
/// @param max_bytes  more text than this is a fault.
Substitution Substitute(std::string_view text, std::size_t max_bytes, Variables* variables);

/// Returns the text of an arithmetic result, as the original program writes it: `2` for values
/// within 1e-6 of a 32-bit integer, else `0.33333334`, `1.0E-4`, `1.23456778E10`, `Infinity`,
/// `NaN`.
std::string SinglePrecisionText(float number);

}  // namespace smile::scene_xml

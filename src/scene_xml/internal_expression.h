#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smile::scene_xml {

/// The variables an expression can see.
class Variables {
 public:
  virtual ~Variables() = default;

  struct Binding {
    const std::string* value = nullptr;  ///< nullptr when there is no such variable
    bool is_faulty = false;              ///< there is one, but its value has a fault of its own
  };
  virtual Binding Find(std::string_view name) = 0;
  /// Some of the names, for a suggestion.
  virtual std::vector<std::string_view> SomeNames() const = 0;
};

/// A text with values in the place of its expressions.
struct Substitution {
  std::string text;        ///< as it was when there is a fault
  bool has_fault = false;  ///< then nothing was put in
  std::string fault;       ///< `with …, expected …`; empty when a variable is to blame
};

/// Whether the text holds `$…$` within one line. A `$` without another is only itself.
bool HoldsExpression(std::string_view text);

/// Puts values in the place of the expressions `$…$` of a text.
///
/// A name alone stands for its value, whatever that is: a color, a location, the id 007. All else
/// is arithmetic in single precision, the language of the original program:
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

/// How the result of arithmetic is written, as the original does: `2` for what is within 1e-6 of an
/// integer of 32 bits, else `0.33333334`, `1.0E-4`, `1.23456778E10`, `Infinity`, `NaN`.
std::string SinglePrecisionText(float number);

}  // namespace smile::scene_xml

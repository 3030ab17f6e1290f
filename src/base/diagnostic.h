#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace smile {

/// Finding about untrusted input (a scene, a script, a log), with its place.
struct Diagnostic {
  std::string file;     ///< as named by the user
  int line = 0;         ///< 1 is the first line; 0: the whole file
  std::string element;  ///< for example `block id="B3"`; empty: not about one element
  std::string message;  ///< what was found, what was expected

  bool operator==(const Diagnostic&) const = default;
};

/// Returns `scenes/um.xml:14: <block id="B3">: mass is -1, expected at least 0`.
std::string ToString(const Diagnostic& diagnostic);

/// Error: invalid input, with all findings. The program ends with exit code 1.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  /// Makes an error of a single finding.
  explicit InputError(Diagnostic diagnostic);

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace smile

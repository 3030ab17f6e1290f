#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace smile {

/// One finding about untrusted input (a scene, a script, a log), with its address.
struct Diagnostic {
  std::string file;     ///< as the user named it
  int line = 0;         ///< 1 is the first line; 0 when the whole file is meant
  std::string element;  ///< for example `block id="B3"`; empty when not about one element
  std::string message;  ///< what was found, what was expected

  bool operator==(const Diagnostic&) const = default;
};

/// `scenes/um.xml:14: <block id="B3">: mass is -1, expected at least 0`.
std::string ToString(const Diagnostic& diagnostic);

/// Input from outside was wrong; carries every finding. The program answers with exit code 1.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  /// For a single finding.
  explicit InputError(Diagnostic diagnostic);

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace smile

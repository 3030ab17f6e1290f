#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/internal_expansion_budget.h"
#include "scene_xml/internal_expression.h"
#include "scene_xml/internal_sources.h"

namespace smile::scene_xml {

/// A `var` as written.
struct VariableText {
  std::string name, value;
  bool is_derived = false;
  SourceLocation place;
};

/// Variables inside one instance of a template, with access to those around it.
///
/// If both instance and template define a name, the value of the instance counts; either hides that
/// of the enclosing scope. Values of the instance are evaluated in the enclosing scope, unless they
/// are derived. Derived ones, and those of the template, see one another and are evaluated in order
/// of dependence. A value that refers to its own name means the variable of the enclosing scope.
class Scope final : public Variables {
 public:
  /// Scope of the whole scene, without variables.
  Scope(ExpansionBudget* budget, Findings* findings) : budget_(*budget), findings_(*findings) {}

  /// Scope of an instance; evaluates all values, with faults as findings.
  Scope(Scope* enclosing, const std::vector<VariableText>& of_instance,
        const std::vector<VariableText>& of_template, ExpansionBudget* budget, Findings* findings);

  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  Binding Find(std::string_view name) override;
  std::vector<std::string_view> SomeNames() const override;

 private:
  enum class State { kText, kInWork, kDone, kFaulty };
  struct Variable {
    std::string value;
    SourceLocation place;
    State state = State::kText;
  };
  using NamedVariable = std::map<std::string, Variable, std::less<>>::value_type;

  /// @param variables  variables that the value may refer to.
  void Evaluate(NamedVariable* named, Variables* variables);
  void EvaluateInOrder(NamedVariable* variable);
  void Fail(NamedVariable* variable, const std::string& message);
  Binding FindAround(std::string_view name);

  Scope* enclosing_ = nullptr;
  ExpansionBudget& budget_;
  Findings& findings_;
  std::map<std::string, Variable, std::less<>> variables_;
  std::vector<NamedVariable*> in_work_;  // each needs the next
};

}  // namespace smile::scene_xml

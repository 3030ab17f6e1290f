#include "scene_xml/internal_scope.h"

#include <algorithm>
#include <utility>

#include "base/wording.h"

// Variables are texts. Each is evaluated once, when the scope is made, so that faults are reported
// where the variable is set and not wherever it is used.

namespace smile::scene_xml {
namespace {

// Depth of the recursion through variables that need one another.
constexpr std::size_t kMaxInWork = 64;
constexpr std::size_t kMaxSuggestedVariables = 100;

}  // namespace

Scope::Scope(Scope* enclosing, const std::vector<VariableText>& of_instance,
             const std::vector<VariableText>& of_template, ExpansionBudget* budget,
             Findings* findings)
    : enclosing_(enclosing), budget_(*budget), findings_(*findings) {
  for (const VariableText& text : of_instance) {
    NamedVariable& variable =
        *variables_.insert_or_assign(text.name, Variable{text.value, text.place}).first;
    // Values from outside are evaluated in the scope around the instance, before any of this scope
    // is visible.
    if (!text.is_derived) Evaluate(&variable, enclosing);
  }
  // Backwards, so that the later of two variables with the same name wins. try_emplace() keeps
  // values of the instance.
  for (auto text = of_template.rbegin(); text != of_template.rend(); ++text) {
    variables_.try_emplace(text->name, Variable{text->value, text->place});
  }
  // In the order of the file, where variables usually follow those they need; this keeps the
  // recursion shallow.
  for (const std::vector<VariableText>* texts : {&of_template, &of_instance}) {
    for (const VariableText& text : *texts) {
      NamedVariable& variable = *variables_.find(text.name);
      if (variable.second.state == State::kText) EvaluateInOrder(&variable);
    }
  }
}

Variables::Binding Scope::Find(std::string_view name) {
  const auto found = variables_.find(name);
  // Scopes are lexical: what this one does not have, the scope around the instance may have.
  if (found == variables_.end()) return FindAround(name);
  NamedVariable& variable = *found;
  if (variable.second.state == State::kInWork) {
    // A value that refers to its own name means the variable around; a longer cycle is a fault.
    if (in_work_.back() == &variable) return FindAround(name);
    std::string circle;
    for (auto it = std::find(in_work_.begin(), in_work_.end(), &variable); it != in_work_.end();
         ++it) {
      circle += (*it)->first + ", ";
    }
    Fail(&variable, "found variables that depend on each other in a cycle (" + circle +
                        variable.first + "), expected one of them to have a value of its own");
  }
  if (variable.second.state == State::kText) EvaluateInOrder(&variable);
  if (variable.second.state == State::kDone) return {.value = &variable.second.value};
  return {.is_faulty = true};
}

Variables::Binding Scope::FindAround(std::string_view name) {
  return enclosing_ ? enclosing_->Find(name) : Binding{};
}

std::vector<std::string_view> Scope::SomeNames() const {
  std::vector<std::string_view> names;
  for (const Scope* scope = this; scope; scope = scope->enclosing_) {
    for (const NamedVariable& variable : scope->variables_) {
      if (names.size() < kMaxSuggestedVariables) names.push_back(variable.first);
    }
  }
  return names;
}

/// Depth-first evaluation: Find() evaluates the variables that this one needs. in_work_ is the
/// chain of those that wait.
void Scope::EvaluateInOrder(NamedVariable* variable) {
  if (in_work_.size() >= kMaxInWork) {
    return Fail(variable, "found more than " + std::to_string(kMaxInWork) +
                              " variables that depend on one another, expected fewer");
  }
  in_work_.push_back(variable);
  variable->second.state = State::kInWork;
  Evaluate(variable, this);
  in_work_.pop_back();
}

void Scope::Evaluate(NamedVariable* named, Variables* variables) {
  Variable& variable = named->second;
  if (budget_.is_spent()) {
    variable.state = State::kFaulty;
    return;
  }
  // May call Find() of this scope, and so evaluate others first, or find the cycle.
  Substitution result = Substitute(variable.value, budget_.bytes_left(), variables);
  if (variable.state == State::kFaulty) return;  // a circle, closed while it was in work
  if (result.has_fault) {
    if (result.fault.empty()) {
      variable.state = State::kFaulty;
    } else {
      Fail(named, "found value=" + Quoted(variable.value) + " " + result.fault);
    }
    return;
  }
  variable.value = std::move(result.text);
  variable.state =
      budget_.Spend(0, variable.value.size(), variable.place) ? State::kDone : State::kFaulty;
}

void Scope::Fail(NamedVariable* variable, const std::string& message) {
  variable->second.state = State::kFaulty;
  findings_.Add(variable->second.place, "var name=" + Quoted(variable->first), message);
}

}  // namespace smile::scene_xml

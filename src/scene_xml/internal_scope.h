#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene_xml/internal_expansion_budget.h"
#include "scene_xml/internal_expression.h"
#include "scene_xml/internal_place.h"

namespace smile::scene_xml {

/// A `var` as it is written.
struct VariableText {
  std::string name, value;
  bool is_derived = false;
  Place place;
};

/// The variables inside one instance of a template, and through them those around it.
///
/// Where both give a name, the instance's value counts, not the template's; and both hide that of
/// the scope around. The instance speaks from outside: its values are evaluated in the scope around
/// it, unless they are derived. Derived ones, and those of the template, see one another and are
/// evaluated in the order in which they need each other. A value that names itself means the
/// variable around.
class Scope final : public Variables {
 public:
  /// The scope of the whole scene: there are no variables in it.
  Scope(ExpansionBudget* budget, Findings* findings) : budget_(*budget), findings_(*findings) {}

  /// The scope of an instance; all values are evaluated, their faults are findings.
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
    Place place;
    State state = State::kText;
  };
  using Entry = std::map<std::string, Variable, std::less<>>::value_type;

  /// @param variables  what the value may refer to.
  void Evaluate(Entry* entry, Variables* variables);
  void EvaluateInOrder(Entry* entry);
  void Fail(Entry* entry, const std::string& message);
  Binding FindAround(std::string_view name);

  Scope* enclosing_ = nullptr;
  ExpansionBudget& budget_;
  Findings& findings_;
  std::map<std::string, Variable, std::less<>> variables_;
  std::vector<Entry*> in_work_;  // each needs the next
};

}  // namespace smile::scene_xml

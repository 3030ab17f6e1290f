#include "scene_xml/internal_expansion.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/wording.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_expansion_budget.h"
#include "scene_xml/internal_scope.h"

// Templates as in the original program: `def` defines content, `instance` inserts a copy of it,
// `var` sets values for expressions in it. The result is a tree as if an author had written it by
// hand, with the place of each element in its template and the instance it came from.

namespace smile::scene_xml {
namespace {

// Spelling suggestions compare with each name.
constexpr std::size_t kMaxSuggestedTemplates = 100;

struct Template {
  std::vector<VariableText> defaults;
  std::vector<SceneElement> content;
  SourceLocation place;
  // Cost of one instance.
  int num_elements = 0;
  std::size_t num_bytes = 0;
};

using Templates = std::map<std::string, Template, std::less<>>;

/// Context of an element that is being expanded.
struct ExpansionContext {
  Scope* scope;
  int expansion;  // of Sources
  int depth;      // of the parent element, the root being 1
};

/// Adds the elements and bytes of an element and everything in it.
void AddCost(const SceneElement& element, Template* target) {
  ++target->num_elements;
  for (const SceneAttribute& attribute : element.attributes) {
    target->num_bytes += attribute.name.size() + attribute.value.size();
  }
  // Instances inside count as one element here and pay for their own content when they are
  // expanded.
  for (const SceneElement& child : element.children) AddCost(child, target);
}

VariableText ReadVariable(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  // One by one: the order of findings is that of these lines.
  VariableText variable{.place = element.place};
  variable.name = attributes.RequiredName("name");
  variable.value = attributes.RequiredText("value");
  variable.is_derived = attributes.Boolean("derived", false);
  attributes.RefuseUnknown();
  for (const SceneElement& child : element.children) RefuseElement(child, {}, reading);
  return variable;
}

/// Moves a `def` into the templates. Its content is not expanded here, but for each instance.
void ReadTemplate(SceneElement def, ReadingContext* reading, Templates* templates) {
  AttributeReader attributes(def, reading);
  const std::string name = attributes.RequiredName("name");
  attributes.RefuseUnknown();
  Template result{.place = def.place};
  for (SceneElement& child : def.children) {
    // Variables count, too: they are copied and evaluated for each instance.
    AddCost(child, &result);
    if (child.Is("var")) {
      result.defaults.push_back(ReadVariable(child, reading));
    } else {
      result.content.push_back(std::move(child));
    }
  }
  const auto [entry, is_new] = templates->try_emplace(name, std::move(result));
  // The first template of a name stays; the second one is a finding.
  if (is_new || name.empty()) return;
  const std::string first = reading->findings->sources().Address(entry->second.place);
  reading->findings->Add(def.place, AddressOf(def),
                         "found a second def of this name, expected one; the first is at " + first);
}

/// Removes the templates from the root and returns them. They may be defined after their use.
Templates TakeTemplates(SceneElement* root, ReadingContext* reading) {
  Templates templates;
  std::vector<SceneElement> content;
  for (SceneElement& child : root->children) {
    if (child.Is("def")) {
      ReadTemplate(std::move(child), reading, &templates);
    } else {
      content.push_back(std::move(child));
    }
  }
  root->children = std::move(content);
  return templates;
}

/// Expands instances by recursive descent with lexical scopes of variables. Three limits keep the
/// work finite: depth of elements, nesting of instances and the budget of elements and bytes,
/// without which 60 levels of doubling would make 2^60 elements.
class Expander {
 public:
  Expander(const SceneLimits& limits, bool has_all_files, Templates templates,
           ReadingContext* reading)
      : limits_(limits),
        has_all_files_(has_all_files),
        templates_(std::move(templates)),
        reading_(*reading),
        budget_(limits, reading->findings) {}

  void Expand(SceneElement* root) {
    Scope scope(&budget_, reading_.findings);
    root->children = Expanded(std::move(root->children), {&scope, /*expansion=*/-1, /*depth=*/1});
  }

 private:
  std::vector<SceneElement> Expanded(std::vector<SceneElement> content,
                                     const ExpansionContext& context) {
    std::vector<SceneElement> result;
    ExpandInto(&result, std::move(content), context);
    return result;
  }

  /// Appends the expanded content to `target`. Instances are replaced by their content, so no level
  /// of nesting is added for them.
  void ExpandInto(std::vector<SceneElement>* target, std::vector<SceneElement> content,
                  const ExpansionContext& context) {
    for (SceneElement& element : content) {
      if (budget_.is_spent()) return;
      element.place.expansion = context.expansion;
      if (element.Is("instance")) {
        ExpandInstance(std::move(element), context, target);
      } else if (!IsMisplaced(element)) {
        ExpandElement(std::move(element), context, target);
      }
    }
  }

  void ExpandElement(SceneElement element, const ExpansionContext& context,
                     std::vector<SceneElement>* target) {
    // The parser has checked the depth of each file, but instances nest templates in one another.
    if (context.depth >= limits_.max_depth) {
      return Fail(element, "found more than " + std::to_string(limits_.max_depth) +
                               " elements inside one another, expected fewer");
    }
    SubstituteAttributes(&element, context.scope);
    element.children = Expanded(std::move(element.children),
                                {context.scope, context.expansion, context.depth + 1});
    target->push_back(std::move(element));
  }

  void ExpandInstance(SceneElement instance, const ExpansionContext& context,
                      std::vector<SceneElement>* target) {
    // The name of the template and its variables may be expressions as well, in the scope around
    // the instance.
    SubstituteAttributes(&instance, context.scope);
    AttributeReader attributes(instance, &reading_);
    const std::string name = attributes.RequiredName("def");
    attributes.RefuseUnknown();
    const std::vector<VariableText> variables = ReadVariables(&instance, context);
    if (attributes.has_findings()) return;
    const auto found = templates_.find(name);
    if (found == templates_.end()) return RefuseName(instance, name);
    // Before the budget, whose exhaustion would hide the cause of a cycle.
    if (!CanOpen(instance, name)) return;

    const Template& used = found->second;
    // Paid before the content is copied.
    if (!budget_.Spend(1 + used.num_elements, used.num_bytes, instance.place)) return;
    const int expansion = reading_.findings->sources().AddExpansion(instance.place);
    // Findings in the template then name the instance that was expanded.
    std::vector<VariableText> defaults = used.defaults;
    for (VariableText& variable : defaults) variable.place.expansion = expansion;
    Scope scope(context.scope, variables, defaults, &budget_, reading_.findings);
    open_.push_back(name);
    // A copy of the content: the template is needed again.
    ExpandInto(target, used.content, {&scope, expansion, context.depth});
    open_.pop_back();
  }

  std::vector<VariableText> ReadVariables(SceneElement* instance, const ExpansionContext& context) {
    std::vector<VariableText> variables;
    for (SceneElement& child : instance->children) {
      child.place.expansion = context.expansion;
      if (child.Is("var")) {
        variables.push_back(ReadVariable(child, &reading_));
      } else if (CheckNamespace(child, &reading_)) {
        RefuseElement(child, std::array<std::string_view, 1>{"var"}, &reading_);
      }
    }
    return variables;
  }

  /// Returns true if a template may be used inside those that are open: not within itself, and not
  /// too deep.
  bool CanOpen(const SceneElement& instance, const std::string& name) {
    const auto outer = std::find(open_.begin(), open_.end(), name);
    if (outer != open_.end()) {
      std::string circle;
      for (auto it = outer; it != open_.end(); ++it) circle += *it + ", ";
      Fail(instance, "found templates that contain each other in a cycle (" + circle + name +
                         "), expected an end");
      return false;
    }
    if (static_cast<int>(open_.size()) >= limits_.max_instances) {
      Fail(instance, "found more than " + std::to_string(limits_.max_instances) +
                         " instances inside one another, expected fewer");
      return false;
    }
    return true;
  }

  void RefuseName(const SceneElement& instance, const std::string& name) {
    // The template may be in the file that is missing, which is a finding already.
    if (!has_all_files_ || reading_.findings->is_full()) return;
    std::vector<std::string_view> names;
    for (const auto& [known, unused] : templates_) {
      if (names.size() < kMaxSuggestedTemplates) names.push_back(known);
    }
    Fail(instance, "found def=" + Quoted(name) + ", expected the name of a def in this scene" +
                       DidYouMean(name, names));
  }

  /// True, with a finding, for elements of the template language in the wrong place.
  bool IsMisplaced(const SceneElement& element) {
    if (element.Is("include") || element.Is("def")) {
      Fail(element, "found this element here, expected it directly in <tabletop>");
      return true;
    }
    if (element.Is("var")) {
      Fail(element, "found this element here, expected it directly in a def or an instance");
      return true;
    }
    return false;
  }

  void SubstituteAttributes(SceneElement* element, Scope* scope) {
    for (SceneAttribute& attribute : element->attributes) {
      if (budget_.is_spent()) return;
      if (!HoldsExpression(attribute.value)) continue;
      Substitution result = Substitute(attribute.value, budget_.bytes_left(), scope);
      // An empty fault means that the variable was reported already.
      attribute.is_faulty = result.has_fault;
      if (!result.has_fault) {
        // Values can grow at each level, as a variable may contain another one twice.
        budget_.Spend(0, result.text.size(), element->place);
        attribute.value = std::move(result.text);
      } else if (!result.fault.empty()) {
        Fail(*element,
             "found " + attribute.name + "=" + Quoted(attribute.value) + " " + result.fault);
      }
    }
  }

  void Fail(const SceneElement& element, const std::string& message) {
    reading_.findings->Add(element.place, AddressOf(element), message);
  }

  const SceneLimits& limits_;
  bool has_all_files_;
  Templates templates_;
  ReadingContext& reading_;
  ExpansionBudget budget_;
  std::vector<std::string> open_;  // the templates being expanded, from the outside inwards
};

}  // namespace

void ExpandTemplates(const SceneLimits& limits, bool has_all_files, SceneElement* root,
                     ReadingContext* reading) {
  Templates templates = TakeTemplates(root, reading);
  Expander(limits, has_all_files, std::move(templates), reading).Expand(root);
}

}  // namespace smile::scene_xml

#include "sim/command_documents.h"

#include <cctype>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/add.h"
#include "sim/drag.h"
#include "sim/internal_command_fields.h"

namespace smile::sim {
namespace {

/// Description of a kind of command.
struct CommandForm {
  CommandName about;
  std::vector<CommandField> fields;
};

/// Returns all kinds in the order of Command, then the queries that are written like commands.
std::vector<CommandForm> FormsOfCommands() {
  std::vector<CommandForm> forms;
  AnyKindOfCommand([&]<class What>(std::type_identity<What>) {
    forms.push_back({What::kName, FieldsOf<What>()});
    return false;
  });
  forms.push_back({Drag::kName, FieldsOf<Drag>()});
  forms.push_back({Add::kName, FieldsOf<Add>()});
  return forms;
}

bool IsRequired(const CommandField& field) { return field.presence == Presence::kRequired; }

/// Returns the JSON Schema of one kind.
Json SchemaOf(const CommandForm& form) {
  Json properties = {
      {"do", {{"const", form.about.name}}},
      {"tick",
       {{"type", "integer"},
        {"minimum", 0},
        {"description", "when it is applied, in ticks of 1/60 s; scripts may leave it out"}}}};
  Json required = {"do"};
  for (const CommandField& field : form.fields) {
    properties[field.name] = ShapeOf(field.kind).Schema();
    properties[field.name]["description"] = MeaningOf(field);
    if (IsRequired(field)) required.push_back(field.name);
  }
  return {{"title", form.about.name},
          {"description", form.about.meaning},
          {"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

/// Returns text escaped for a Markdown table.
std::string InTable(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

/// Returns `MoveToCommand` for `move_to`.
std::string InterfaceName(std::string_view name) {
  std::string text;
  bool is_first = true;
  for (const char letter : name) {
    if (letter != '_') {
      text +=
          is_first ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    }
    is_first = letter == '_';
  }
  return text + "Command";
}

/// Returns the TypeScript interface of one kind.
std::string InterfaceOf(const CommandForm& form) {
  std::string text = "/** It " + std::string(form.about.meaning) + ". */\nexport interface " +
                     InterfaceName(form.about.name) + " {\n  do: \"" + form.about.name + "\";\n";
  for (const CommandField& field : form.fields) {
    text += "  /** " + MeaningOf(field) + " */\n  " + field.name + (IsRequired(field) ? "" : "?") +
            ": " + ShapeOf(field.kind).TypeScript() + ";\n";
  }
  return text + "}\n";
}

}  // namespace

Json CommandSchema() {
  Json forms = Json::array();
  for (const CommandForm& form : FormsOfCommands()) forms.push_back(SchemaOf(form));
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "SMILE command"},
          {"oneOf", forms}};
}

std::string CommandText() {
  std::string text;
  for (const CommandForm& form : FormsOfCommands()) {
    text += std::string(form.about.name) + ": " + form.about.meaning + "\n";
    for (const CommandField& field : form.fields) {
      text += "  " + std::string(field.name) + (IsRequired(field) ? "" : " (may be left out)") +
              ": " + MeaningOf(field) + "\n";
    }
  }
  return text;
}

std::string CommandMarkdown() {
  std::string text = "| `do` | field | is | means |\n|---|---|---|---|\n";
  for (const CommandForm& form : FormsOfCommands()) {
    text += "| **`" + std::string(form.about.name) + "`** | | | " + InTable(form.about.meaning) +
            " |\n";
    for (const CommandField& field : form.fields) {
      text += "| | `" + std::string(field.name) + (IsRequired(field) ? "`" : "`?") + " | " +
              InTable(WordsOf(field.kind)) + " | " + InTable(MeaningOf(field)) + " |\n";
    }
  }
  return text;
}

std::string CommandTypeScript() {
  std::string text =
      "// Made by tools/generate.py from the program's tables: change src/sim/command.h instead.\n";
  std::string names;
  for (const CommandForm& form : FormsOfCommands()) {
    text += "\n" + InterfaceOf(form);
    names += "\n  | " + InterfaceName(form.about.name);
  }
  return text + "\nexport type Command =" + names + ";\n";
}

}  // namespace smile::sim

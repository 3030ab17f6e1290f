#include "page/protocol_text.h"

#include <vector>

#include "page/internal_shapes.h"
#include "page/page_protocol.h"

namespace smile::page {
namespace {

/// Returns the names of members with their meanings: `` `factor`: 0.1 to 4, `exact`? ``.
std::string NamesIn(const std::vector<JsonMember>& members) {
  std::string text;
  bool has_meaning = false;
  for (const JsonMember& member : members) {
    if (member.name == "t") continue;
    if (!text.empty()) text += has_meaning ? "; " : ", ";
    text += "`" + member.name + (member.is_required ? "`" : "`?");
    has_meaning = !member.meaning.empty();
    if (has_meaning) text += ": " + member.meaning;
  }
  return text;
}

/// Returns a cell of a Markdown table, with the bar on its right.
std::string TableCell(const std::string& text) { return text.empty() ? " |" : " " + text + " |"; }

/// Named type of the page, with its meaning.
struct NamedShape {
  JsonShape shape;
  std::string meaning = "";
};

/// Returns the types that have a name in TypeScript, in the order of their definitions.
std::vector<NamedShape> NamedShapes() {
  return {{HandNameShape()},
          {FaceExpressionShape()},
          {SnapNameShape()},
          {PointShape()},
          {PoseShape(), "x, y, z, then the quaternion x, y, z, w."},
          {VisualShape()},
          {SceneObjectShape()},
          {RobotDescriptionShape()},
          {HandShape()},
          {ActionSummaryShape(),
           "An action; `on` and `into` tell what is beneath what was put or dropped."},
          {SegmentShape()},
          {TimelineShape(), "All times from the start [s]."},
          {LibraryEntryShape()},
          {AllowedShape(), "True, or the reason why not."},
          {DiagnosticShape()},
          {ConsoleLineShape()}};
}

}  // namespace

std::string RequestMarkdown() {
  std::string text = "| `do` | fields | answered with | |\n|---|---|---|---|\n";
  for (const RequestForm& form : RequestForms()) {
    const char* who = !form.is_for_anyone ? "" : form.remark.empty() ? "*anyone*" : "*anyone*; ";
    text += "|" + TableCell("`" + form.name + "`") + TableCell(NamesIn(form.fields)) +
            TableCell(NamesIn(form.answer)) + TableCell(who + form.remark) + "\n";
  }
  return text;
}

std::string UpdateMarkdown() {
  std::string text = "| `t` | fields | |\n|---|---|---|\n";
  for (const UpdateForm& form : UpdateForms()) {
    text += "|" + TableCell("`" + form.name + "`") + TableCell(NamesIn(form.shape.members())) +
            TableCell(form.remark) + "\n";
  }
  return text;
}

std::string ProtocolTypeScript() {
  std::string text =
      "// Made by tools/generate.py from the tables in src/page: change those instead.\n\n"
      "import type { Command } from \"./commands\";\n";
  for (const NamedShape& named : NamedShapes()) {
    text += "\n" + named.shape.TypeScriptDefinition(named.meaning);
  }
  std::string names;
  for (const UpdateForm& form : UpdateForms()) {
    text += "\n" + form.shape.TypeScriptDefinition();
    names += "\n  | " + form.shape.TypeScript();
  }
  // A union, in which TypeScript can tell the messages apart by `t`.
  text += "\n/** Messages that are not replies. */\nexport type Update =" + names + ";\n";
  text +=
      "\n/** What may be asked for, and what is answered beside `ok`. */\n"
      "export interface Requests {\n";
  const auto type_of = [](const std::vector<JsonMember>& members) {
    return members.empty() ? std::string("object") : ObjectShape(members).TypeScript();
  };
  for (const RequestForm& form : RequestForms()) {
    text += "  " + form.name + ": { fields: " + type_of(form.fields) +
            "; answer: " + type_of(form.answer) + " };\n";
  }
  return text + "}\n";
}

}  // namespace smile::page

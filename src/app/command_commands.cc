#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/exit_code.h"
#include "sim/command_documents.h"

namespace smile::app {
namespace {

/// Format of the list of commands; none of these: for people.
struct CommandList {
  bool schema = false, markdown = false, typescript = false;

  std::string Text() const {
    if (schema) return ToText(sim::CommandSchema(), 2) + "\n";
    if (markdown) return sim::CommandMarkdown();
    return typescript ? sim::CommandTypeScript() : sim::CommandText();
  }
};

}  // namespace

void AddCommands(CLI::App* program, ExitAnswer answer) {
  auto list = std::make_shared<CommandList>();
  CLI::App* commands = program->add_subcommand("commands", "List the commands of scripts and logs");
  CLI::App* form = commands->add_option_group("form");
  form->add_flag("--schema", list->schema, "JSON Schema, on stdout");
  form->add_flag("--markdown", list->markdown, "table of docs/commands.md, on stdout");
  form->add_flag("--typescript", list->typescript, "types of the studio's page, on stdout");
  form->require_option(0, 1);
  commands->callback([list, answer] {
    std::printf("%s", list->Text().c_str());
    *answer = kDone;
  });
}

}  // namespace smile::app

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "sim/command_json.h"

namespace smile::app {
namespace {

/// For people, made from the schema; docs/commands.md quotes it.
std::string Describe(const Json& schema) {
  std::string text;
  for (const Json& form : schema.at("oneOf")) {
    text += form.at("title").get<std::string>() + ": " + form.at("description").get<std::string>() +
            "\n";
    for (const auto& [name, property] : form.at("properties").items()) {
      if (name == "do" || name == "tick") continue;
      const Json& required = form.at("required");
      const bool is_required = std::find(required.begin(), required.end(), name) != required.end();
      text += "  " + name + (is_required ? "" : " (may be left out)") + ": " +
              property.at("description").get<std::string>() + "\n";
    }
  }
  return text;
}

}  // namespace

void AddCommands(CLI::App* program, ExitAnswer answer) {
  auto wants_schema = std::make_shared<bool>(false);
  CLI::App* commands =
      program->add_subcommand("commands", "List the commands that scripts and logs are made of");
  commands->add_flag("--schema", *wants_schema, "as a JSON Schema");
  commands->callback([wants_schema, answer] {
    const Json schema = sim::CommandSchema();
    std::printf("%s",
                *wants_schema ? (ToText(schema, 2) + "\n").c_str() : Describe(schema).c_str());
    *answer = kDone;
  });
}

}  // namespace smile::app

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/exit_code.h"
#include "page/protocol_text.h"

namespace smile::app {
namespace {

/// Requested table.
struct ProtocolTable {
  bool updates = false, typescript = false;

  std::string Text() const {
    if (typescript) return page::ProtocolTypeScript();
    return updates ? page::UpdateMarkdown() : page::RequestMarkdown();
  }
};

}  // namespace

void AddProtocol(CLI::App* program, ExitAnswer answer) {
  auto table = std::make_shared<ProtocolTable>();
  CLI::App* protocol =
      program->add_subcommand("protocol", "List the requests of the studio's page");
  CLI::App* form = protocol->add_option_group("form");
  form->add_flag("--news", table->updates, "messages to the page instead");
  form->add_flag("--typescript", table->typescript, "both as types of the page");
  form->require_option(0, 1);
  protocol->callback([table, answer] {
    std::printf("%s", table->Text().c_str());
    *answer = kDone;
  });
}

}  // namespace smile::app

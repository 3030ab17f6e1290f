// `smile study`: studies with participants.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "base/files.h"
#include "base/wording.h"
#include "study/check.h"
#include "study/deletion.h"
#include "study/results.h"
#include "study/study_server.h"
#include "web_server/public_origin.h"

namespace smile::app {
namespace {

struct StudyCommand {
  std::string definition, data;
  std::string participant, server = "http://127.0.0.1:8480/";
  std::string tls_certificate, tls_key;
  int participants = 1, added = 0;
  study::StudyServerOptions options;
};

void PrintLinks(const study::StudyData& data, const std::string& server) {
  for (const study::Participant& participant : data.participants()) {
    std::printf("%s %s\n", participant.id.c_str(), study::LinkOf(server, participant).c_str());
  }
  // stdout is buffered if it is a pipe, and would stay so until the server ends.
  std::fflush(stdout);
}

/// Returns the folder of the built page of participants.
/// @throws std::runtime_error if it has not been built.
std::filesystem::path StudyPageFolder() {
  try {
    return DataFile("build/page/study");
  } catch (const std::runtime_error&) {
    throw std::runtime_error("the page of studies is not built; run ./run study to build it");
  }
}

int Serve(const StudyCommand& command) {
  const study::Definition definition = study::ReadDefinition(command.definition);
  const std::filesystem::path folder = command.data.empty()
                                           ? std::filesystem::path("out/study") / definition.name
                                           : std::filesystem::path(command.data);
  study::StudyData data = study::StudyData::OpenOrMake(folder, command.definition, definition);
  if (data.num_issued() < command.participants) data.Add(command.participants - data.num_issued());
  study::StudyServerOptions options = command.options;
  options.page = StudyPageFolder();
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  if (!command.tls_certificate.empty()) {
    options.tls =
        web_server::TlsFiles{.certificate = command.tls_certificate, .key = command.tls_key};
  }
  study::StudyServer server(data, options);
  PrintLinks(data, server.link());
  std::fprintf(stderr, "smile: %s: the links above are open; Ctrl-C closes them\n",
               folder.string().c_str());
  server.Run(&IsInterrupted);
  return kDone;
}

int CheckData(const StudyCommand& command) {
  const study::CheckResult result = study::Check(study::StudyData(command.data));
  for (const std::string& note : result.notes) std::printf("%s\n", Printable(note).c_str());
  for (const std::string& finding : result.findings) {
    std::printf("%s\n", Printable(finding).c_str());
  }
  if (result.is_good()) std::printf("nothing is missing, and the order is balanced\n");
  return result.is_good() ? kDone : kInputWrong;
}

int Delete(const StudyCommand& command) {
  const study::StudyData data(command.data);
  const study::DeletionProof proof = study::DeleteParticipant(data, command.participant);
  std::printf("%s: %zu files deleted; %zu files searched\n", command.participant.c_str(),
              proof.num_deleted, proof.num_searched);
  for (const std::string& path : proof.remains) {
    std::printf("%s: still names the participant\n", Printable(path).c_str());
  }
  if (proof.remains.empty()) std::printf("nothing of the participant is left\n");
  return proof.remains.empty() ? kDone : kInputWrong;
}

int PrintAllLinks(const StudyCommand& command) {
  study::StudyData data(command.data);
  data.Add(command.added);
  PrintLinks(data, command.server);
  return kDone;
}

int Report(const StudyCommand& command) {
  const std::filesystem::path folder = study::WriteReport(study::StudyData(command.data));
  for (const char* name : {"trials.csv", "answers.csv", "codebook.md", "report.html"}) {
    std::printf("%s\n", (folder / name).c_str());
  }
  return kDone;
}

using Action = int (*)(const StudyCommand&);

/// Adds a command about the data of a study.
CLI::App* AddDataCommand(CLI::App* study, const char* name, const char* meaning,
                         const std::shared_ptr<StudyCommand>& options, Action action,
                         ExitAnswer answer) {
  CLI::App* command = study->add_subcommand(name, meaning);
  command->add_option("DATA", options->data, "folder of the data of a study")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->callback([options, action, answer] { *answer = action(*options); });
  return command;
}

void AddServerOptions(CLI::App* study, StudyCommand* options) {
  study->add_option("STUDY", options->definition, "file that defines the study (docs/studies.md)")
      ->check(NotEmpty());
  study
      ->add_option("--data", options->data,
                   "folder of the data of participants (default: out/study/NAME)")
      ->check(NotEmpty());
  study->add_option("--participants", options->participants, "number of links, at least")
      ->capture_default_str()
      ->check(CLI::Range(1, study::StudyData::kMaxParticipants));
  study
      ->add_option("--port", options->options.port,
                   "port of the page; 0 for the first free port from 8480 on")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  study
      ->add_option("--listen", options->options.address,
                   "address on which other machines can connect; 0.0.0.0 for all addresses of this "
                   "machine")
      ->capture_default_str()
      ->check(NotEmpty());
  study->add_option_function<std::string>(
      "--public-url",
      [options](const std::string& url) {
        try {
          options->options.public_origin = web_server::OriginOf(url);
        } catch (const std::invalid_argument& error) {
          throw CLI::ValidationError("--public-url", error.what());
        }
      },
      "https://NAME at which a proxy passes requests on to this server");
  CLI::Option* certificate =
      study->add_option("--tls-cert", options->tls_certificate, "certificate chain in PEM format")
          ->check(CLI::ExistingFile);
  CLI::Option* key = study->add_option("--tls-key", options->tls_key, "its key in PEM format")
                         ->check(CLI::ExistingFile)
                         ->needs(certificate);
  certificate->needs(key);
  study
      ->add_option("--sessions", options->options.max_sessions,
                   "maximal number of trials at a time; further participants wait")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
}

}  // namespace

void AddStudy(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<StudyCommand>();
  CLI::App* study = program->add_subcommand(
      "study", "Run a study with participants: serve their pages, check, report and delete data");
  study->require_subcommand(0, 1);
  AddServerOptions(study, options.get());
  AddDataCommand(study, "report", "Write tables, codebook and a page of a study", options, &Report,
                 answer);
  AddDataCommand(study, "check", "Check that the order is balanced and that nothing is missing",
                 options, &CheckData, answer);
  AddDataCommand(study, "delete", "Delete a participant who withdraws", options, &Delete, answer)
      ->add_option("PARTICIPANT", options->participant, "pseudonym, like P07")
      ->required();
  CLI::App* links =
      AddDataCommand(study, "links", "Print the links of participants, and add further ones",
                     options, &PrintAllLinks, answer);
  links->add_option("--add", options->added, "number of participants to add")
      ->capture_default_str()
      ->check(CLI::Range(0, study::StudyData::kMaxParticipants));
  links->add_option("--server", options->server, "address of the server, with a / at its end")
      ->capture_default_str()
      ->check(NotEmpty());
  study->callback([study, options, answer] {
    if (!study->get_subcommands().empty()) return;
    if (options->definition.empty()) throw CLI::RequiredError("STUDY");
    *answer = Serve(*options);
  });
}

}  // namespace smile::app

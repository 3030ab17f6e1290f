#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brain/brain_process.h"
#include "brain/internal_rendezvous.h"
#include "brain/internal_served_brain.h"
#include "process/child_process.h"

namespace smile::brain {

/// Location of a brain and the way it is started.
struct BrainProgram {
  std::filesystem::path folder;             ///< absolute
  std::filesystem::path working_directory;  ///< the folder's parent
  std::string folder_name;                  ///< within the working directory, ending in `/`
  std::filesystem::path main_file;          ///< absolute: agentBehavior.m, or the file itself
  Rendezvous::Kind rendezvous = Rendezvous::Kind::kSocket;
  std::optional<ServerAddress> server;       ///< of a served brain, which has no command
  process::ChildCommand command;             ///< without the address, which is added later
  std::vector<std::string> debug_arguments;  ///< in place of the command's, under a debugger
  std::string debug_hint;                    ///< what to type in the debugger
};

/// Finds a brain and the program that runs it.
/// @throws InputError if the brain does not exist or cannot be run.
/// @throws std::runtime_error if its interpreter (Octave, the client) is not installed.
BrainProgram FindBrainProgram(const std::filesystem::path& brain, BrainTransport transport);

/// Returns instructions to start this program under a debugger: a shell command with explanations.
std::string HowToAttach(const BrainProgram& program, const process::ChildCommand& command);

}  // namespace smile::brain

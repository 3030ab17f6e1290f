#pragma once

#include <optional>
#include <string>

#include "page/requests.h"

namespace smile::study {

/// Returns why a participant may not send a request to the studio: only those that demonstrate are
/// carried out, since participants are strangers. No scene is loaded, no program started, no file
/// changed but the recording, and time passes as it does.
std::optional<texts::UserMessage> RefuseToParticipant(const page::Request& request);

}  // namespace smile::study

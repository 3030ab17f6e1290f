#pragma once

#include "brain_client/brain.h"

/// Earlier names of the brain client, for brains that use them.
namespace smile::agent {

using namespace brain_client;  // NOLINT(google-build-using-namespace): all names, under another
using Program = brain_client::Brain;

}  // namespace smile::agent

#include "base/version.h"

namespace smile {

std::string ProgramName() { return "smile " SMILE_VERSION; }

}  // namespace smile

#include "classic_input.h"
#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  return smile::fuzz::StopAtFault(smile::fuzz::FaultWithClassic(smile::fuzz::AsText(data, size)));
}

#include "fuzz_target.h"
#include "model_input.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  return smile::fuzz::StopAtFault(smile::fuzz::FaultWithModel(smile::fuzz::AsText(data, size)));
}

#include "brain_input.h"
#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace smile::fuzz;
  return StopAtFault(FaultWithBrainMessage(AsText(data, size)));
}

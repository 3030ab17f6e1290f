#include "fuzz_target.h"
#include "page_input.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace smile::fuzz;
  return StopAtFault(FaultWithPageInput(AsText(data, size)));
}

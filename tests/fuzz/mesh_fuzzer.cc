#include "fuzz_target.h"
#include "mesh_input.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  return smile::fuzz::StopAtFault(smile::fuzz::FaultWithMesh(smile::fuzz::AsText(data, size)));
}

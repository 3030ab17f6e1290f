#include "app/open_recording.h"

#include <cstdio>

#include "base/diagnostic.h"
#include "base/version.h"
#include "base/wording.h"

namespace smile::app {

recording::Recording OpenAndReport(const std::string& demo) {
  recording::Recording recording = recording::OpenRecording(demo);
  for (const std::string& cut : recording.cuts) {
    std::fprintf(stderr, "%s: %s\n", demo.c_str(), cut.c_str());
  }
  if (recording.info.program != ProgramName()) {
    std::fprintf(stderr, "%s: was made by %s; this program is %s\n", demo.c_str(),
                 Printable(recording.info.program).c_str(), ProgramName().c_str());
  }
  return recording;
}

void RequireOutsideOfRecordings(const std::string& out) {
  const auto around = recording::RecordingAround(out);
  if (!around) return;
  throw InputError(
      {out, 0, "", "is inside the recording " + around->string() + ", which is not changed"});
}

}  // namespace smile::app

#include "study/session_process.h"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>

#include "base/wording.h"

namespace smile::study {
namespace {

constexpr std::size_t kMaxPrinted = 4096;

process::ChildCommand CommandOf(const SessionPlan& plan) {
  return {
      .arguments = {plan.program.string(), "studio", plan.scene.string(), "--no-robot", "--no-open",
                    "--no-pictures", "--participant", "--recordings", plan.recordings.string()},
      .working_directory = plan.recordings,
      .limits = plan.limits};
}

/// Returns the port in a printed link, if its line is complete.
std::optional<int> PortIn(const std::string& printed) {
  constexpr std::string_view kLink = "http://127.0.0.1:";
  const std::size_t begin = printed.find(kLink);
  if (begin == std::string::npos || printed.find('\n', begin) == std::string::npos) {
    return std::nullopt;
  }
  return std::atoi(printed.c_str() + begin + kLink.size());
}

}  // namespace

SessionProcess::SessionProcess(const SessionPlan& plan)
    : child_(CommandOf(plan)), output_(child_.TakeOutput()) {}

void SessionProcess::Update() {
  char buffer[4096];
  for (ssize_t count = 0; output_ && (count = ::read(output_.get(), buffer, sizeof buffer)) >= 0;) {
    if (count == 0) output_.Close();
    printed_.append(buffer, static_cast<std::size_t>(count));
    if (!port_) port_ = PortIn(printed_);
    if (printed_.size() > kMaxPrinted) printed_.erase(0, printed_.size() - kMaxPrinted);
  }
}

void SessionProcess::Interrupt() const { child_.SignalGroup(SIGINT); }

std::string SessionProcess::End() {
  const std::string how = child_.End();
  Update();
  return how + ": " + Printable(printed_);
}

}  // namespace smile::study

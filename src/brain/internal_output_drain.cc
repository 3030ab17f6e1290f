#include "brain/internal_output_drain.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "brain/brain_messages.h"

namespace smile::brain {
namespace {

/// Limit on the output read at once: a descendant that prints without end must not block Finish().
constexpr std::size_t kMaxLastBytes = std::size_t{1} << 20;

}  // namespace

OutputDrain::OutputDrain(process::UniqueFd pipe, std::function<void(std::string_view)> on_line)
    : pipe_(std::move(pipe)),
      on_line_(std::move(on_line)),
      second_began_(std::chrono::steady_clock::now()) {
  // A second pipe wakes the thread from poll(), which a condition variable could not do.
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  }
  wake_read_ = process::UniqueFd(ends[0]);
  wake_write_ = process::UniqueFd(ends[1]);

  // Signals are handled by the program's own threads.
  sigset_t all, before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { Run(); });
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

void OutputDrain::Finish() {
  if (!thread_.joinable()) return;
  // The reading end of the pipe sees its end, which wakes the thread.
  wake_write_.Close();
  thread_.join();
  pipe_.Close();
}

std::vector<std::string> OutputDrain::LastLines() const {
  const std::lock_guard lock(mutex_);
  return {last_lines_.begin(), last_lines_.end()};
}

void OutputDrain::Run() {
  // Runs until Finish() closes the writing end of the wake-up pipe.
  pollfd watched[] = {{pipe_.get(), POLLIN, 0}, {wake_read_.get(), POLLIN, 0}};
  while (watched[1].revents == 0) {
    if (::poll(watched, 2, -1) < 0 && errno != EINTR) break;
    // At end of file the pipe is always readable; from then on only the wake-up is polled.
    if (watched[0].revents != 0 && !ReadAvailable(kMaxLastBytes)) watched[0].fd = -1;
  }
  // The program has ended by now, but the pipe may still hold its last output. Descendants that
  // survive may keep the pipe open, so the end of file cannot be waited for.
  if (watched[0].fd >= 0) ReadAvailable(kMaxLastBytes);
  if (!line_.empty()) EndLine();
  ReportSkippedLines();
}

bool OutputDrain::ReadAvailable(std::size_t max_bytes) {
  char buffer[1 << 16];
  std::size_t total = 0;
  while (total < max_bytes) {
    const ssize_t count = ::read(pipe_.get(), buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN;
    if (count == 0) return false;
    TakeText({buffer, static_cast<std::size_t>(count)});
    total += static_cast<std::size_t>(count);
  }
  return true;
}

void OutputDrain::TakeText(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    // One letter more than the limit lets PrintableText() know that the line was cut.
    const std::size_t room = kMaxLineLetters + 1 - line_.size();
    line_.append(text.substr(0, std::min(length, room)));
    if (length == text.size()) return;
    EndLine();
    text.remove_prefix(length + 1);
  }
}

void OutputDrain::EndLine() {
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  const std::string line = PrintableText(line_, kMaxLineLetters);
  line_.clear();
  {
    const std::lock_guard lock(mutex_);
    last_lines_.push_back(line);
    if (last_lines_.size() > kLinesKept) last_lines_.pop_front();
  }
  HandOn(line);
}

void OutputDrain::HandOn(const std::string& line) {
  const auto now = std::chrono::steady_clock::now();
  if (now - second_began_ >= std::chrono::seconds(1)) {
    ReportSkippedLines();
    second_began_ = now;
    // A fixed window per second is enough: it bounds the load on clients, and its edges do not
    // matter.
    lines_this_second_ = 0;
  }
  if (++lines_this_second_ > kMaxLinesPerSecond) {
    ++num_skipped_lines_;
  } else if (on_line_) {
    on_line_(line);
  }
}

void OutputDrain::ReportSkippedLines() {
  if (num_skipped_lines_ > 0 && on_line_) {
    on_line_("... " + std::to_string(num_skipped_lines_) + " more lines were not shown");
  }
  num_skipped_lines_ = 0;
}

}  // namespace smile::brain

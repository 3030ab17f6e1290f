#include "brain/internal_message_channel.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

namespace smile::brain {
namespace {

// Length of a poll(): the longest delay until a cancellation is noticed.
constexpr int kSliceMs = 50;
// The largest pipe that Linux grants without privileges (fs.pipe-max-size by default).
constexpr int kPipeBytes = 1 << 20;
constexpr auto kWatchfulTime = std::chrono::microseconds(50);

/// Blocks SIGPIPE in this thread during its lifetime: writing to a pipe without reader then returns
/// an error code. Sockets have MSG_NOSIGNAL for this purpose; pipes have nothing. A handler for the
/// whole process would be a side effect on the programs that use this library.
class BrokenPipeIsQuiet {
 public:
  BrokenPipeIsQuiet() {
    // A signal that was already pending has another cause and must not be removed at the end.
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE);
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~BrokenPipeIsQuiet() {
    // Removes a signal that was caused meanwhile, before the mask is restored.
    const timespec now = {};
    if (!was_pending_) ::sigtimedwait(&pipe_, nullptr, &now);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  BrokenPipeIsQuiet(const BrokenPipeIsQuiet&) = delete;
  BrokenPipeIsQuiet& operator=(const BrokenPipeIsQuiet&) = delete;

 private:
  sigset_t pipe_, before_;
  bool was_pending_ = false;
};

void MakeNonBlocking(int fd) { ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) | O_NONBLOCK); }

ChannelFault SystemFault() { return {ChannelFault::Kind::kClosed, std::strerror(errno)}; }

/// Waits a slice of time for `events`; returns a fault when waiting is over. Events that have
/// occurred by then still count.
std::optional<ChannelFault> WaitASlice(int fd, short events, const process::WaitLimit& limit) {
  // The limit is evaluated before the poll, and the poll decides after it: an answer that arrived
  // at the last moment counts, also when a busy machine woke this thread late.
  const bool is_cancelled = limit.IsCancelled();
  const bool is_over = is_cancelled || limit.HasPassed();
  pollfd watched{fd, events, 0};
  const int ready = ::poll(&watched, 1, is_over ? 0 : limit.SliceMs(kSliceMs));
  if (ready < 0 && errno != EINTR) return SystemFault();
  if (ready > 0 || !is_over) return std::nullopt;
  if (is_cancelled) return ChannelFault{ChannelFault::Kind::kCancelled, "canceled"};
  return ChannelFault{ChannelFault::Kind::kTimedOut, "timed out"};
}

}  // namespace

MessageChannel::MessageChannel(process::UniqueFd read_end, process::UniqueFd write_end)
    : read_end_(std::move(read_end)), write_end_(std::move(write_end)) {
  MakeNonBlocking(read_end_.get());
  MakeNonBlocking(write_fd());
  // A larger buffer transfers a picture in a few pieces; if the system refuses, more pieces are
  // needed.
  if (!is_socket()) ::fcntl(write_fd(), F_SETPIPE_SZ, kPipeBytes);
}

MessageChannel::MessageChannel(process::UniqueFd socket)
    : MessageChannel(std::move(socket), process::UniqueFd()) {}

ssize_t MessageChannel::WriteSome(std::span<const std::byte> bytes) const {
  if (is_socket()) return ::send(write_fd(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  const BrokenPipeIsQuiet quiet;
  return ::write(write_fd(), bytes.data(), bytes.size());
}

std::optional<ChannelFault> MessageChannel::Send(std::span<const std::byte> frame,
                                                 const process::WaitLimit& limit) {
  while (!frame.empty()) {
    const ssize_t count = WriteSome(frame);
    // A full socket or pipe takes a part; the rest follows when poll() reports room.
    if (count >= 0) {
      frame = frame.subspan(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      if (auto fault = WaitASlice(write_fd(), POLLOUT, limit)) return fault;
    } else if (errno != EINTR) {
      return SystemFault();
    }
  }
  return std::nullopt;
}

std::variant<std::size_t, ChannelFault> MessageChannel::ReadSome() {
  // A pipe not yet opened for writing reads as ended, but poll() reports it as quiet.
  pollfd watched{read_end_.get(), POLLIN, 0};
  if (!is_socket() && ::poll(&watched, 1, 0) <= 0) return std::size_t{0};
  const std::span<std::byte> room = inbox_.Room();
  const ssize_t count = ::read(read_end_.get(), room.data(), room.size());
  if (count > 0) return static_cast<std::size_t>(count);
  if (count == 0) return ChannelFault{ChannelFault::Kind::kClosed, "end of file"};
  if (errno == EINTR || errno == EAGAIN) return std::size_t{0};
  return SystemFault();
}

std::variant<wire::Message, ChannelFault> MessageChannel::Receive(const process::WaitLimit& limit) {
  const auto watchful_until = process::WaitLimit::Clock::now() + kWatchfulTime;
  while (true) {
    // One read may bring several messages, so what is already in the inbox comes first.
    if (auto received = inbox_.TakeMessage()) {
      if (const auto* message = std::get_if<wire::MessageView>(&*received)) return Copied(*message);
      return ChannelFault{ChannelFault::Kind::kNonsense,
                          std::get<wire::WireError>(*received).message};
    }
    auto count = ReadSome();
    if (auto* fault = std::get_if<ChannelFault>(&count)) return std::move(*fault);
    inbox_.Fill(std::get<std::size_t>(count));
    if (std::get<std::size_t>(count) > 0) continue;
    // Spins for a moment before sleeping, see Channel.
    if (process::WaitLimit::Clock::now() < watchful_until) {
      ::sched_yield();
    } else if (auto fault = WaitASlice(read_end_.get(), POLLIN, limit)) {
      return std::move(*fault);
    }
  }
}

}  // namespace smile::brain

#include "brain/internal_channel.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

namespace smile::brain {
namespace {

constexpr int kSliceMs = 50;

/// While it lives, writing to a pipe that nobody reads is an error code instead of a signal.
class BrokenPipeIsQuiet {
 public:
  BrokenPipeIsQuiet() {
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE);
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~BrokenPipeIsQuiet() {
    // A signal that we caused is taken away again before the mask opens.
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

/// Waits a slice for `events`; a fault when waiting is over. What has come by then still counts.
std::optional<ChannelFault> WaitASlice(int fd, short events, const WaitLimit& limit) {
  const bool is_cancelled = limit.IsCancelled();
  const bool is_over = is_cancelled || limit.HasPassed();
  pollfd watched{fd, events, 0};
  const int ready = ::poll(&watched, 1, is_over ? 0 : limit.SliceMs(kSliceMs));
  if (ready < 0 && errno != EINTR) return SystemFault();
  if (ready > 0 || !is_over) return std::nullopt;
  if (is_cancelled) return ChannelFault{ChannelFault::Kind::kCancelled, "called off"};
  return ChannelFault{ChannelFault::Kind::kTimedOut, "out of time"};
}

}  // namespace

Channel::Channel(UniqueFd read_end, UniqueFd write_end)
    : read_end_(std::move(read_end)), write_end_(std::move(write_end)) {
  MakeNonBlocking(read_end_.get());
  MakeNonBlocking(write_fd());
}

Channel::Channel(UniqueFd socket) : Channel(std::move(socket), UniqueFd()) {}

std::optional<ChannelFault> Channel::Send(std::span<const std::byte> frame,
                                          const WaitLimit& limit) {
  const BrokenPipeIsQuiet quiet;
  while (!frame.empty()) {
    const ssize_t count = ::write(write_fd(), frame.data(), frame.size());
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

std::optional<ChannelFault> Channel::ReadAll(std::span<std::byte> bytes, const WaitLimit& limit) {
  while (!bytes.empty()) {
    // The poll comes first: a pipe that nobody has opened for writing yet reads as ended, but
    // polls as merely quiet.
    pollfd watched{read_end_.get(), POLLIN, 0};
    if (::poll(&watched, 1, 0) <= 0) {
      if (auto fault = WaitASlice(read_end_.get(), POLLIN, limit)) return fault;
      continue;
    }
    const ssize_t count = ::read(read_end_.get(), bytes.data(), bytes.size());
    if (count == 0) return ChannelFault{ChannelFault::Kind::kClosed, "end of file"};
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (errno != EINTR && errno != EAGAIN) {
      return SystemFault();
    }
  }
  return std::nullopt;
}

std::variant<wire::Message, ChannelFault> Channel::Receive(const WaitLimit& limit) {
  std::array<std::byte, wire::kHeaderBytes> head;
  if (auto fault = ReadAll(head, limit)) return std::move(*fault);
  const auto header = wire::DecodeHeader(head);
  if (const auto* error = std::get_if<wire::WireError>(&header)) {
    return ChannelFault{ChannelFault::Kind::kNonsense, error->message};
  }
  std::vector<std::byte> body(std::get<wire::FrameHeader>(header).body_bytes);
  if (auto fault = ReadAll(body, limit)) return std::move(*fault);
  auto message = wire::DecodeBody(std::get<wire::FrameHeader>(header), body);
  if (const auto* error = std::get_if<wire::WireError>(&message)) {
    return ChannelFault{ChannelFault::Kind::kNonsense, error->message};
  }
  return std::move(std::get<wire::Message>(message));
}

}  // namespace smile::brain

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <vector>

namespace smile::bench {

/// Two processes that exchange bytes over a socket, as simulator and brain do, and nothing
/// else: the machine's own time for a round trip.
class Echo {
 public:
  /// @throws std::runtime_error if no socket or process can be made.
  Echo(std::size_t question_bytes, std::size_t answer_bytes);
  Echo(const Echo&) = delete;
  Echo& operator=(const Echo&) = delete;
  ~Echo();

  /// @throws std::runtime_error if the other process has ended.
  void RoundTrip();

 private:
  std::vector<std::byte> question_, answer_;
  int socket_ = -1;
  pid_t child_ = -1;
};

}  // namespace smile::bench

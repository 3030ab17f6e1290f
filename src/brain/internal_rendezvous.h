#pragma once

#include <filesystem>
#include <optional>

#include "brain/internal_message_channel.h"
#include "process/unique_fd.h"

namespace smile::brain {

/// Meeting place with a brain: a folder that only this user can enter, with a socket or a pair of
/// pipes inside; for a served brain, which is met elsewhere, only the folder. It is removed with
/// this object, whatever the brain left in it; folders of simulators that were killed are removed
/// when the next one is made.
class Rendezvous {
 public:
  enum class Kind { kSocket, kPipes, kNone };

  /// @throws std::runtime_error with the folder and the reason.
  explicit Rendezvous(Kind kind);
  Rendezvous(const Rendezvous&) = delete;
  Rendezvous& operator=(const Rendezvous&) = delete;
  ~Rendezvous();

  const std::filesystem::path& folder() const { return folder_; }
  /// Returns the address for the brain: the socket, or the folder with the pipes `to_brain` and
  /// `from_brain`.
  std::filesystem::path address() const;

  /// Waits up to `slice_ms` for a connection; nullopt if there is none. Earlier connections are
  /// shut out.
  std::optional<MessageChannel> Meet(int slice_ms);
  /// Returns true if another connection waits; always false for pipes, which cannot be polled for
  /// that.
  bool HasVisitor() const;

 private:
  void LockFolder();
  void Listen();
  void MakePipes();

  Kind kind_;
  std::filesystem::path folder_;
  process::UniqueFd lock_;        ///< on the folder, while it is in use
  process::UniqueFd listener_;    ///< for the socket
  process::UniqueFd from_brain_;  ///< for pipes
};

}  // namespace smile::brain

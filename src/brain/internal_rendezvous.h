#pragma once

#include <filesystem>
#include <optional>

#include "brain/internal_channel.h"
#include "process/unique_fd.h"

namespace smile::brain {

/// The place where a brain finds us: a folder only this user can enter, with a socket or a pair of
/// pipes inside. The folder goes with this object, whatever the brain left in it; what a simulator
/// left that was killed goes with the next one made.
class Rendezvous {
 public:
  enum class Kind { kSocket, kPipes };

  /// @throws std::runtime_error naming the folder and the reason.
  explicit Rendezvous(Kind kind);
  Rendezvous(const Rendezvous&) = delete;
  Rendezvous& operator=(const Rendezvous&) = delete;
  ~Rendezvous();

  const std::filesystem::path& folder() const { return folder_; }
  /// What the brain is told: the socket, or the folder with the pipes `to_brain` and `from_brain`.
  std::filesystem::path address() const;

  /// Waits up to `slice_ms` for somebody to come; nullopt when nobody has. Whoever came before is
  /// shut out.
  std::optional<Channel> Meet(int slice_ms);
  /// Whether one more has come and waits; for pipes that cannot be told.
  bool HasVisitor() const;

 private:
  void LockFolder();
  void Listen();
  void MakePipes();

  Kind kind_;
  std::filesystem::path folder_;
  process::UniqueFd lock_;        ///< on the folder; says that somebody still needs it
  process::UniqueFd listener_;    ///< for the socket
  process::UniqueFd from_brain_;  ///< for pipes
};

}  // namespace smile::brain

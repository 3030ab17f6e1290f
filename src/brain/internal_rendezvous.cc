#include "brain/internal_rendezvous.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

namespace smile::brain {
namespace {

constexpr std::string_view kPrefix = "smile-brain-";
constexpr std::string_view kFolderName = "/smile-brain-XXXXXX";
// A folder exists for a moment before it is locked. Another simulator that starts right then must
// not take it for an abandoned one.
constexpr auto kLockTime = std::chrono::minutes(1);  ///< allowed from making a folder to locking it
constexpr std::string_view kSocketName = "/socket";

[[noreturn]] void Fail(const std::filesystem::path& path) {
  throw std::runtime_error(path.string() + ": " + std::strerror(errno));
}

/// Returns the template of the folder's name. A socket's path is limited (108 letters on Linux); if
/// the temporary directory is too long, /tmp is used.
std::string FolderTemplate() {
  std::error_code error;
  std::string base = std::filesystem::temp_directory_path(error).string();
  const std::size_t needed = base.size() + kFolderName.size() + kSocketName.size() + 1;
  if (error || needed > sizeof(sockaddr_un::sun_path)) base = "/tmp";
  return base + std::string(kFolderName);
}

/// Opens and locks a folder; empty if another process has locked it.
process::UniqueFd Locked(const std::filesystem::path& folder) {
  // O_NOFOLLOW: the temporary directory is shared, and another user may put a link there.
  process::UniqueFd fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!fd || ::flock(fd.get(), LOCK_EX | LOCK_NB) != 0) return {};
  return fd;
}

/// Removes folders of this user whose process has ended. The lock of a process ends with it in any
/// case; a process number could belong to another process in another container.
void RemoveStaleFolders(const std::filesystem::path& base) {
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(base, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& folder = entry->path();
    if (!folder.filename().string().starts_with(kPrefix)) continue;
    struct stat status = {};
    // Same precaution: only real directories that belong to this user are ever removed.
    if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
        status.st_uid != ::geteuid()) {
      continue;
    }
    const auto age =
        std::chrono::system_clock::now() - std::chrono::system_clock::from_time_t(status.st_mtime);
    std::error_code ignored;
    if (age > kLockTime && Locked(folder)) std::filesystem::remove_all(folder, ignored);
  }
}

}  // namespace

Rendezvous::Rendezvous(Kind kind) : kind_(kind) {
  std::string name = FolderTemplate();
  RemoveStaleFolders(std::filesystem::path(name).parent_path());
  // mkdtemp() creates it with mode 0700: no other user can connect to the brain's socket.
  if (!::mkdtemp(name.data())) Fail(name);
  folder_ = name;
  try {
    LockFolder();
    if (kind == Kind::kSocket) Listen();
    if (kind == Kind::kPipes) MakePipes();
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    throw;
  }
}

Rendezvous::~Rendezvous() {
  // The system removes the lock with the descriptor, after the folder.
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path Rendezvous::address() const {
  return kind_ == Kind::kSocket ? folder_ / "socket" : folder_;
}

void Rendezvous::LockFolder() {
  lock_ = Locked(folder_);
  if (!lock_) Fail(folder_);
}

void Rendezvous::Listen() {
  listener_ = process::UniqueFd(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  sockaddr_un name = {};
  name.sun_family = AF_UNIX;
  const std::string path = address();
  path.copy(name.sun_path, sizeof name.sun_path - 1);
  if (!listener_ ||
      ::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 ||
      // A backlog of 1: one brain connects; the queue only has to hold the next one under a
      // debugger.
      ::listen(listener_.get(), 1) != 0) {
    Fail(path);
  }
}

void Rendezvous::MakePipes() {
  for (const char* name : {"to_brain", "from_brain"}) {
    ::unlink((folder_ / name).c_str());
    if (::mkfifo((folder_ / name).c_str(), 0600) != 0) Fail(folder_ / name);
  }
  // Non-blocking, since opening a pipe for reading otherwise waits until the brain opens it for
  // writing.
  from_brain_ = process::UniqueFd(
      ::open((folder_ / "from_brain").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!from_brain_) Fail(folder_ / "from_brain");
}

std::optional<MessageChannel> Rendezvous::Meet(int slice_ms) {
  if (kind_ == Kind::kSocket) {
    pollfd watched{listener_.get(), POLLIN, 0};
    ::poll(&watched, 1, slice_ms);
    // Fails with EAGAIN when poll() timed out; that is the same answer: nothing has connected yet.
    process::UniqueFd socket(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
    if (!socket) return std::nullopt;
    return MessageChannel(std::move(socket));
  }
  if (!from_brain_) MakePipes();  // the former connection has the old ones
  // Opening fails until the brain has opened the other end; there is no way to poll for that.
  process::UniqueFd to_brain(
      ::open((folder_ / "to_brain").c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
  if (to_brain) return MessageChannel(std::move(from_brain_), std::move(to_brain));
  std::this_thread::sleep_for(std::chrono::milliseconds(std::min(slice_ms, 5)));
  return std::nullopt;
}

bool Rendezvous::HasVisitor() const {
  pollfd watched{listener_.get(), POLLIN, 0};
  return kind_ == Kind::kSocket && ::poll(&watched, 1, 0) > 0;
}

}  // namespace smile::brain

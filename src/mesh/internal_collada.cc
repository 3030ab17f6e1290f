// DAE by the library assimp, which crashes on some damaged files and whose cost is not bounded by
// the size of a file. Three barriers: CheckCost() refuses what multiplies, a child process with
// limits of time and memory contains crashes, and the parent checks the answer (floats through a
// pipe) like any file. Measurements: docs/decisions/meshes.md.

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "mesh/internal_mesh_formats.h"
#include "xml/parse.h"

namespace smile::mesh {
namespace {

constexpr const char* kOnlyFile = "mesh.dae";
constexpr std::size_t kMaxBytes = 16u << 20;
/// Exit status of a child whose output is an error message; no library uses it.
constexpr int kRefused = 42;
constexpr const char* kTooMuch =
    "is not a readable DAE: it is damaged or needs too much time or memory";

/// Read-only file in memory.
class MemoryStream : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::string_view bytes) : bytes_(bytes) {}

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    // Counts whole elements, as fread() does.
    const std::size_t whole = std::min(count, (bytes_.size() - position_) / size);
    std::memcpy(to, bytes_.data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_CUR   ? position_
                             : origin == aiOrigin_END ? bytes_.size()
                                                      : 0;
    // An unsigned wrap-around gives a target beyond the size, which is refused.
    const std::size_t target = origin == aiOrigin_END ? base - offset : base + offset;
    if (target > bytes_.size()) return aiReturn_FAILURE;
    position_ = target;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

/// File system with a single file: no other file can be opened, whatever the DAE names.
class OneFileSystem : public Assimp::IOSystem {
 public:
  explicit OneFileSystem(std::string_view bytes) : bytes_(bytes) {}

  bool Exists(const char* file) const override { return std::strcmp(file, kOnlyFile) == 0; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return Exists(file) && mode[0] == 'r' ? new MemoryStream(bytes_) : nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string_view bytes_;
};

/// Refuses references to nodes: nested references multiply, so a few lines could make millions of
/// nodes.
void RefuseInstances(const xml::Element& element) {
  if (element.name == "instance_node") {
    throw BadMesh("line " + std::to_string(element.line) +
                  ": found <instance_node>, expected each node in its place");
  }
  for (const xml::Element& child : element.children) RefuseInstances(child);
}

/// Enforces limits that the library does not: number of elements, their depth, references.
void CheckCost(std::string_view bytes) {
  const xml::ParseOptions options{
      .limits = {.max_bytes = kMaxBytes, .max_depth = 100, .max_elements = 200'000},
      .root = "COLLADA",
      .text = xml::TextPolicy::kSkip,
      .strictness = xml::Strictness::kTolerant};
  const xml::Parsed parsed = xml::Parse(bytes, /*file_name=*/"", options);
  if (parsed.root) return RefuseInstances(*parsed.root);
  const Diagnostic& fault = parsed.diagnostics.front();
  const std::string element = fault.element.empty() ? "" : "<" + fault.element + ">: ";
  throw BadMesh("line " + std::to_string(fault.line) + ": " + element + fault.message);
}

using Corners = std::vector<TriangleSoup::Corner>;  // three per triangle

/// Appends the triangles of a node and its children, in the frame of the scene.
void AddNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& X_SP, Corners* corners) {
  const aiMatrix4x4 X_SN = X_SP * node.mTransformation;
  // Node transforms may scale by negative factors.
  const bool is_mirrored = aiMatrix3x3(X_SN).Determinant() < 0;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      if (face.mNumIndices != 3) continue;  // points and lines
      // A mirrored node turns its triangles inside out: swap two corners.
      for (const int c : {0, is_mirrored ? 2 : 1, is_mirrored ? 1 : 2}) {
        const unsigned number = face.mIndices[c];
        // The library does not check the indices of all files.
        if (number >= mesh.mNumVertices) throw BadMesh("found an invalid corner");
        const aiVector3D p = X_SN * mesh.mVertices[number];
        corners->push_back({p.x, p.y, p.z});
      }
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    AddNode(scene, *node.mChildren[i], X_SN, corners);
  }
}

/// Reads a DAE file by the library. Called in the child process only.
/// @throws BadMesh if it cannot be read.
Corners CornersOf(std::string_view bytes, MeshAxes axes) {
  Assimp::Importer importer;
  // Otherwise, the library turns the scene by the file's `up_axis`.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION,
                           axes == MeshAxes::kAsWritten);
  importer.SetIOHandler(new OneFileSystem(bytes));  // owned by the importer from here on
  const aiScene* scene = importer.ReadFile(kOnlyFile, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) {
    const std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) throw BadMesh(kTooMuch);
    throw BadMesh("is not a readable DAE: " + Quoted(reason));
  }
  Corners corners;
  AddNode(*scene, *scene->mRootNode, aiMatrix4x4(), &corners);
  return corners;
}

/// Writes to a pipe; gives up silently if the reader is gone.
void WriteAll(int to, const void* bytes, std::size_t size) {
  const char* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t count = write(to, next, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
}

/// Reads a pipe to its end, or until there is more than expected.
std::string ReadAll(int from, std::size_t max_bytes) {
  std::string bytes;
  char buffer[1 << 16];
  while (bytes.size() <= max_bytes) {
    const ssize_t count = read(from, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
  return bytes;
}

/// Returns the private memory of this process in bytes: heap, stack and static data.
std::size_t BytesInUse() {
  // The limit of the kernel counts all private memory, also what the child inherited from the
  // parent; so the child may use that and kMaxMore.
  std::size_t pages[6] = {};  // the sixth number of statm, see proc(5)
  std::ifstream statm("/proc/self/statm");
  for (std::size_t& count : pages) statm >> count;
  return pages[5] * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Limits time and memory of this process: a small file can demand any amount.
void LimitThisProcess() {
  constexpr std::size_t kMaxMore = 320u << 20;
  const rlimit seconds{2, 2}, no_core{0, 0};
  const std::size_t bytes = BytesInUse() + kMaxMore;
  const rlimit memory{bytes, bytes};
  // Processor time, so that a busy machine does not change what is readable. RLIMIT_DATA makes
  // allocations fail, which the library reports as bad_alloc.
  setrlimit(RLIMIT_CPU, &seconds);
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_DATA, &memory);
}

/// Runs in the child: writes the corners, or an error message, into the pipe.
[[noreturn]] void AnswerAndExit(std::string_view bytes, MeshAxes axes, int to) {
  LimitThisProcess();
  // Without the parent's signal handlers: a crash ends the child at once.
  for (const int fault : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) std::signal(fault, SIG_DFL);
  try {
    const Corners corners = CornersOf(bytes, axes);
    WriteAll(to, corners.data(), corners.size() * sizeof corners[0]);
    _exit(0);
  } catch (const std::exception& error) {
    WriteAll(to, error.what(), std::strlen(error.what()));
  }
  _exit(kRefused);
}

}  // namespace

void ReadCollada(std::string_view bytes, TriangleSoup* soup) {
  constexpr std::size_t kMaxAnswer = 64u << 20;
  if (bytes.size() > kMaxBytes) {
    throw BadMesh("is larger than " + std::to_string(kMaxBytes) + " bytes, the most for DAE");
  }
  CheckCost(bytes);
  // The library crashes on some damaged files (seen with 5.2.5): run it in a process of its own.
  // Only the calling thread exists in the child; glibc keeps malloc() usable there.
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot create a pipe to read a DAE");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    AnswerAndExit(bytes, soup->axes(), ends[1]);
  }
  close(ends[1]);
  // Read to the end before waiting: a full pipe would block the child.
  const std::string answer = child > 0 ? ReadAll(ends[0], kMaxAnswer) : "";
  close(ends[0]);
  if (child < 0) throw std::runtime_error("cannot start a process to read a DAE");
  int status = 0;
  // Always collected, even if its answer is useless.
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  // Any other end of the child is a crash or a limit.
  if (WIFEXITED(status) && WEXITSTATUS(status) == kRefused && !answer.empty())
    throw BadMesh(answer);
  // A child that was killed may have written a part: the exit status decides, not the size.
  Corners corners(answer.size() / sizeof(TriangleSoup::Corner));
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || corners.size() % 3 != 0) {
    throw BadMesh(kTooMuch);
  }
  if (corners.empty()) return;
  std::memcpy(corners.data(), answer.data(), corners.size() * sizeof corners[0]);
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    soup->Add(corners[k], corners[k + 1], corners[k + 2]);
  }
}

}  // namespace smile::mesh

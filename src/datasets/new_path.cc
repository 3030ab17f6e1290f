#include "datasets/new_path.h"

#include "base/file_state.h"
#include "base/wording.h"
#include "page/requests.h"
#include "recording/recording_names.h"
#include "texts/user_message.h"

namespace smile::datasets {

using texts::Say;

std::filesystem::path NewPathIn(const std::filesystem::path& root, const ProductFolder& products,
                                const std::string& name, const std::string& ending) {
  if (!recording::IsRecordingName(name)) {
    throw page::RequestError(recording::FaultOfName(name));
  }
  const std::string kind = products.kind;
  const std::filesystem::path folder = root / products.folder;
  const FileState state = StateOf(folder);
  if ((state != FileState() && !state.is_directory) || StateOf(folder / "demo.json").is_file) {
    throw page::RequestError(folder.string() + " is no folder of " + kind + "s; rename it");
  }
  std::filesystem::path path = folder / (name + ending);
  if (StateOf(path) == FileState()) return path;
  throw page::RequestError(Say("sets.nameIsTaken", {{"kind", kind}, {"name", Quoted(name)}}));
}

}  // namespace smile::datasets

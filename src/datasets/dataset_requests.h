#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/json.h"
#include "datasets/generated_sets.h"
#include "datasets/job_queue.h"
#include "library/library.h"
#include "page/requests.h"

namespace smile::datasets {

struct DatasetOptions {
  std::filesystem::path program;  ///< executable with `generate`, `export` and `doctor`
  /// Arguments of `generate` for the robot and the files that scenes include.
  std::vector<std::string> robot_arguments;
  bool has_robot = true;
  std::filesystem::path scene;                ///< file that is open first; found by its name
  std::filesystem::path scene_folder;         ///< with the other scenes
  std::vector<std::filesystem::path> brains;  ///< folders, searched in order
};

/// Makes generated sets and datasets in the folder of a library, as pages request it.
class DatasetRequests {
 public:
  /// Folder in that of the recordings, with the exported datasets.
  static constexpr const char* kExportFolder = "datasets";
  static constexpr std::uint64_t kMaxCount = 10'000;  ///< of the episodes of a set

  /// @param library  must outlive this.
  DatasetRequests(DatasetOptions options, const library::Library* library);

  /// Adds the requests about jobs and generated sets. This must outlive the table.
  void AddTo(page::RequestTable* table, const page::InBackground& in_background);

 private:
  void AddReading(page::RequestTable* table, const page::InBackground& in_background);
  void AddTidying(page::RequestTable* table);
  Json Describe() const;
  Json Generate(const page::Request& request);
  Json Continue(const page::Request& request);
  Json Export(const page::Request& request);
  Json Film(const page::Request& request);
  /// @param wanted  the request with which a page asked for the set.
  Json Start(const Json& wanted);
  std::vector<std::string> GenerateArguments(const page::Request& request) const;
  std::vector<std::string> ExportArguments(const page::Request& request,
                                           const std::filesystem::path& to) const;
  std::filesystem::path SceneNamed(const std::string& name) const;
  std::vector<page::DeferredMessage> TakeChanges();

  DatasetOptions options_;
  const library::Library* library_;
  GeneratedSets sets_;
  std::size_t num_changes_ = 0;  ///< of jobs_, when the list was last sent
  JobQueue jobs_;                ///< last, since its thread uses sets_
};

}  // namespace smile::datasets

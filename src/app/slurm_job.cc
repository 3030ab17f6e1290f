#include "app/slurm_job.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/shell_word.h"
#include "base/files.h"

namespace smile::app {
namespace {

constexpr std::size_t kMaxCommandBytes = 1 << 22;

/// Returns the words of this process's command after the name of the program, without options that
/// are different in each shard.
std::vector<std::string> WordsOfEachShard() {
  const std::string line = ReadFile("/proc/self/cmdline", kMaxCommandBytes);
  std::vector<std::string> words;
  bool is_value = false, is_program = true;
  for (std::size_t at = 0, end = 0; at < line.size(); at = end + 1) {
    end = std::min(line.find('\0', at), line.size());
    const std::string word = line.substr(at, end - at);
    const bool is_skipped = is_program || is_value;
    is_value = is_program = false;
    if (is_skipped) continue;
    const std::string name = word.substr(0, word.find('='));
    if (name == "--slurm" || name == "--out" || name == "--jobs") {
      is_value = name == word;
    } else {
      words.push_back(word);
    }
  }
  return words;
}

std::string InQuotes(const std::filesystem::path& path) { return "\"" + path.string() + "\""; }

/// Returns a script for `sbatch`.
/// @param options  of `sbatch`.
std::string Script(const std::filesystem::path& log, std::initializer_list<std::string> options,
                   const std::string& line) {
  std::string text = "#!/bin/bash\n";
  for (const std::string& option : options) text += "#SBATCH " + option + "\n";
  // An appended log keeps what was said before an interruption.
  text += "#SBATCH --requeue --open-mode=append\n#SBATCH --output=" + InQuotes(log) + "\n";
  text += "#SBATCH --chdir=" + InQuotes(std::filesystem::current_path()) + "\n";
  return text + "exec " + line + "\n";
}

std::string ShardScript(std::size_t num_shards, std::size_t num_cores,
                        const std::filesystem::path& folder) {
  const std::string count = std::to_string(num_shards), cores = std::to_string(num_cores);
  std::string line = ShellWord(std::filesystem::read_symlink("/proc/self/exe"));
  for (const std::string& word : WordsOfEachShard()) line += " " + ShellWord(word);
  line += " --jobs " + cores + " --shard \"$SLURM_ARRAY_TASK_ID/" + count + "\" --out " +
          ShellWord(folder / "shard-") + "\"$SLURM_ARRAY_TASK_ID-of-" + count + "\"";
  return Script(folder / "shard-%a.log",
                {"--job-name=smile", "--array=1-" + count, "--cpus-per-task=" + cores,
                 // Before its time limit, the program alone is asked to end.
                 "--signal=B:TERM@60"},
                line);
}

std::string MergeScript(std::size_t num_shards, const std::filesystem::path& folder,
                        const std::filesystem::path& out) {
  const std::string count = std::to_string(num_shards);
  const std::string line = ShellWord(std::filesystem::read_symlink("/proc/self/exe")) + " merge " +
                           ShellWord(folder / "shard-") + "{1.." + count + "}-of-" + count +
                           " --out " + ShellWord(out);
  return Script(folder / "merge.log", {"--job-name=smile-merge"}, line);
}

/// Submits a script.
/// @returns the number of the job.
std::string Submit(const std::string& options, const std::filesystem::path& script) {
  const std::string line = "sbatch --parsable " + options + ShellWord(script);
  FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("sbatch: cannot be started");
  std::string answer;
  for (int letter = 0; (letter = std::fgetc(pipe)) != EOF;) answer += static_cast<char>(letter);
  const int status = pclose(pipe);
  // With several clusters: `number;cluster`.
  const std::string number = answer.substr(0, answer.find_first_of(";\n"));
  const bool is_number = !number.empty() && number.find_first_not_of("0123456789") == number.npos;
  if (status != 0 || !is_number) {
    throw std::runtime_error("Slurm did not take the job: `" + line + "` " +
                             (WIFEXITED(status) && WEXITSTATUS(status) == 127
                                  ? "needs a machine with Slurm"
                                  : "failed; its script can be changed and submitted by hand"));
  }
  return number;
}

}  // namespace

void SubmitToSlurm(std::size_t num_shards, std::size_t num_items, std::size_t num_cores,
                   const std::filesystem::path& out) {
  if (num_shards > num_items) {
    throw std::invalid_argument("--slurm is " + std::to_string(num_shards) +
                                ", expected at most one shard for each of " +
                                std::to_string(num_items));
  }
  const std::filesystem::path target = out.has_filename() ? out : out.parent_path();
  if (std::filesystem::exists(target)) {
    throw std::runtime_error(target.string() + ": exists, expected a new folder");
  }
  std::filesystem::path folder = target;
  folder += ".slurm";
  const std::filesystem::path shards = folder / "shards.sh", merge = folder / "merge.sh";
  MakeDirectories(folder);
  WriteFile(shards, ShardScript(num_shards, std::max<std::size_t>(num_cores, 1), folder));
  WriteFile(merge, MergeScript(num_shards, folder, target));
  const std::string array = Submit("", shards);
  // Not only after success: a shard in which episodes are missing is joined, too, and what failed
  // is told by the merge.
  const std::string joint = Submit("--dependency=afterany:" + array + " ", merge);
  std::printf("job %s: %zu shards\njob %s: joins them in %s\nlogs: %s/*.log\n", array.c_str(),
              num_shards, joint.c_str(), target.c_str(), folder.c_str());
}

}  // namespace smile::app

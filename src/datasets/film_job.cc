#include "datasets/film_job.h"

#include "datasets/new_path.h"
#include "datasets/picture_fields.h"
#include "datasets/program_progress.h"
#include "page/request_fields.h"

namespace smile::datasets {

Job FilmJob(const page::Request& request, const library::Library& library,
            const std::filesystem::path& program) {
  const page::RequestFields fields(request);
  const std::string name = fields.Text("name");
  const auto film =
      NewPathIn(library.root(), {.folder = library::kFilmFolder, .kind = "film"}, name, ".mp4");
  std::vector<std::string> arguments{program.string(),
                                     "render",
                                     library.DirectoryOf(fields.Text("recording")).string(),
                                     "--out",
                                     film.string(),
                                     "--camera",
                                     fields.Word("camera", kCameras),
                                     "--size",
                                     SizeArgument(fields),
                                     "--rate",
                                     RateArgument(fields),
                                     "--progress"};
  return {.what = "film",
          .name = name,
          .set = "",
          .programs = {{.arguments = std::move(arguments), .log = film.string() + ".log"}},
          .progress = [](const std::string& line) { return ProgressIn(line, "filming: "); }};
}

}  // namespace smile::datasets

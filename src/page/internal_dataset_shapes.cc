#include "page/internal_dataset_shapes.h"

#include "page/internal_shapes.h"

namespace smile::page {
namespace {

JsonShape CausesShape() { return JsonShape::Map(NumberShape()); }

JsonShape IntervalShape() { return JsonShape::List(NumberShape(), 2, 2).OrNull(); }

}  // namespace

JsonShape GeneratedSetShape() {
  return ObjectShape({{"name", TextShape()},
                      {"recording", TextShape().OrNull(), true, "the demonstration; null: unknown"},
                      {"scene", TextShape().OrNull()},
                      {"level", TextShape().OrNull()},
                      {"brain", TextShape().OrNull()},
                      {"wanted", NumberShape().OrNull(), true, "number of episodes"},
                      {"episodes", NumberShape()},
                      {"attempts", NumberShape()},
                      {"yield", NumberShape().OrNull(), true, "0 to 1"},
                      {"interval", IntervalShape(), true, "Wilson's 95 % interval of the yield"},
                      {"causes", CausesShape(), true, "number of failures for each cause"},
                      {"is_complete", FlagShape()},
                      {"can_continue", FlagShape(), true, "by `continue_set`"},
                      {"binned", FlagShape()},
                      {"picture", TextShape().OrNull(), true, "recording of an attempt"}})
      .Called("GeneratedSet");
}

JsonShape SetAttemptShape() {
  return ObjectShape({{"recording", TextShape().OrNull(), true, "null: the run has none"},
                      {"seed", NumberShape()},
                      {"episode", NumberShape(), true, "from 0"},
                      {"try", NumberShape(), true, "of the attempts at the episode, from 1"},
                      {"outcome", JsonShape::Word({"success", "failure", "impossible"})},
                      {"cause", ObjectShape({{"word", TextShape()},
                                             {"text", TextShape(), true, "in English"},
                                             {"message", MessageShape(), false,
                                              "the text in the language of the page"}})
                                    .OrNull()},
                      {"score", NumberShape()},
                      {"seconds", NumberShape().OrNull(), true, "simulated"},
                      {"scene", TextShape()},
                      {"level", TextShape()}})
      .Called("SetAttempt");
}

JsonShape VariationShape() {
  const JsonShape degree = ObjectShape(
      {{"name", TextShape()}, {"ranges", TextShape(), true, "as `smile generate` takes them"}});
  return ObjectShape({{"kind", TextShape()}, {"degrees", JsonShape::List(degree)}})
      .Called("Variation");
}

JsonShape JobShape() {
  const JsonShape verdict = ObjectShape({{"ok", FlagShape()}, {"lines", TextsShape()}});
  return ObjectShape({{"job", NumberShape()},
                      {"do", JsonShape::Word({"generate", "export", "film"})},
                      {"name", TextShape(), true, "of what it makes"},
                      {"status", JsonShape::Word({"waiting", "running", "stopping", "done",
                                                  "failed", "stopped"})},
                      {"words", TextShape(), true, "last line of the output; why it failed"},
                      {"verdict", verdict.OrNull(), true, "of `smile doctor`"},
                      {"done", NumberShape(), kOptional, "episodes, or seconds of a film"},
                      {"total", NumberShape(), kOptional, "wanted ones"},
                      {"attempts", NumberShape(), kOptional},
                      {"yield", NumberShape().OrNull(), kOptional},
                      {"interval", IntervalShape(), kOptional},
                      {"causes", CausesShape(), kOptional, "number of failures for each cause"}})
      .Called("Job");
}

}  // namespace smile::page

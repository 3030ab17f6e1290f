#include "report/study_page.h"

#include "report/internal_plots.h"
#include "report/internal_table.h"
#include "report/markup.h"
#include "report/wording.h"

namespace smile::report {
namespace {

Markup HeaderOf(const StudyResults& results) {
  Markup header = Element("p", {{"class", "eyebrow"}}, "SMILE study");
  header += Element("h1", {}, results.title);
  header +=
      Element("p", {{"class", "lead"}},
              Plural(results.num_participants, "participant") + " in " +
                  Plural(results.conditions.size(), "condition") +
                  ". Each number of a participant is the mean of that participant's trials in "
                  "a condition.");
  return Element("header", {}, header);
}

/// Returns rates of success, as bars and as a table.
Markup SuccessSection(const StudyResults& results) {
  std::vector<RateRow> bars;
  Markup rows;
  for (const StudyCondition& condition : results.conditions) {
    if (condition.trials == 0) continue;
    const Interval interval = WilsonInterval(condition.successes, condition.trials);
    bars.push_back({condition.name, condition.successes, condition.trials, interval});
    const double rate =
        static_cast<double>(condition.successes) / static_cast<double>(condition.trials);
    rows += Row({RowHead(condition.name),
                 NumberCell(std::to_string(condition.successes) + " of " +
                            std::to_string(condition.trials)),
                 NumberCell(Percent(rate) + " (" + PercentRange(interval) + ")")});
  }
  if (bars.empty())
    return Section("Success", Element("p", {}, "There are no complete trials yet."));
  Markup content = Table(
      "Trials at whose end all relations of the goal held; 95 % confidence "
      "intervals by Wilson, which regard trials as independent.",
      Row({Head("Condition"), NumberHead("Successes"), NumberHead("Rate (95 %)")}), rows);
  content += RateBars(bars, "Rates of success by condition; the table has the same numbers");
  return Section("Success", content);
}

/// Returns a row of the table of a measure.
Markup MeasureRow(const StudyResults& results, const StudyMeasure& measure, std::size_t k) {
  const std::vector<double> numbers = Present(measure.numbers[k]);
  Markup difference = NumberCell(kNone), size = NumberCell(kNone);
  if (k > 0) {
    if (const auto effect = EffectOf(measure.numbers[0], measure.numbers[k])) {
      difference = NumberCell(DifferenceWithInterval(effect->difference, measure.digits));
      if (effect->cohens_dz) size = NumberCell(Signed(*effect->cohens_dz, 2));
    }
  }
  return Row({RowHead(results.conditions[k].name), NumberCell(std::to_string(numbers.size())),
              NumberCell(WithInterval(MeanOf(numbers), measure.digits)),
              NumberCell(Fixed(Quantile(numbers, 0.5), measure.digits)), difference, size});
}

Markup MeasureSection(const StudyResults& results, const StudyMeasure& measure) {
  Markup rows;
  std::vector<DotRow> dots;
  for (std::size_t k = 0; k < results.conditions.size(); ++k) {
    rows += MeasureRow(results, measure, k);
    const std::vector<double> numbers = Present(measure.numbers[k]);
    if (!numbers.empty()) dots.push_back({results.conditions[k].name, numbers, MeanOf(numbers)});
  }
  Markup content = Table(
      "Means and differences with 95 % confidence intervals (Student's t). Differences are those "
      "to "
      "the first condition, within participants; d is Cohen's d of these differences.",
      Row({Head("Condition"), NumberHead("Participants"), NumberHead("Mean (95 %)"),
           NumberHead("Median"), NumberHead("Difference (95 %)"), NumberHead("d")}),
      rows);
  if (!dots.empty()) {
    content += DotPlot(dots, measure.name, measure.name + ": one dot for each participant");
  }
  return Section(measure.name, content);
}

}  // namespace

std::string StudyPage(const StudyResults& results) {
  Markup body = HeaderOf(results);
  body += SuccessSection(results);
  if (results.num_participants > 0) {
    for (const StudyMeasure& measure : results.measures) body += MeasureSection(results, measure);
  }
  return Page(results.title, body);
}

}  // namespace smile::report

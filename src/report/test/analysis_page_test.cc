#include "report/analysis_page.h"

#include <gtest/gtest.h>

namespace smile::report {
namespace {

std::size_t CountOf(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(AnalysisPageTest, ShowsSubtasksTheirOrderAndTheReasons) {
  analysis::Analysis analysis;
  for (const char* words : {"puts a", "points at <b>", "puts c"}) {
    analysis.subtasks.push_back(
        {.subtask = {.actions = {words}, .words = words}, .harm = "a is missing"});
  }
  analysis.subtasks[1].harm.reset();
  analysis.precedences = {{.before = 0, .after = 2, .harm = "c lies too low"}};
  const std::string page = PageOf(analysis, "demo");
  EXPECT_EQ(CountOf("2 of 3 subtasks are necessary", page), 1u);
  EXPECT_EQ(CountOf("class=\"edge\"", page), 1u);
  EXPECT_EQ(CountOf("class=\"subtask\"", page), 2u);
  EXPECT_EQ(CountOf("class=\"subtask redundant\"", page), 1u);
  EXPECT_EQ(CountOf("c lies too low", page), 1u);
  EXPECT_GE(CountOf("points at &lt;b&gt;", page), 1u);
  EXPECT_EQ(CountOf("<b>", page), 0u);
}

TEST(AnalysisPageTest, SaysWhatWasChangedAndWhatWasNotTried) {
  using Property = analysis::PropertyFinding::Property;
  analysis::Analysis analysis;
  analysis.properties = {{Property::kColor, "<i>", "black instead of red", std::nullopt},
                         {Property::kColor, "b", "", "the demonstrator said that it matters"},
                         {Property::kPlace, "", "100 mm to the left", "b fell from the table"}};
  analysis.why_not_moved = "objects are added";
  const std::string page = PageOf(analysis, "demo");
  EXPECT_EQ(CountOf("color of &lt;i&gt;: black instead of red", page), 1u);
  EXPECT_EQ(CountOf("color of b, not tried", page), 1u);
  EXPECT_EQ(CountOf("place of everything that is not fixed: 100 mm to the left", page), 1u);
  EXPECT_EQ(CountOf("b fell from the table", page), 1u);
  EXPECT_EQ(CountOf("Other places were not tried, since objects are added.", page), 1u);
}

}  // namespace
}  // namespace smile::report

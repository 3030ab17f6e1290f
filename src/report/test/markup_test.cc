#include "report/markup.h"

#include <gtest/gtest.h>

namespace smile::report {
namespace {

TEST(Markup, EscapesTextsAndAttributes) {
  EXPECT_EQ(Element("td", {{"title", "\"><script>"}}, "a < b & 'c'\x1b[2J").html(),
            "<td title=\"&quot;&gt;&lt;script&gt;\">a &lt; b &amp; &#39;c&#39;?[2J</td>");
}

TEST(Markup, LinksLeadToFilesBesideThePageOnly) {
  EXPECT_EQ(LinkTo("javascript:alert(1)", "run").html(),
            "<a href=\"./javascript%3Aalert%281%29\">run</a>");
  EXPECT_EQ(LinkTo("seed 1/a#b?c%20\"", "run").html(),
            "<a href=\"./seed%201/a%23b%3Fc%2520%22\">run</a>");
}

TEST(Markup, PicturesTravelWithinThePage) {
  // The examples of RFC 4648, section 10.
  const std::pair<const char*, const char*> texts[] = {
      {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, base64] : texts) {
    EXPECT_EQ(Picture(bytes, "x").html(),
              "<img src=\"data:image/png;base64," + std::string(base64) + "\" alt=\"x\">");
  }
}

TEST(Markup, APageFetchesNothingAndRunsNothing) {
  const std::string page = Page("<b>", Element("p", {}, "x"));
  EXPECT_NE(page.find("<title>&lt;b&gt;</title>"), std::string::npos);
  EXPECT_NE(page.find("default-src &#39;none&#39;"), std::string::npos);
  for (const char* word : {"http://", "https://", "<script", "<link", "@import", "url("}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace smile::report

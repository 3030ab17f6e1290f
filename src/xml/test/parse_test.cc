#include "xml/parse.h"

#include <gtest/gtest.h>

namespace smile::xml {
namespace {

std::string_view IdKey(std::string_view) { return "id"; }

Element MustParse(std::string_view text, const ParseOptions& options = {}) {
  Parsed parsed = Parse(text, "f.xml", options);
  for (const Diagnostic& diagnostic : parsed.diagnostics) ADD_FAILURE() << ToString(diagnostic);
  return parsed.root.value_or(Element{});
}

/// The diagnostic of a text that must be refused with exactly one.
std::string FaultOf(std::string_view text, const ParseOptions& options = {}) {
  const Parsed parsed = Parse(text, "f.xml", options);
  EXPECT_FALSE(parsed.root.has_value());
  EXPECT_EQ(parsed.diagnostics.size(), 1u);
  return parsed.diagnostics.empty() ? "" : ToString(parsed.diagnostics[0]);
}

std::string Repeated(std::string_view text, int count) {
  std::string repeated;
  for (int i = 0; i < count; ++i) repeated += text;
  return repeated;
}

TEST(Parse, ReturnsElementsWithAttributesTextAndLines) {
  const Element root = MustParse(
      "<?xml version='1.0'?>\n<a x='1'\n  y='&lt;2&#10;'>one<!-- - -->\n<b/> two "
      "&amp;<![CDATA[<c>]]>"
      "<c>\n<d/></c></a>");
  EXPECT_EQ(
      root,
      (Element{
          .name = "a",
          .line = 2,
          .attributes = {{"x", "1"}, {"y", "<2\n"}},
          .text = "one\n two &<c>",
          .children = {
              {.name = "b", .line = 4},
              {.name = "c", .line = 4, .text = "\n", .children = {{.name = "d", .line = 5}}}}}));
  EXPECT_EQ(*root.FindAttribute("x"), "1");
  EXPECT_EQ(root.FindAttribute("z"), nullptr);
  EXPECT_EQ(root.FindChild("c")->children[0].name, "d");
  EXPECT_EQ(root.FindChild("d"), nullptr);
}

TEST(Parse, KeepsTheFirstCommentBeforeTheRoot) {
  const auto comment_of = [](std::string_view text, const ParseOptions& options = {}) {
    return Parse(text, "f.xml", options).comment;
  };
  EXPECT_EQ(comment_of("<?xml version='1.0'?>\n<!-- one\n<two> &lt; --><!--three--><a/>"),
            " one\n<two> &lt; ");
  EXPECT_EQ(comment_of("<!----><!--second--><a/>"), "");
  EXPECT_EQ(comment_of("<a><!--inside--></a><!--behind-->"), "");
  EXPECT_EQ(comment_of("<!--kept--><a><b"), "kept") << "of a file that is cut off";
  EXPECT_EQ(comment_of("<!--no end"), "");
  EXPECT_EQ(comment_of("<!--" + std::string(9'000'000, 'x') + "--><a/>"), std::string(4096, 'x'));
  EXPECT_EQ(comment_of("<!--abc--><a/>", {.limits = {.max_comment_bytes = 2}}), "ab");
}

TEST(Parse, ReportsNamespacesAndLeavesOutWhatIsForTools) {
  const Element root = MustParse(
      "<p:a xmlns:p='urn:p' xmlns='urn:q' xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'"
      " xsi:schemaLocation='s' xml:lang='en' p:x='1'><b/><c xmlns=''/></p:a>");
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(root.namespace_name, "urn:p");
  EXPECT_EQ(root.attributes, (std::vector<Attribute>{{"p:x", "1"}}));
  EXPECT_EQ(root.children[0].namespace_name, "urn:q");
  EXPECT_EQ(root.children[1].namespace_name, "");
  EXPECT_EQ(MustParse("<a xmlns='" + std::string(1000, 'u') + "'/>").namespace_name,
            std::string(100, 'u'));
}

TEST(Parse, CountsLinesBeyondSixtyFiveThousand) {
  EXPECT_EQ(MustParse("<a>" + std::string(99'999, '\n') + "<b\n\n/></a>").children[0].line,
            100'000);
  EXPECT_EQ(FaultOf("<a>" + std::string(99'999, '\n') + "</b>").substr(0, 35),
            "f.xml:100000: found an error in the");
}

TEST(Parse, SkipsOrRefusesText) {
  EXPECT_EQ(MustParse("<a>text</a>", {.text = TextPolicy::kSkip}).text, "");
  const Parsed parsed = Parse("<a id='1'>\none\n<b/>two<!-- -->three\n<b> </b></a>", "f.xml",
                              {.text = TextPolicy::kRefuse, .key_of = IdKey});
  ASSERT_EQ(parsed.diagnostics.size(), 2u);
  EXPECT_EQ(ToString(parsed.diagnostics[0]),
            "f.xml:2: <a id=\"1\">: found text \"one\", expected only elements");
  EXPECT_EQ(ToString(parsed.diagnostics[1]),
            "f.xml:3: <a id=\"1\">: found text \"two\", expected only elements");
  ASSERT_TRUE(parsed.root.has_value());
  EXPECT_EQ(parsed.root->children.size(), 2u);
  EXPECT_EQ(parsed.num_elements, 3);
}

TEST(Parse, ListsABoundedNumberOfTexts) {
  const Parsed parsed = Parse("<a>" + Repeated("x<b/>", 50) + "<", "f.xml",
                              {.limits = {.max_diagnostics = 10}, .text = TextPolicy::kRefuse});
  EXPECT_EQ(parsed.diagnostics.size(), 11u) << "the fault that ends parsing in addition";
  EXPECT_FALSE(parsed.root.has_value());
}

TEST(Parse, RefusesWhatIsNotXml) {
  EXPECT_EQ(FaultOf(""), "f.xml:1: found an empty file, expected a <root> element");
  EXPECT_EQ(FaultOf("\xEF\xBB\xBF\n", {.root = "scene"}),
            "f.xml:1: found an empty file, expected a <scene> element");
  EXPECT_EQ(FaultOf("\n\nhello"),
            "f.xml:3: found something that is not XML, expected a <root> element");
  EXPECT_EQ(FaultOf(std::string_view("<a>\n\0</a>", 9)),
            "f.xml:2: found a NUL byte, expected XML text in UTF-8");
  for (const char* broken :
       {"<", "<a", "<a b", "<a b='", "<a/><a/>", "<a>", "<a>&lt", "<a>&no;</a>", "<a b='1' b='2'/>",
        "<x:a/>", "<!--", "<a><![CDATA[</a>", "<a>\xFF\xFE</a>", "<a>&#0;</a>", "</a>",
        "<?xml version='9'?>", "<?only this?>"}) {
    EXPECT_NE(FaultOf(broken), "") << broken;
  }
}

TEST(Parse, RefusesADoctypeAndWithItEveryEntity) {
  const std::string expected =
      "f.xml:2: found a DOCTYPE, expected none: files must be self-contained";
  EXPECT_EQ(FaultOf("<?xml version='1.0'?>\n<!DOCTYPE a [<!ENTITY a 'aa'><!ENTITY b '&a;&a;&a;'>"
                    "<!ENTITY c SYSTEM 'file:///etc/passwd'>]><a>&b;&c;</a>"),
            expected);
  EXPECT_EQ(FaultOf("\n<!DOCTYPE a SYSTEM 'http://127.0.0.1:1/a.dtd'><a/>"), expected);
}

TEST(Parse, RefusesInstructionsThatContainATag) {
  EXPECT_EQ(MustParse("<?style sheet?><a><?b?></a><?c?>").name, "a");
  EXPECT_EQ(FaultOf("<a>\n<?b <c> ?></a>"),
            "f.xml:2: found the processing instruction \"b\" with < or > inside, expected none");
}

TEST(Parse, RefusesOtherEncodings) {
  EXPECT_EQ(FaultOf("<?xml version='1.0' encoding='UTF-7'?><a/>"),
            "f.xml:1: found encoding=\"UTF-7\", expected UTF-8");
  EXPECT_EQ(FaultOf("<?xml version='1.0' encoding='ISO-8859-1'?><a/>"),
            "f.xml:1: found encoding=\"ISO-8859-1\", expected UTF-8");
}

TEST(Parse, ToleratesWhatToolsLeaveBehind) {
  const ParseOptions tolerant{.strictness = Strictness::kTolerant};
  EXPECT_EQ(MustParse("<a><!-- -- two -- ----><x:b y:c='1'/></a>", tolerant),
            (Element{.name = "a", .children = {{.name = "x:b", .attributes = {{"y:c", "1"}}}}}));
  EXPECT_EQ(MustParse("<?xml version='1.0' encoding='iso-8859-1'?><a b='\xE9'/>", tolerant)
                .attributes[0]
                .value,
            "\xC3\xA9");
  EXPECT_EQ(MustParse("<c:a xmlns:c='urn:c' xmlns='urn:d'/>", tolerant), (Element{.name = "c:a"}));
  for (const char* broken : {"<a>", "<a></b>", "<a b='1' b='2'/>", "<a>&no;</a>", "<a/><a/>",
                             "<a b=1/>", "<a>\xE9</a>"}) {
    EXPECT_NE(FaultOf(broken, tolerant), "") << broken;
  }
}

TEST(Parse, BoundsSizeDepthAndNumbers) {
  const ParseOptions options{.limits = {.max_bytes = 1000,
                                        .max_depth = 3,
                                        .max_elements = 10,
                                        .max_attributes = 4,
                                        .max_namespaces = 2},
                             .key_of = IdKey};
  MustParse("<a><b><c x='' y='' z='' id=''/></b></a>", options);
  MustParse("<a xmlns:b='urn:b' xmlns:c='urn:c'>" + Repeated("<b/>", 9) + "</a>", options);
  EXPECT_EQ(FaultOf("<a>" + std::string(1000, ' '), options),
            "f.xml:1: found 1003 bytes, expected at most 1000");
  EXPECT_EQ(FaultOf("<a><b><c>\n<d id='7'/>", options),
            "f.xml:2: <d id=\"7\">: found more than 3 elements inside one another, expected fewer");
  EXPECT_EQ(FaultOf("<a>" + Repeated("<b/>", 10), options),
            "f.xml:1: <b>: found more than 10 elements, expected fewer");
  EXPECT_EQ(FaultOf("<a>\n<b u='' v='' w='=' x='' y=''/>", options),
            "f.xml:2: found a tag with 5 attributes, expected at most 4");
  EXPECT_EQ(FaultOf("<a xmlns='urn:a' xmlns:b='urn:b' xmlns:c='urn:c'/>", options),
            "f.xml:1: <a>: found 3 xmlns attributes, expected at most 2");
}

TEST(Parse, CountsElementsOfOtherFiles) {
  const ParseOptions options{.limits = {.max_elements = 10}, .num_elements_before = 8};
  EXPECT_EQ(MustParse("<a><b/></a>", options).children.size(), 1u);
  EXPECT_EQ(FaultOf("<a><b/><c/></a>", options),
            "f.xml:1: <c>: found more than 10 elements, expected fewer");
}

TEST(Parse, EndsSoonAtAnySize) {
  EXPECT_EQ(FaultOf(Repeated("<a>", 1'000'000)).substr(0, 30), "f.xml:1: <a>: found more than ");
  std::string tag = "<a";
  for (int i = 0; i < 1'000'000; ++i) tag += " a" + std::to_string(i) + "=''";
  EXPECT_EQ(FaultOf(tag + "/>"),
            "f.xml:1: found a tag with 1000000 attributes, expected at most 256");
  const std::string huge(9'000'000, 'x');
  EXPECT_LT(FaultOf("<" + huge).size(), 500u);
  EXPECT_EQ(MustParse("<a b='" + huge + "'>" + huge + "</a>").text.size(), huge.size());
}

TEST(AddressOf, NamesTheKey) {
  const std::string value = "B3";
  EXPECT_EQ(AddressOf("block", "id", &value), "block id=\"B3\"");
  EXPECT_EQ(AddressOf("block", "id", nullptr), "block");
  EXPECT_EQ(AddressOf(std::string(1000, 'x'), "id", nullptr), std::string(60, 'x'));
}

}  // namespace
}  // namespace smile::xml

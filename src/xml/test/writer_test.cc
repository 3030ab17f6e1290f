#include "xml/writer.h"

#include <gtest/gtest.h>

namespace smile::xml {
namespace {

TEST(Writer, EscapesTextOfElementsAndAttributes) {
  Writer xml;
  xml.Open("a");
  xml.Attribute("b", "<\"&\n");
  xml.TextElement("c", "</c>&\t");
  xml.TextElement("d", "");
  xml.Open("e");
  xml.Count("f", 1);
  xml.Text("g");
  xml.Close();
  xml.Close();
  EXPECT_EQ(xml.Take(), R"(<?xml version="1.0" encoding="UTF-8"?>
<a b="&lt;&quot;&amp;&#10;">
  <c>&lt;/c&gt;&amp;&#9;</c>
  <d></d>
  <e f="1">g</e>
</a>
)");
}

}  // namespace
}  // namespace smile::xml

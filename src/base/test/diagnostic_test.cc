#include "base/diagnostic.h"

#include <gtest/gtest.h>

namespace smile {
namespace {

TEST(Diagnostic, BeginsWithItsAddress) {
  EXPECT_EQ(ToString({"scenes/um.xml", 14, "block id=\"B3\"", "mass is -1"}),
            "scenes/um.xml:14: <block id=\"B3\">: mass is -1");
  EXPECT_EQ(ToString({"um.xml", 0, "", "is empty"}), "um.xml: is empty");
  EXPECT_EQ(ToString({"", 0, "", "is empty"}), "is empty");
}

TEST(InputError, HasEachFindingOnItsOwnLine) {
  const InputError error({{"a", 1, "", "first"}, {"a", 2, "", "second"}});
  EXPECT_STREQ(error.what(), "a:1: first\na:2: second");
  EXPECT_EQ(error.diagnostics().size(), 2u);
}

}  // namespace
}  // namespace smile

#include "math/color.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace smile {
namespace {

TEST(Color, HasFourteenNamesThatRoundTrip) {
  EXPECT_EQ(ColorNames().size(), 14u);
  EXPECT_TRUE(std::ranges::is_sorted(ColorNames()));
  for (std::string_view name : ColorNames()) {
    ASSERT_TRUE(ParseColor(name)) << name;
    EXPECT_EQ(ToString(*ParseColor(name)), name);
  }
}

TEST(Color, IsReadFromHexadecimalDigits) {
  EXPECT_EQ(ParseColor("#ff8000"), (Color{1, 128 / 255.0, 0}));
  EXPECT_EQ(ParseColor(" #Ff8000\n"), (Color{1, 128 / 255.0, 0}));
  EXPECT_EQ(ParseColor(" red "), (Color{1, 0, 0}));
}

TEST(Color, RoundTrips) {
  for (int red = 0; red < 256; ++red) {
    const Color color{red / 255.0, 17 / 255.0, (255 - red) / 255.0};
    EXPECT_EQ(ParseColor(ToString(color)), color);
  }
}

TEST(Color, IsNotReadFromAnythingElse) {
  for (const char* text : {"", " ", "Red", "rot", "#", "#12345", "#1234567", "#12345g", "#-12345",
                           "#+12345", "#0x1234", "ff8000", "# ff800"}) {
    EXPECT_FALSE(ParseColor(text)) << text;
  }
}

}  // namespace
}  // namespace smile

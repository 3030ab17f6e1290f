#include "base/sharing_list.h"

#include <gtest/gtest.h>

#include <string>

namespace smile {
namespace {

TEST(SharingList, CopiesAreIndependentAndShareWhatIsEqual) {
  SharingList<std::string> list;
  list.Resize(100);
  for (std::size_t i = 0; i < 100; ++i) list.Set(i, std::to_string(i));
  const SharingList<std::string> before = list;
  list.Set(50, "changed");
  std::size_t num_shared = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(before[i], std::to_string(i));
    EXPECT_EQ(list[i], i == 50 ? "changed" : std::to_string(i));
    num_shared += &list[i] == &before[i];
  }
  EXPECT_EQ(num_shared, 92u);
}

TEST(SharingList, GrowsByDefaultValuesAlsoWhereOthersWere) {
  SharingList<int> list;
  list.Resize(12);
  for (std::size_t i = 0; i < 12; ++i) list.Set(i, 7);
  const SharingList<int> before = list;
  list.Resize(3);
  EXPECT_EQ(list.size(), 3u);
  list.Resize(20);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(list[i], i < 3 ? 7 : 0) << i;
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(before[i], 7) << i;
}

}  // namespace
}  // namespace smile

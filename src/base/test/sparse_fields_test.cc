#include "base/sparse_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace smile {
namespace {

struct Point {
  double x = 0, y = 0;
  int count = 0;
};

struct FieldsOfPoint {
  template <class P, class Field>
  static void Visit(P& point, Field field) {
    field(point.x);
    field(point.count);
    field(point.y);
  }
};

TEST(SparseFields, ReturnEveryBitAndTakeRoomOnlyForWhatIsNotZero) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Point& point : {Point{}, Point{1.5, -2.5, 3}, Point{-0.0, 0, -1}, Point{0, nan, 0}}) {
    ByteWriter out;
    PutSparse<FieldsOfPoint>(point, &out);
    // What is read replaces all that was there.
    Point read{7, 7, 7};
    ByteReader in(out.bytes());
    GetSparse<FieldsOfPoint>(&in, &read);
    EXPECT_TRUE(in.ok());
    EXPECT_EQ(in.remaining(), 0u);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.x), std::bit_cast<std::uint64_t>(point.x));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.y), std::bit_cast<std::uint64_t>(point.y));
    EXPECT_EQ(read.count, point.count);
  }
  ByteWriter out;
  PutSparse<FieldsOfPoint>(Point{0, 0, 5}, &out);
  EXPECT_EQ(out.size(), 8u + 4u);
}

TEST(SparseFields, AreZeroWhereBytesAreMissing) {
  ByteWriter out;
  PutSparse<FieldsOfPoint>(Point{1, 2, 3}, &out);
  Point read{7, 7, 7};
  ByteReader in(out.bytes().first(out.size() - 1));
  GetSparse<FieldsOfPoint>(&in, &read);
  EXPECT_FALSE(in.ok());
  EXPECT_EQ(read.y, 0);
}

}  // namespace
}  // namespace smile

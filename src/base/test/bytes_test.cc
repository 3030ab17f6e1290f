#include "base/bytes.h"

#include <gtest/gtest.h>

#include <array>

namespace smile {
namespace {

TEST(Bytes, AreReadInTheOrderOfWriting) {
  ByteWriter writer;
  writer.Put(std::uint8_t{7});
  writer.Put(-0.5);
  writer.PutString("two words");
  writer.PutString("");
  writer.Put(std::int32_t{-3});

  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.Get<std::uint8_t>(), 7);
  EXPECT_EQ(reader.Get<double>(), -0.5);
  EXPECT_EQ(reader.GetString(), "two words");
  EXPECT_EQ(reader.GetString(), "");
  EXPECT_EQ(reader.Get<std::int32_t>(), -3);
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(reader.remaining(), 0u);
}

TEST(ByteWriter, WritesLittleEndianWithoutPadding) {
  ByteWriter writer;
  writer.Put(std::uint8_t{1});
  writer.Put(std::uint32_t{0x04030201});
  const std::vector<std::byte> expected{std::byte{1}, std::byte{1}, std::byte{2}, std::byte{3},
                                        std::byte{4}};
  EXPECT_EQ(writer.Take(), expected);
  EXPECT_EQ(writer.size(), 0u);
}

TEST(ByteReader, ReturnsZerosPastTheEndAndReportsIt) {
  ByteWriter writer;
  writer.Put(std::uint16_t{9});
  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.Get<std::uint64_t>(), 0u);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.Get<std::uint16_t>(), 0) << "once past the end, always past the end";
}

TEST(ByteReader, DoesNotTrustALengthItReads) {
  ByteWriter writer;
  writer.Put(std::uint32_t{0xFFFFFFFF});
  writer.Put(std::uint8_t{'x'});
  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.GetString(), "");
  EXPECT_FALSE(reader.ok());
}

TEST(ByteReader, SkipsOnlyWhatComesNext) {
  ByteWriter writer;
  writer.Put(std::uint16_t{9});
  ByteReader reader(writer.bytes());
  EXPECT_FALSE(reader.SkipIfNext(std::array{std::byte{8}}));
  EXPECT_FALSE(reader.SkipIfNext(std::array{std::byte{9}, std::byte{0}, std::byte{0}}));
  EXPECT_TRUE(reader.SkipIfNext(std::array{std::byte{9}}));
  EXPECT_EQ(reader.remaining(), 1u);
  EXPECT_TRUE(reader.ok());
}

}  // namespace
}  // namespace smile

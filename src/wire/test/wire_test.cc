#include "wire/wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <stdexcept>

#include "wire/inbox.h"
#include "wire/test/wire_verbs.h"

namespace smile::wire {
namespace {

/// One of everything.
std::vector<std::byte> SampleFrame() {
  MessageWriter writer(MessageType::kStep, 41);
  writer.AddScalar("timeElapsed", 0.25);
  std::array<double, 14> angles{};
  angles[3] = -1.5;
  writer.AddDoubles("jointAngles", kTwoBySeven, angles);
  writer.AddLogical("demoCue", true);
  writer.AddText("path", "matlab/");
  writer.AddText("empty", "");
  const auto image = writer.AddSpace("rgbVision", ElementType::kByte, true, std::array{2u, 3u, 3u});
  for (std::size_t k = 0; k < image.size(); ++k) image[k] = std::byte(k * 15);
  return writer.Finish();
}

std::string ErrorOf(std::span<const std::byte> frame) {
  const auto decoded = DecodeFrame(frame);
  const auto* error = std::get_if<WireError>(&decoded);
  return error ? error->message : "no error";
}

template <class T>
void Overwrite(std::vector<std::byte>& frame, std::size_t at, T value) {
  ASSERT_LE(at + sizeof value, frame.size());
  std::memcpy(&frame[at], &value, sizeof value);
}

std::vector<std::byte> Encoded(const Message& message) {
  MessageWriter writer(message.type, message.sequence);
  for (const NamedArray& array : message.arrays) writer.AddArray(array);
  return writer.Finish();
}

TEST(Wire, MessagesRoundTrip) {
  const Message message = Decoded(SampleFrame());
  EXPECT_EQ(message.type, MessageType::kStep);
  EXPECT_EQ(message.sequence, 41u);
  ASSERT_EQ(message.arrays.size(), 6u);
  EXPECT_EQ(message.Find("timeElapsed")->Numbers(), std::vector{0.25});
  EXPECT_EQ(message.Find("jointAngles")->Numbers()->at(3), -1.5);
  EXPECT_EQ(ShapeText(message.Find("jointAngles")->dims), "2x7");
  EXPECT_EQ(message.Find("demoCue")->Numbers(), std::vector{1.0});
  EXPECT_EQ(message.Find("path")->Text(), "matlab/");
  EXPECT_EQ(message.Find("path")->Numbers(), std::nullopt);
  EXPECT_EQ(message.Find("empty")->Text(), "");
  EXPECT_EQ(message.Find("rgbVision")->Numbers()->at(17), 1.0);
  EXPECT_EQ(message.Find("nothing"), nullptr);
}

TEST(Wire, ReadingAndWritingAgainGivesTheSameBytes) {
  const auto frame = SampleFrame();
  EXPECT_EQ(Encoded(Decoded(frame)), frame);
}

TEST(Wire, DataLiesOnMultiplesOfEightBytes) {
  MessageWriter writer(MessageType::kStep, 1);
  writer.AddText("a", "xyz");
  const auto space = writer.AddSpace("value", ElementType::kDouble, false, kTwoBySeven);
  EXPECT_EQ(space.size(), 14 * sizeof(double));
  const auto frame = writer.Finish();
  EXPECT_EQ(frame.size() % 8, 0u);
}

TEST(Wire, ElementsGoFromColumnsToRows) {
  std::array<std::byte, 24> columns, rows;
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = std::byte(k);
  CopyToRowMajor(std::array{2u, 3u, 4u}, 1, columns, rows);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(rows[(i * 3 + j) * 4 + k], columns[i + 2 * (j + 3 * k)]);
      }
    }
  }
  CopyToRowMajor(std::array{0u, 4u}, 8, {}, {});
}

TEST(Wire, NamesWhatIsWrong) {
  auto frame = SampleFrame();
  EXPECT_EQ(ErrorOf(std::span(frame).first(7)), "the frame ends inside its header");
  EXPECT_EQ(ErrorOf(std::span(frame).first(frame.size() - 8)),
            "the body length differs from the header");

  auto wrong = frame;
  Overwrite(wrong, 0, std::uint32_t{7});
  EXPECT_EQ(ErrorOf(wrong), "the received bytes are not a message");
  wrong = frame;
  Overwrite(wrong, 4, std::uint32_t{9});
  EXPECT_EQ(ErrorOf(wrong), "unknown message type 9");
  wrong = frame;
  Overwrite(wrong, 12, std::uint32_t{0xffffffff});
  EXPECT_EQ(ErrorOf(wrong), "a message of 4294967295 bytes, expected at most 67108864");
  wrong = frame;
  Overwrite(wrong, 16, std::uint32_t{65});
  EXPECT_EQ(ErrorOf(wrong), "65 arrays in one message");
  wrong = frame;
  Overwrite(wrong, 16, std::uint32_t{5});
  EXPECT_EQ(ErrorOf(wrong), "bytes are left over after the last array");
  wrong = frame;
  Overwrite(wrong, 16, std::uint32_t{7});
  EXPECT_EQ(ErrorOf(wrong), "the body ends inside an array's head");

  // The first array's head: letters, type, dimensions, flags, then the two dimensions.
  wrong = frame;
  Overwrite(wrong, 25, std::uint8_t{4});
  EXPECT_EQ(ErrorOf(wrong), "array 'timeElapsed' has an unknown element type");
  wrong = frame;
  Overwrite(wrong, 27, std::uint8_t{1});
  EXPECT_EQ(ErrorOf(wrong), "array 'timeElapsed' has unknown flags");
  wrong = frame;
  Overwrite(wrong, 26, std::uint8_t{1});
  EXPECT_NE(ErrorOf(wrong), "no error");
  Overwrite(wrong, 26, std::uint8_t{255});
  EXPECT_NE(ErrorOf(wrong), "no error");
  wrong = frame;
  Overwrite(wrong, 28, std::uint64_t{0xffffffffffffffff});
  EXPECT_EQ(ErrorOf(wrong), "array 'timeElapsed' is too large: 4294967295x4294967295");
  wrong = frame;
  Overwrite(wrong, 28, std::uint32_t{1000});
  EXPECT_EQ(ErrorOf(wrong), "the body ends inside array 'timeElapsed'");
  wrong = frame;
  Overwrite(wrong, 36, '-');
  EXPECT_EQ(ErrorOf(wrong), "an array's name is not an identifier");
}

TEST(Wire, RefusesToWriteWhatItWouldNotRead) {
  MessageWriter writer(MessageType::kInit, 1);
  EXPECT_THROW(writer.AddScalar("two words", 1), std::invalid_argument);
  EXPECT_THROW(writer.AddScalar("", 1), std::invalid_argument);
  EXPECT_THROW(writer.AddScalar(std::string(64, 'a'), 1), std::invalid_argument);
  EXPECT_THROW(writer.AddDoubles("short", kTwoBySeven, std::array{1.0}), std::invalid_argument);
  EXPECT_THROW(writer.AddSpace("huge", ElementType::kByte, false, std::array{1u << 16, 1u << 16}),
               std::invalid_argument);
  EXPECT_THROW(writer.AddSpace("flat", ElementType::kByte, false, std::array{3u}),
               std::invalid_argument);
  writer.AddScalar("once", 1);
  EXPECT_THROW(writer.AddScalar("once", 2), std::invalid_argument);
  EXPECT_EQ(Decoded(writer.Finish()).arrays.size(), 1u);
}

TEST(Wire, HoldsAtMostSixtyFourArrays) {
  MessageWriter writer(MessageType::kInit, 1);
  for (int k = 0; k < 64; ++k) writer.AddScalar("a" + std::to_string(k), k);
  EXPECT_THROW(writer.AddScalar("one_more", 1), std::invalid_argument);
  EXPECT_EQ(Decoded(writer.Finish()).arrays.size(), 64u);
}

// Whatever is done to the bytes: no crash, no large allocation; and what is still accepted is a
// message like any other, which can be written and read again.
TEST(WireProperty, SurvivesAnyChangeOfItsBytes) {
  std::mt19937 random(20260401);
  const auto original = SampleFrame();
  int accepted = 0;
  for (int round = 0; round < 50'000; ++round) {
    auto frame = original;
    const int changes = 1 + static_cast<int>(random() % 4);
    for (int k = 0; k < changes; ++k) {
      // Small values and extremes reach further into the decoder than noise does.
      const std::uint32_t kind = random() % 3;
      const auto value = kind == 0 ? random() : kind == 1 ? random() % 9 : 0xff - random() % 2;
      // The magic is left alone, or little else would be tried.
      frame[4 + random() % (frame.size() - 4)] = std::byte(value);
    }
    if (random() % 8 == 0) frame.resize(kHeaderBytes + random() % (frame.size() - kHeaderBytes));
    if (random() % 2 == 0) {
      Overwrite(frame, 12, static_cast<std::uint32_t>(frame.size() - kHeaderBytes));
    }
    const auto decoded = DecodeFrame(frame);
    if (const auto* message = std::get_if<Message>(&decoded)) {
      ++accepted;
      ASSERT_EQ(Decoded(Encoded(*message)), *message);
    } else {
      ASSERT_FALSE(std::get<WireError>(decoded).message.empty());
    }
  }
  EXPECT_GT(accepted, 300);
}

TEST(WireProperty, RandomMessagesRoundTrip) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    Message message{.type = MessageType::kMotor,
                    .sequence = static_cast<std::uint32_t>(random()),
                    .arrays = {}};
    const std::size_t count = random() % 6;
    for (std::size_t k = 0; k < count; ++k) {
      NamedArray array{.name = std::string(1 + random() % 40, 'a') + std::to_string(k),
                       .type = static_cast<ElementType>(random() % 4)};
      std::size_t elements = 1;
      for (std::size_t d = 2 + random() % 3; d > 0; --d) {
        array.dims.push_back(static_cast<std::uint32_t>(random() % 5));
        elements *= array.dims.back();
      }
      array.is_row_major = random() % 2 == 0;
      array.is_fraction = array.type == ElementType::kByte && random() % 2 == 0;
      array.data.resize(elements * (array.type == ElementType::kDouble ? 8 : 1));
      for (std::byte& byte : array.data) byte = std::byte(random());
      message.arrays.push_back(std::move(array));
    }
    ASSERT_EQ(Decoded(Encoded(message)), message);
  }
}

/// Puts as many bytes of the stream into the inbox as fit, up to `most`.
std::size_t Receive(Inbox& inbox, std::span<const std::byte> stream, std::size_t most) {
  const std::span<std::byte> room = inbox.Room();
  const std::size_t count = std::min({most, stream.size(), room.size()});
  std::ranges::copy(stream.first(count), room.begin());
  inbox.Fill(count);
  return count;
}

TEST(Inbox, GivesEachMessageWhenAllOfItIsThere) {
  const std::vector<std::byte> frame = SampleFrame();
  std::vector<std::byte> stream = frame;
  stream.insert(stream.end(), frame.begin(), frame.end());
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, frame.size(), stream.size()}) {
    Inbox inbox;
    std::size_t sent = 0, messages = 0;
    while (sent < stream.size()) {
      const auto taken = inbox.TakeMessage();
      EXPECT_FALSE(taken) << "after " << sent << " bytes";
      const std::size_t count = Receive(inbox, std::span(stream).subspan(sent), piece);
      ASSERT_GT(count, 0u);
      for (sent += count; (messages + 1) * frame.size() <= sent; ++messages) {
        const auto message = inbox.TakeMessage();
        ASSERT_TRUE(message);
        EXPECT_EQ(Copied(std::get<MessageView>(*message)), Decoded(frame));
      }
    }
    EXPECT_EQ(messages, 2u);
  }
}

TEST(Inbox, PutsLargeBodiesWhereTheyAreToStay) {
  MessageWriter writer(MessageType::kStep, 1);
  const auto pixels = writer.AddSpace("p", ElementType::kByte, false, std::array{400u, 500u});
  for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = std::byte(k);
  const std::vector<std::byte> large = writer.Finish(), small = SampleFrame();
  std::vector<std::byte> stream;
  for (const auto* frame : {&small, &large, &small, &large, &large, &small}) {
    stream.insert(stream.end(), frame->begin(), frame->end());
  }

  std::vector<std::vector<std::byte>> rooms;
  Inbox given([&rooms](std::size_t size) { return std::span(rooms.emplace_back(size)); });
  Inbox own;
  for (Inbox* inbox : {&given, &own}) {
    std::vector<std::byte> again;
    for (std::size_t sent = 0; again.size() < stream.size();) {
      if (const auto taken = inbox->TakeMessage()) {
        const auto frame = Encoded(Copied(std::get<MessageView>(*taken)));
        again.insert(again.end(), frame.begin(), frame.end());
      } else {
        ASSERT_LT(sent, stream.size());
        sent += Receive(*inbox, std::span(stream).subspan(sent), 70'000);
      }
    }
    EXPECT_EQ(again, stream);
  }
  ASSERT_EQ(rooms.size(), 3u);
  for (const auto& room : rooms) {
    EXPECT_TRUE(std::ranges::equal(room, std::span(large).subspan(kHeaderBytes)));
  }
}

TEST(Inbox, RefusesInvalidHeaders) {
  Inbox inbox;
  EXPECT_FALSE(inbox.TakeMessage());
  std::ranges::fill(inbox.Room().first(kHeaderBytes), std::byte{7});
  inbox.Fill(kHeaderBytes);
  const auto message = inbox.TakeMessage();
  ASSERT_TRUE(message);
  EXPECT_EQ(std::get<WireError>(*message).message, "the received bytes are not a message");
}

}  // namespace
}  // namespace smile::wire

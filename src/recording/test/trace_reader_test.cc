// Long traces: read at any place, in windows, with an index or without.

#include "recording/trace_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <memory>

#include "base/diagnostic.h"
#include "base/files.h"
#include "recording/internal_trace_format.h"
#include "recording/trace_writer.h"

namespace smile::recording {
namespace {

namespace fs = std::filesystem;

class TraceReaderTest : public ::testing::Test {
 protected:
  TraceReaderTest() {
    fs::create_directories(root_);
    scene::SceneSpec scene{.name = "blocks"};
    for (int i = 0; i < 5; ++i) {
      scene::ObjectSpec object;
      object.whole = {.id = "b" + std::to_string(i),
                      .X_PE = RigidTransform(Vector3(0.2 * i, 0, 0.05)),
                      .shape = scene::Block{{0.1, 0.1, 0.1}}};
      scene.objects.push_back(std::move(object));
    }
    model_ = std::make_shared<const model::Model>(std::move(scene));
  }
  ~TraceReaderTest() override { fs::remove_all(root_); }

  Recording recording() const {
    return {.directory = root_, .start_model = model_, .model = model_};
  }
  fs::path trace() const { return root_ / "trace.bin"; }
  fs::path index() const { return root_ / "trace.index"; }

  /// Returns the state at a tick, at which one block moves, unless all rest.
  TraceTick MomentAt(std::uint64_t tick, double height = 1) const {
    TraceTick moment = StartOf(*model_);
    moment.tick = tick;
    moment.hash = tick * 0x9e3779b97f4a7c15;
    moment.objects[tick % 5].position.z() = height * static_cast<double>(tick % 1000 + 1);
    moment.objects[tick % 5].is_awake = true;
    return moment;
  }
  static sim::Event Pointing(const char* object) {
    return {.kind = sim::EventKind::kPointed,
            .hand = sim::HandName::kLeft,
            .object = object,
            .part = object};
  }

  /// Writes ticks and, now and then, an event.
  void Write(TraceWriter* trace, std::uint64_t first, std::uint64_t last, double height = 1) const {
    for (std::uint64_t tick = first; tick <= last; ++tick) {
      trace->Add(MomentAt(tick, height));
      if (tick % 701 == 0) trace->Add(Pointing(tick % 2 == 0 ? "b1" : "b2"));
    }
  }
  /// Writes two thousand ticks, and goes on from the middle as after an undo.
  void WriteBranches() const {
    TraceWriter trace(root_ / "trace.bin", *model_);
    trace.Add(Pointing("b3"));
    Write(&trace, 100, 1000);
    const TracePlace middle = trace.place();
    Write(&trace, 1001, 2000);
    trace.Return(middle, 1, 1000);
    Write(&trace, 1001, 3000, 2);
  }

  /// Returns the record of a tick with the objects that moved, and nothing else.
  static ByteWriter ChangesOf(const TraceTick& before, const TraceTick& now) {
    ByteWriter record;
    record.Put(now.tick);
    record.Put(now.hash);
    record.Put(std::uint8_t{0});
    std::vector<std::uint32_t> moved;
    for (std::uint32_t i = 0; i < now.objects.size(); ++i) {
      if (now.objects[i] != before.objects[i]) moved.push_back(i);
    }
    record.Put(static_cast<std::uint32_t>(moved.size()));
    for (const std::uint32_t i : moved) {
      record.Put(i);
      record.Put(static_cast<std::uint8_t>(kIsPresent | (now.objects[i].is_awake ? kIsAwake : 0)));
      for (double number : now.objects[i].position) record.Put(number);
      for (double number : now.objects[i].rotation) record.Put(number);
    }
    return record;
  }

  static void ExpectSame(const TraceTick& found, const TraceTick& expected) {
    EXPECT_EQ(found.tick, expected.tick);
    EXPECT_EQ(found.hash, expected.hash);
    EXPECT_EQ(found.objects, expected.objects);
    EXPECT_EQ(found.events, expected.events);
  }
  static std::vector<TraceTick> All(TraceReader trace) {
    std::vector<TraceTick> moments;
    while (auto moment = trace.Next()) moments.push_back(*std::move(moment));
    return moments;
  }

  const fs::path root_ = fs::path(testing::TempDir()) /
                         ("smile-trace-" + std::to_string(getpid()) + "-" +
                          testing::UnitTest::GetInstance()->current_test_info()->name());
  std::shared_ptr<const model::Model> model_;
};

TEST_F(TraceReaderTest, ReadsAtEveryTickWhatReadingThroughReads) {
  WriteBranches();
  for (const bool has_index : {true, false}) {
    SCOPED_TRACE(has_index ? "with an index" : "without an index");
    if (!has_index) fs::remove(index());
    const std::vector<TraceTick> all = All(TraceReader(recording()));
    ASSERT_EQ(all.size(), 2901u);
    ExpectSame(all.back(), MomentAt(3000, 2));

    TraceReader trace(recording());
    EXPECT_EQ(trace.events_before_start(), std::vector{Pointing("b3")});
    EXPECT_EQ(trace.LastTick(), 3000u);
    for (std::size_t k = 0; k < 3 * all.size(); ++k) {
      const TraceTick& expected = all[k < all.size() ? k : k * 7919 % all.size()];
      const auto found = trace.At(expected.tick);
      ASSERT_TRUE(found.has_value()) << expected.tick;
      ExpectSame(*found, expected);
      if (k % 3 == 0 && expected.tick < 3000) ExpectSame(*trace.Next(), all[expected.tick - 99]);
    }
    EXPECT_EQ(trace.At(99), std::nullopt);
    EXPECT_EQ(trace.At(3001), std::nullopt);
    ExpectSame(*trace.At(1000), all[900]);
    ExpectSame(*trace.Last(), all.back());
    EXPECT_EQ(trace.Next(), std::nullopt);

    std::vector<TracedEvent> events;
    for (const TraceTick& moment : all) {
      for (const sim::Event& event : moment.events) events.push_back({moment.tick, event});
    }
    EXPECT_EQ(events.size(), 4u);
    EXPECT_EQ(trace.Events(), events);
  }
}

TEST_F(TraceReaderTest, ReadsLittleOfALongTrace) {
  constexpr std::uint64_t kHour = 3600 * 60;
  for (const std::uint64_t length : {kHour / 4, kHour}) {
    fs::remove(trace());
    fs::remove(index());
    {
      TraceWriter writer(trace(), *model_);
      Write(&writer, 0, length);
    }
    ASSERT_GT(fs::file_size(trace()), length * 100);
    // A keyframe is at most this far away, and reading on loads windows that grow.
    constexpr std::uint64_t kNear = 4 * kKeyframeBytes;
    TraceReader reader(recording());
    EXPECT_EQ(reader.LastTick(), length);
    EXPECT_LT(reader.bytes_read(), kNear);
    for (const std::uint64_t tick : {length / 2, length / 3, length}) {
      const std::uint64_t before = reader.bytes_read();
      EXPECT_EQ(reader.At(tick)->hash, MomentAt(tick).hash);
      EXPECT_LT(reader.bytes_read() - before, kNear) << tick;
    }
    EXPECT_LT(fs::file_size(index()), fs::file_size(trace()) / 500);
  }
}

TEST_F(TraceReaderTest, ReadsATraceWithoutKeyframesNearItsBookmarks) {
  constexpr std::uint64_t kLast = 20'000;
  {
    TraceWriter writer(trace(), *model_);
    writer.Add(MomentAt(0));
  }
  fs::remove(index());
  // As older programs wrote it: only the first record is complete.
  AppendFile file(trace(), AppendFile::kExisting);
  for (std::uint64_t tick = 1; tick <= kLast; ++tick) {
    file.Append(ChangesOf(MomentAt(tick - 1), MomentAt(tick)).bytes());
  }
  TraceReader reader(recording());
  EXPECT_EQ(reader.LastTick(), kLast);
  ExpectSame(*reader.Last(), MomentAt(kLast));
  const std::uint64_t before = reader.bytes_read();
  for (std::uint64_t k = 1; k <= 50; ++k) {
    const std::uint64_t tick = k * 7919 % kLast;
    ExpectSame(*reader.At(tick), MomentAt(tick));
  }
  EXPECT_LT(reader.bytes_read() - before, 50 * 4 * kKeyframeBytes);
  EXPECT_LT(50 * 4 * kKeyframeBytes, 50 * fs::file_size(trace()) / 8);
}

TEST_F(TraceReaderTest, IgnoresAnIndexOfAnotherTrace) {
  WriteBranches();
  const std::string other_index = ReadFile(index(), 1 << 20);
  fs::remove(trace());
  fs::remove(index());
  {
    TraceWriter writer(trace(), *model_);
    Write(&writer, 100, 5000, 3);
  }
  WriteFile(index(), other_index);
  TraceReader reader(recording());
  EXPECT_EQ(reader.LastTick(), 5000u);
  ExpectSame(*reader.At(4000), MomentAt(4000, 3));
}

TEST_F(TraceReaderTest, IgnoresAnIndexThatIsLargerThanTheTrace) {
  WriteBranches();
  const std::uint64_t size = fs::file_size(trace());
  EXPECT_LT(TraceReader(recording()).bytes_read(), size);
  {
    AppendFile file(index(), AppendFile::kExisting);
    for (std::uint64_t place = size; file.size() <= size; ++place) {
      file.Append(BytesOf(TraceEntry{.place = place}));
    }
  }
  TraceReader reader(recording());
  EXPECT_GE(reader.bytes_read(), size);
  ExpectSame(*reader.Last(), MomentAt(3000, 2));
}

TEST_F(TraceReaderTest, ACutTraceEndsWithItsLastWholeRecord) {
  WriteBranches();
  const std::string whole = ReadFile(trace(), 1 << 24);
  // Within the last records, and before and after each entry of the index.
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t less = 1; less < 300; less += 7) sizes.push_back(whole.size() - less);
  const std::vector<TraceEntry> entries = TraceReader(recording()).index();
  for (const TraceEntry& entry : entries) {
    if (entry.tick == 100 || entry.kind == TraceEntry::Kind::kEvent) continue;
    for (const std::uint64_t more : {0, 1, 40}) sizes.push_back(entry.place + more);
  }
  for (const std::uint64_t size : sizes) {
    WriteFile(trace(), whole.substr(0, size));
    TraceReader reader(recording());
    const auto last = reader.LastTick();
    ASSERT_TRUE(last.has_value()) << size;
    EXPECT_LE(reader.size(), size);
    const std::vector<TraceTick> all = All(TraceReader(recording()));
    EXPECT_EQ(all.back().tick, *last);
    ExpectSame(*reader.Last(), all.back());
  }
}

TEST_F(TraceReaderTest, ReportsATraceThatBecameShorterWhileItWasRead) {
  {
    TraceWriter writer(trace(), *model_);
    Write(&writer, 0, 20'000);
  }
  TraceReader reader(recording());
  ASSERT_TRUE(reader.At(10).has_value());
  fs::resize_file(trace(), 100'000);
  EXPECT_THROW((void)reader.At(15'000), InputError);
  EXPECT_EQ(reader.At(11)->hash, MomentAt(11).hash);
}

TEST_F(TraceReaderTest, ReportsADamagedEventWheneverItsTickIsRead) {
  {
    TraceWriter writer(trace(), *model_);
    Write(&writer, 0, 5);
    writer.Add(Pointing("none"));
    Write(&writer, 6, 9);
  }
  TraceReader reader(recording());
  for (int i = 0; i < 3; ++i) EXPECT_THROW((void)reader.At(5), InputError);
  ExpectSame(*reader.At(4), MomentAt(4));
}

TEST_F(TraceReaderTest, AnEventHasTheTickBeforeIt) {
  TracePlace place = 0;
  {
    TraceWriter writer(trace(), *model_);
    Write(&writer, 0, 5);
    place = writer.place();
    writer.Add(Pointing("b1"));
  }
  ByteWriter other_tick;
  other_tick.Put(std::uint64_t{4});
  std::string text = ReadFile(trace(), 1 << 20);
  const auto bytes = other_tick.bytes();
  text.replace(place, bytes.size(), reinterpret_cast<const char*>(bytes.data()), bytes.size());
  WriteFile(trace(), text);
  fs::remove(index());
  EXPECT_THROW((void)TraceReader(recording()).At(5), InputError);
}

TEST_F(TraceReaderTest, StaysWhereItIsWhenTheLastTickCannotBeRead) {
  {
    TraceWriter writer(trace(), *model_);
    Write(&writer, 0, 50);
    Write(&writer, 52, 60);
  }
  TraceReader reader(recording());
  ExpectSame(*reader.At(10), MomentAt(10));
  EXPECT_THROW((void)reader.LastTick(), InputError);
  ExpectSame(*reader.Next(), MomentAt(11));
}

TEST_F(TraceReaderTest, RefusesKeyframesThatContradictTheTicksBeforeThem) {
  // The last keyframes would hide that time goes back, or further than there are records.
  for (const std::uint64_t again : {5, 90'000}) {
    for (const bool has_index : {true, false}) {
      fs::remove(trace());
      fs::remove(index());
      {
        TraceWriter writer(trace(), *model_);
        Write(&writer, 100, 1000);
        Write(&writer, again, again + 1000);
      }
      if (!has_index) fs::remove(index());
      EXPECT_THROW((void)TraceReader(recording()), InputError) << again << " " << has_index;
    }
  }
}

TEST_F(TraceReaderTest, ARecordContainsAnObjectOnce) {
  {
    TraceWriter writer(trace(), *model_);
    writer.Add(MomentAt(0));
  }
  // Otherwise a record of as many objects as there are could lack one, and be no keyframe.
  ByteWriter record;
  for (const std::uint64_t number : {1, 0}) record.Put(number);
  record.Put(std::uint8_t{0});
  record.Put(std::uint32_t{2});
  for (int i = 0; i < 2; ++i) {
    record.Put(std::uint32_t{3});
    record.Put(kIsPresent);
    for (const double number : {0, 0, 0, 1, 0, 0, 0}) record.Put(number);
  }
  AppendFile(trace(), AppendFile::kExisting).Append(record.bytes());
  TraceReader reader(recording());
  ExpectSame(*reader.Next(), MomentAt(0));
  EXPECT_THROW((void)reader.Next(), InputError);
}

TEST_F(TraceReaderTest, ADamagedIndexIsReadOrRefused) {
  WriteBranches();
  const std::vector<TraceTick> all = All(TraceReader(recording()));
  const std::string whole = ReadFile(index(), 1 << 20);
  int num_refused = 0;
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << place % 8));
    WriteFile(index(), damaged);
    try {
      TraceReader reader(recording());
      // Reading through needs no index but that of the returns.
      for (const std::uint64_t tick : {100, 1001, 2400})
        ExpectSame(*reader.At(tick), all[tick - 100]);
      (void)reader.Events();
    } catch (const InputError& error) {
      ++num_refused;
    }
  }
  EXPECT_GT(num_refused, 5);
}

}  // namespace
}  // namespace smile::recording

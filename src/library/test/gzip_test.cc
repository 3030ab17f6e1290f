#include "library/gzip.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

namespace smile::library {
namespace {

std::string Ungzipped(const std::string& file) {
  archive* in = archive_read_new();
  archive_read_support_filter_gzip(in);
  archive_read_support_format_raw(in);
  EXPECT_EQ(archive_read_open_memory(in, file.data(), file.size()), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  EXPECT_EQ(archive_read_next_header(in, &entry), ARCHIVE_OK);
  std::string bytes;
  char part[4096];
  for (la_ssize_t n = 0; (n = archive_read_data(in, part, sizeof part)) > 0;) {
    bytes.append(part, static_cast<std::size_t>(n));
  }
  archive_read_free(in);
  return bytes;
}

TEST(Gzip, KeepsAllBytesAndNoTime) {
  std::string bytes(100'000, 'a');
  for (std::size_t k = 0; k < bytes.size(); k += 3) bytes[k] = static_cast<char>(k);
  const std::string file = Gzipped(bytes);
  EXPECT_LT(file.size(), bytes.size() / 10);
  EXPECT_EQ(file.substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(file.substr(4, 4), std::string(4, '\0')) << "the time";
  EXPECT_EQ(Ungzipped(file), bytes);
  EXPECT_EQ(file, Gzipped(bytes));
}

}  // namespace
}  // namespace smile::library

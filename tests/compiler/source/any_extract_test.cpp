// Changed extracts: a short run of what fuzz_extract does for hours.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/mutated.h"
#include "tests/fuzz/read_extract.h"
#include "tests/test_files.h"

namespace citykiln::source {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The seeds of fuzz_extract, by name.
std::vector<std::filesystem::path> seed_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("tests/fuzz/seeds/extract")))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

TEST(AnyExtract, SeedsAreRead) {
  for (const std::filesystem::path& path : seed_files()) {
    Report report;
    const Result<OsmData> data = read_osm(path.string(), 1, report);
    ASSERT_TRUE(data) << to_string(data.error());
    EXPECT_FALSE(data->ways.empty()) << path;
  }
}

TEST(AnyExtract, ChangedBytesAreElementsOrOneErrorLine) {
  std::mt19937 chance{64};
  const int rounds = quick_or_full(100, 3000);
  for (const std::filesystem::path& path : seed_files()) {
    const std::string bytes = bytes_of(path), name = path.filename().string();
    for (int round = 0; round < rounds; ++round)
      ASSERT_EQ(fault_of_extract(name, mutated(bytes, chance)), "") << name << ", round " << round;
  }
}

}  // namespace
}  // namespace citykiln::source

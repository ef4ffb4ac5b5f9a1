// Changed specs: a short run of what fuzz_spec does for hours.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/mutated.h"
#include "tests/fuzz/read_any_spec.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

std::vector<std::string> seed_texts() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("tests/fuzz/seeds/spec"))) {
    std::ifstream file(entry.path(), std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  std::ranges::sort(texts);
  return texts;
}

TEST(AnySpec, ChangedTextsAreSettingsOrOneErrorLine) {
  std::mt19937 chance{64};
  const int rounds = quick_or_full(1000, 30'000);
  for (const std::string& text : seed_texts())
    for (int round = 0; round < rounds; ++round) {
      const std::string changed = mutated(text, chance);
      ASSERT_EQ(fault_of_spec(changed), "") << changed;
    }
}

}  // namespace
}  // namespace citykiln

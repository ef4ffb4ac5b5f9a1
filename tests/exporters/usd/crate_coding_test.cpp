#include "exporters/usd/crate_coding.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace citykiln::exporters {
namespace {

using Numbers = std::vector<std::int32_t>;

// Runs, small and large steps, and the ends of the range.
Numbers made_numbers(std::mt19937& dice, std::size_t count) {
  Numbers numbers;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t kind = dice() % 5;
    last += kind == 0   ? 1
            : kind == 1 ? dice() % 256 - 128
            : kind == 2 ? dice() % 65536 - 32768
            : kind == 3 ? dice()
                        : 0;
    numbers.push_back(static_cast<std::int32_t>(last));
  }
  return numbers;
}

TEST(CrateIntegers, AreWhatTheyWere) {
  std::mt19937 dice(3);
  for (std::size_t count = 0; count < 300; ++count) {
    const Numbers numbers = made_numbers(dice, count);
    const auto again = decompress_integers(compress_integers(numbers), count);
    ASSERT_TRUE(again);
    ASSERT_EQ(*again, numbers);
  }
  const Numbers ends = {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max(), -1, 0};
  EXPECT_EQ(*decompress_integers(compress_integers(ends), ends.size()), ends);
}

TEST(CrateIntegers, RunsTakeTwoBitsBeforeLz4) {
  const Numbers threes(100000, 3);
  EXPECT_LT(compress_integers(threes).size(), 200u);
}

TEST(CrateIntegers, AnotherCountIsAnError) {
  std::mt19937 dice(4);
  const Numbers numbers = made_numbers(dice, 100);
  const auto packed = compress_integers(numbers);
  for (const std::size_t count : {0, 50, 99, 105, 1000, 100000000})
    EXPECT_FALSE(decompress_integers(packed, static_cast<std::size_t>(count)));
  EXPECT_FALSE(decompress_integers({}, 1));
}

}  // namespace
}  // namespace citykiln::exporters

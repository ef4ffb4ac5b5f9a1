#include "exporters/usd/usd_value.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace citykiln::exporters {
namespace {

bool is_number(std::uint16_t bits) { return (bits & 0x7c00) != 0x7c00; }

TEST(UsdHalf, EveryNumberIsKept) {
  for (std::uint32_t bits = 0; bits < 65536; ++bits)
    if (const auto half = static_cast<std::uint16_t>(bits); is_number(half)) {
      ASSERT_EQ(half_bits(half_value(half)), half);
    }
}

TEST(UsdHalf, IsTheNearest) {
  std::mt19937 dice(1);
  for (int i = 0; i < 200000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(dice()));
    if (!(std::abs(value) < 65504)) continue;
    const std::uint16_t half = half_bits(value);
    const double error = std::abs(half_value(half) - static_cast<double>(value));
    for (const int step : {-1, 1}) {
      const auto other = static_cast<std::uint16_t>(half + step);
      if (!is_number(other)) continue;
      ASSERT_LE(error, std::abs(half_value(other) - static_cast<double>(value)));
    }
  }
}

TEST(UsdHalf, TiesAreEvenAndTooLargeIsInfinite) {
  EXPECT_EQ(half_bits(1 + 0x1p-11f), 0x3c00);
  EXPECT_EQ(half_bits(1 + 3 * 0x1p-11f), 0x3c02);
  EXPECT_EQ(half_bits(1e6f), 0x7c00);
  EXPECT_EQ(half_bits(-1e6f), 0xfc00);
}

}  // namespace
}  // namespace citykiln::exporters

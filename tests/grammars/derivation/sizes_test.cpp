#include "grammars/derivation/sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace citykiln::grammars {
namespace {

SizeItem item(SizeKind kind, double size, std::uint32_t leaf) { return {kind, size, leaf, {}}; }
SizeItem metres_of(double size, std::uint32_t leaf = 0) { return item(SizeKind::kAbsolute, size, leaf); }
SizeItem share(double size, std::uint32_t leaf = 0) { return item(SizeKind::kRelative, size, leaf); }
SizeItem floats(double size, std::uint32_t leaf = 0) { return item(SizeKind::kFloating, size, leaf); }
SizeItem repeat(std::vector<SizeItem> nested) { return {SizeKind::kRepeat, 0, 0, std::move(nested)}; }

// "0:2 1:3" is a piece of leaf 0, 2 m long, then one of leaf 1, 3 m long.
std::string divided(const std::vector<SizeItem>& items, double length_m) {
  const auto intervals = intervals_of(items, length_m, 10'000);
  if (!intervals) return "too many";
  std::string text;
  for (const Interval& interval : *intervals) {
    char piece[64];
    std::snprintf(piece, sizeof piece, "%s%u:%.4g", text.empty() ? "" : " ", interval.leaf,
                  interval.to_m - interval.from_m);
    text += piece;
  }
  return text;
}

TEST(Sizes, AbsoluteOnesAreKept) { EXPECT_EQ(divided({metres_of(2, 0), metres_of(3, 1)}, 10), "0:2 1:3"); }
TEST(Sizes, AbsoluteOnesAreCutAtTheEnd) { EXPECT_EQ(divided({metres_of(2, 0), metres_of(3, 1)}, 4), "0:2 1:2"); }
TEST(Sizes, RelativeOnesAreSharesOfTheWhole) { EXPECT_EQ(divided({share(0.2, 0), share(0.5, 1)}, 10), "0:2 1:5"); }

TEST(Sizes, FloatingOnesShareTheRestInProportion) {
  EXPECT_EQ(divided({metres_of(4, 0), floats(1, 1), floats(2, 2)}, 10), "0:4 1:2 2:4");
  EXPECT_EQ(divided({floats(1, 0), share(0.5, 1), floats(1, 2)}, 10), "0:2.5 1:5 2:2.5");
}

TEST(Sizes, FloatingOnesAreLeftOutWhereThereIsNoRest) {
  EXPECT_EQ(divided({metres_of(6, 0), floats(1, 1), metres_of(6, 2)}, 10), "0:6 2:4");
}

TEST(Sizes, ARepeatFitsTheNearestWholeNumber) {
  EXPECT_EQ(divided({repeat({floats(3)})}, 10), "0:3.333 0:3.333 0:3.333");
  EXPECT_EQ(divided({repeat({floats(4)})}, 10), "0:3.333 0:3.333 0:3.333");
  EXPECT_EQ(divided({repeat({floats(4.1)})}, 10), "0:5 0:5");
  EXPECT_EQ(divided({repeat({floats(30)})}, 10), "0:10");
}

TEST(Sizes, ARepeatThatDoesNotFitIsCutWhereNothingElseFillsTheRest) {
  EXPECT_EQ(divided({repeat({floats(1, 0), metres_of(2, 1)})}, 1.5), "1:1.5");
  EXPECT_EQ(divided({metres_of(1, 0), repeat({floats(1, 1), metres_of(2, 2)}), metres_of(1, 0)}, 3), "0:1 2:2");
  EXPECT_EQ(divided({floats(1, 0), repeat({floats(1, 1), metres_of(2, 2)})}, 1.5), "0:1.5");
}

TEST(Sizes, AFloatingOneOfZeroTakesWhatNoOtherDoes) {
  EXPECT_EQ(divided({metres_of(1, 0), floats(0, 1)}, 3), "0:1 1:2");
  EXPECT_EQ(divided({metres_of(1, 0), floats(0, 1), floats(2, 2)}, 3), "0:1 2:2");
}

TEST(Sizes, ARepeatWithoutFloatingOnesIsCutAtTheEnd) {
  EXPECT_EQ(divided({repeat({metres_of(4)})}, 10), "0:4 0:4 0:2");
  EXPECT_EQ(divided({repeat({metres_of(0.1)})}, 0.3), "0:0.1 0:0.1 0:0.1");
}

TEST(Sizes, ARepeatOfFixedOnesLeavesTheRestToThoseThatFloat) {
  EXPECT_EQ(divided({floats(1, 0), repeat({metres_of(3, 1)}), floats(1, 2)}, 10), "0:2 1:3 1:3 2:2");
}

TEST(Sizes, OnlyFloatingOnesOfARepeatStretch) {
  EXPECT_EQ(divided({repeat({floats(2, 0), metres_of(1, 1)})}, 10), "0:2.333 1:1 0:2.333 1:1 0:2.333 1:1");
}

TEST(Sizes, AllThatFloatsStretchesByOneFactor) {
  EXPECT_EQ(divided({floats(1, 0), repeat({floats(2, 1)}), floats(1, 2)}, 10.5),
            "0:1.05 1:2.1 1:2.1 1:2.1 1:2.1 2:1.05");
}

TEST(Sizes, ARepeatInARepeatFillsItsShareAnew) {
  EXPECT_EQ(divided({repeat({metres_of(1, 0), repeat({floats(2, 1)})})}, 12), "0:1 1:2 0:1 1:2 0:1 1:2 0:1 1:2");
}

TEST(Sizes, NothingBelowZeroNorThinnerThanASliver) {
  EXPECT_EQ(divided({metres_of(-3, 0), metres_of(1e-9, 1), floats(1, 2)}, 5), "2:5");
  EXPECT_EQ(divided({repeat({metres_of(0)})}, 5), "");
  EXPECT_EQ(divided({repeat({})}, 5), "");
}

TEST(Sizes, SayWhereThereAreTooMany) { EXPECT_EQ(divided({repeat({metres_of(1e-5)})}, 1e6), "too many"); }

struct AnySizes : testing::Test {
  std::mt19937 chance{7};
  double unit() { return static_cast<double>(chance() % 1000) / 1000; }

  std::vector<SizeItem> items(int depth) {
    std::vector<SizeItem> made;
    for (unsigned i = 0, n = 1 + chance() % 4; i < n; ++i) {
      const unsigned kind = chance() % (depth < 3 ? 4 : 3);
      if (kind == 3) {
        made.push_back(repeat(items(depth + 1)));
      } else {
        made.push_back(item(static_cast<SizeKind>(kind), kind == 1 ? unit() * 0.4 : unit() * 4, i));
      }
    }
    return made;
  }
};

bool holds_floats(const std::vector<SizeItem>& items) {
  for (const SizeItem& item : items)
    if (item.kind == SizeKind::kFloating && item.size > 0.01) return true;
  return false;
}

double fixed_of(const std::vector<SizeItem>& items, double whole_m) {
  double sum = 0;
  for (const SizeItem& item : items)
    sum += item.kind == SizeKind::kAbsolute ? item.size : item.kind == SizeKind::kRelative ? item.size * whole_m : 0;
  return sum;
}

TEST_F(AnySizes, CoverWithoutGapsAndNotBeyond) {
  std::size_t count = 0, filled = 0;
  for (int round = 0; round < 20'000; ++round) {
    const std::vector<SizeItem> sizes = items(0);
    const double length_m = 0.1 + unit() * 30;
    const auto intervals = intervals_of(sizes, length_m, 100'000);
    ASSERT_TRUE(intervals);
    double at_m = 0;
    for (const Interval& interval : *intervals) {
      ASSERT_EQ(interval.from_m, at_m);
      ASSERT_GE(interval.to_m - interval.from_m, kSliver_m / 2);
      at_m = interval.to_m;
    }
    count += intervals->size();
    ASSERT_LE(at_m, length_m);
    // floating sizes of the outermost list end at the end, exactly
    if (holds_floats(sizes) && fixed_of(sizes, length_m) < length_m - 0.01) {
      ASSERT_EQ(at_m, length_m) << "round " << round;
      ++filled;
    }
  }
  EXPECT_GT(count, 50'000u);
  EXPECT_GT(filled, 2'000u);
}

TEST_F(AnySizes, FloatingOnesKeepTheirRatio) {
  for (int round = 0; round < 5000; ++round) {
    const double a = 0.1 + unit(), b = 0.1 + unit(), fixed = unit() * 3;
    const auto intervals = intervals_of(std::vector{floats(a, 0), metres_of(fixed + 0.1, 1), floats(b, 2)}, 10, 100);
    ASSERT_TRUE(intervals);
    ASSERT_EQ(intervals->size(), 3u);
    const double first = intervals->at(0).to_m, last = 10 - intervals->at(2).from_m;
    ASSERT_NEAR(first * b, last * a, 1e-9);
  }
}

TEST_F(AnySizes, RepeatsStretchLessThanByHalf) {
  for (int round = 0; round < 5000; ++round) {
    const double wish = 0.5 + unit() * 3, length_m = wish + unit() * 30;
    const auto intervals = intervals_of(std::vector{repeat({floats(wish)})}, length_m, 1000);
    ASSERT_TRUE(intervals && !intervals->empty());
    const double got = intervals->front().to_m;
    ASSERT_GE(got, wish / 1.5 - 1e-9);
    ASSERT_LE(got, wish * 1.5 + 1e-9);
  }
}

}  // namespace
}  // namespace citykiln::grammars

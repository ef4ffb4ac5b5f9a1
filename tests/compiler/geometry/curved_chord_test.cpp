#include "compiler/geometry/curved_chord.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln {
namespace {

struct RandomChord {
  Vec2 a, b;
  CurvedChord chord;
  CurveLimits limits;
};

RandomChord random_chord(std::uint32_t i) {
  const RandomSequence draws(7, StableId{i}, "chord");
  RandomChord made;
  made.a = snapped_to(kCurveStep_m, {draws.between(-500, 500, 0), draws.between(-500, 500, 1)});
  const double long_m = std::pow(2.0, draws.between(0, 8, 2)), angle_deg = draws.between(0, 360, 3);
  made.b = snapped_to(kCurveStep_m, made.a + Vec2{cosine(angle_deg), sine(angle_deg)} * long_m);
  made.limits = {.most_m = std::min(0.12 * long_m, draws.between(0.1, 3, 4)), .reach_m = 60};
  const auto slope = [&](std::uint32_t n) {
    return draws.below(4, n + 10) == 0 ? 0 : static_cast<int>(draws.below(79, n)) - 39;
  };
  made.chord = fitted_chord(distance(made.a, made.b), slope(5), slope(6), made.limits);
  return made;
}

Polyline line_of(const RandomChord& r) {
  Polyline line = {r.a};
  for (const Vec2 p : points_between(r.chord, r.a, r.b)) line.push_back(p);
  line.push_back(r.b);
  return line;
}

TEST(CurvedChord, WithoutSlopesHasNoPoints) {
  const CurvedChord straight = fitted_chord(50, 0, 0, {.most_m = 1, .reach_m = 40});
  EXPECT_EQ(straight, CurvedChord{});
  EXPECT_TRUE(points_between(straight, {0, 0}, {50, 0}).empty());
}

TEST(CurvedChord, KeepsToItsLargestDistance) {
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const RandomChord r = random_chord(i);
    for (const Vec2 p : points_between(r.chord, r.a, r.b))
      EXPECT_LE(distance_to_segment(r.a, r.b, p), r.limits.most_m * 1.02 + kCurveStep_m) << i;
  }
}

TEST(CurvedChord, ReversedHasTheSamePoints) {
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const RandomChord r = random_chord(i);
    Polyline back = points_between(reversed(r.chord), r.b, r.a);
    std::ranges::reverse(back);
    EXPECT_EQ(points_between(r.chord, r.a, r.b), back) << i;
  }
}

TEST(CurvedChord, NeverTurnsBack) {
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const RandomChord r = random_chord(i);
    const Polyline line = line_of(r);
    for (std::size_t p = 1; p < line.size(); ++p) EXPECT_GT(dot(line[p] - line[p - 1], r.b - r.a), 0) << i;
  }
}

TEST(CurvedChord, LeavesAndArrivesWithItsSlopes) {
  const CurvedChord arc = fitted_chord(20, -13, 13, {.most_m = 1.1, .reach_m = 40});
  EXPECT_NEAR(offset_at(arc, 1e-4) / 1e-4, -13.0 / 64, 1e-3);
  EXPECT_NEAR(offset_at(arc, 1 - 1e-4) / -1e-4, 13.0 / 64, 1e-3);
  // the middle of an arc of 2 x 11.5 degrees
  EXPECT_NEAR(offset_at(arc, 0.5) * 20, -1.0, 0.06);
}

TEST(CurvedChord, AnArcOfATownTurnsByLessThanTenDegreesAtItsPoints) {
  const Polyline inner = points_between(fitted_chord(20, -13, 13, {.most_m = 1.1, .reach_m = 40}), {0, 0}, {20, 0});
  Polyline line = {{0, 0}};
  line.insert(line.end(), inner.begin(), inner.end());
  line.push_back({20, 0});
  for (std::size_t p = 1; p + 1 < line.size(); ++p) {
    const Vec2 in = line[p] - line[p - 1], out = line[p + 1] - line[p];
    EXPECT_LT(std::abs(arctangent2_deg(cross(in, out), dot(in, out))), 10);
  }
  EXPECT_LE(line.size(), 7u);
}

TEST(CurvedChord, IsFoundByItsPoints) {
  int found = 0, curves = 0;
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const RandomChord r = random_chord(i);
    const Polyline line = line_of(r);
    if (line.size() < 3 || distance(r.a, r.b) < 4) continue;
    const std::optional<CurvedChord> chord = chord_through(line);
    ++curves, found += chord.has_value();
    if (chord) {
      EXPECT_EQ(points_between(*chord, r.a, r.b), Polyline(line.begin() + 1, line.end() - 1)) << i;
    }
  }
  EXPECT_GT(found, 0.97 * curves) << curves;
}

TEST(CurvedChord, IsNotFoundInOtherLines) {
  EXPECT_FALSE(chord_through(Polyline{{0, 0}, {10, 5}, {20, -3}, {30, 0}}));
  EXPECT_FALSE(chord_through(Polyline{{0, 0}, {10, 5}, {0, 0}}));
}

}  // namespace
}  // namespace citykiln

#include "grammars/derivation/displacement.h"

#include <gtest/gtest.h>

namespace citykiln::grammars {
namespace {

const Ring3 kNear = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const Ring3 kBeside = {{1, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}};

ChildTrace kept(Displacement before, Displacement own, std::uint32_t group = 0) {
  return {before, own, false, group, true, kNear};
}
ChildTrace gone(Displacement before, std::uint32_t group = 0) { return {before, {}, true, group, true, kBeside}; }

TEST(Displacement, StepsAddUpEachWay) {
  const Displacement sum = Displacement{1, 2} + Displacement{3, 5};
  EXPECT_EQ(sum.to_earlier_m, 4);
  EXPECT_EQ(sum.to_later_m, 7);
  EXPECT_EQ(sum.largest_m(), 7);
}

TEST(Displacement, OfANodeIsItsChildrensWorst) {
  const NodeTrace node = combine(std::vector{kept({1, 2}, {0.5, 0.25}), kept({0, 0}, {3, 4})});
  EXPECT_EQ(node.moved.to_earlier_m, 3);
  EXPECT_EQ(node.moved.to_later_m, 4);
  EXPECT_FALSE(node.vanished);
}

TEST(Displacement, AnyGroupThatCoversTheNodeWillDo) {
  const NodeTrace node = combine(std::vector{kept({5, 5}, {0, 0}, 0), kept({0, 0}, {0, 1}, 1)});
  EXPECT_EQ(node.moved.to_earlier_m, 5);
  EXPECT_EQ(node.moved.to_later_m, 1);
}

TEST(Displacement, WhatVanishedIsAsFarAsItsFarthestCornerFromASibling) {
  const NodeTrace node = combine(std::vector{kept({0, 0}, {0, 0.5}), gone({0, 0})});
  // from x = 3 to the sibling's edge at x = 1, then to the sibling's result
  EXPECT_DOUBLE_EQ(node.moved.to_later_m, 2.5);
}

TEST(Displacement, WhatVanishedBeforeAFaceIsAsFarAsItIsBefore) {
  ChildTrace before_it = gone({0, 0});
  before_it.vertices = {{0, 0, 0.25}, {1, 0, 0.25}, {1, 1, 0.25}, {0, 1, 0.25}};
  EXPECT_DOUBLE_EQ(combine(std::vector{kept({0, 0}, {0, 0}), before_it}).moved.to_later_m, 0.25);
}

TEST(Displacement, AConcaveFaceIsMeasuredToItsEdges) {
  // the corners of the vanished child are on the border of the L, its middle is 3 m from it
  ChildTrace l = kept({0, 0}, {0, 0}), in_notch = gone({0, 0});
  l.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {1, 1, 0}, {1, 10, 0}, {0, 10, 0}};
  in_notch.vertices = {{1, 1, 0}, {10, 1, 0}, {1, 10, 0}};
  EXPECT_GE(combine(std::vector{l, in_notch}).moved.to_later_m, 3);
}

// Only the 256 siblings on each side are tried.
TEST(Displacement, WhatVanishedAsksTheSiblingsNextToIt) {
  std::vector<ChildTrace> children(5000, gone({0, 0}));
  for (const std::size_t i : {0, 400, 800}) children[i] = kept({0, 0}, {0, 0.5});
  EXPECT_EQ(combine(children).moved.to_later_m, kUnbounded_m);
  children.resize(1000);
  EXPECT_DOUBLE_EQ(combine(children).moved.to_later_m, 2.5);
}

TEST(Displacement, WithoutSurvivorsTheNodeVanishes) {
  EXPECT_TRUE(combine(std::vector{gone({0, 0}), gone({1, 1})}).vanished);
  EXPECT_TRUE(combine({}).vanished);
}

TEST(Displacement, BetweenAnySurfacesIsTheLargestOfTheirCorners) {
  EXPECT_DOUBLE_EQ(any_displacement(kNear, kBeside).to_earlier_m, std::sqrt(10.0));
  EXPECT_EQ(any_displacement(kNear, {}).to_later_m, kUnbounded_m);
}

}  // namespace
}  // namespace citykiln::grammars

#include "lsystems/weber_penn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/test_files.h"

namespace citykiln::lsystems {
namespace {

TreeParameters tree_of(const std::string& text) {
  Result<TreeParameters> tree = read_weber_penn(text, "x.tree");
  EXPECT_TRUE(tree) << to_string(tree.error());
  return tree ? *tree : TreeParameters{};
}

std::string tree_error_of(const std::string& text) {
  const Result<TreeParameters> tree = read_weber_penn(text, "x.tree");
  return tree ? "" : to_string(tree.error());
}

TreeParameters published(const std::string& name) {
  std::ifstream file(source_file("lsystems/weber_penn/" + name + ".tree"));
  return tree_of({std::istreambuf_iterator<char>(file), {}});
}

// A stem of a skeleton without clones: its first segment, their number, and its length.
struct GrownStem {
  const Segment* first;
  int segments;
  double length_m;
};

std::vector<GrownStem> stems_of(const Skeleton& skeleton, int order) {
  std::vector<GrownStem> stems;
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const Segment& segment = skeleton.segments[i];
    if (segment.order != order) continue;
    const bool goes_on = segment.parent != kNoParent && skeleton.segments[segment.parent].order == order;
    if (!goes_on) stems.push_back({&segment, 0, 0});
    ++stems.back().segments, stems.back().length_m += segment.length;
  }
  return stems;
}

// The aspen of the paper: Scale 13, BaseSize 0.4, Ratio 0.015, tend flame; 50 branches of 0.3, 30 twigs of 0.6.
TEST(WeberPenn, AnAspensTrunkHasThePapersSize) {
  const Skeleton aspen = grow_tree(published("quaking_aspen"), 0).skeleton;
  const std::vector<GrownStem> trunk = stems_of(aspen, 0);
  ASSERT_EQ(trunk.size(), 1u);
  EXPECT_EQ(trunk[0].segments, 3);
  EXPECT_NEAR(trunk[0].length_m, 13, 1e-9);
  EXPECT_NEAR(trunk[0].first->start_radius, 0.195, 1e-9);  // 13 · 0.015
}

TEST(WeberPenn, AnAspensBranchesHaveThePapersNumberAndLengths) {
  const Skeleton aspen = grow_tree(published("quaking_aspen"), 0).skeleton;
  const std::vector<GrownStem> branches = stems_of(aspen, 1);
  ASSERT_EQ(branches.size(), 50u);
  // the lowest is 5.2 + 7.8 / 100 = 5.278 m above the foot: ratio 0.99, 13 · 0.3 · (0.5 + 0.5 · 0.01 / 0.3) m
  EXPECT_NEAR(branches[0].length_m, 2.015, 1e-9);
  // its radius: 0.195 · (2.015 / 13)^1.2 m
  EXPECT_NEAR(branches[0].first->start_radius, 0.195 * std::pow(2.015 / 13, 1.2), 1e-9);
  // the 16th is at 5.2 + 15.5 · 0.156 = 7.618 m: ratio 0.69, in the upper part: 13 · 0.3 · (0.5 + 0.5 · 0.69 / 0.7) m
  EXPECT_NEAR(branches[15].length_m, 3.9 * (0.5 + 0.5 * 0.69 / 0.7), 1e-9);
  for (const GrownStem& branch : branches) EXPECT_EQ(branch.segments, 5);
}

TEST(WeberPenn, AnAspensTwigsAndLeavesHaveThePapersNumbers) {
  const GrownTree aspen = grow_tree(published("quaking_aspen"), 0);
  const std::vector<GrownStem> twigs = stems_of(aspen.skeleton, 2);
  // the mean of tend flame over the crown is 0.75: 50 · 30 · (0.2 + 0.8 · 0.75)
  EXPECT_NEAR(static_cast<double>(twigs.size()), 1200, 15);
  // 30 · (0.2 + 0.8 · 0.51667) = 18.4: the first twig is 2.015 / 36 m from the trunk, 0.6 · (2.015 - 0.6 · 0.05597) m
  // long
  EXPECT_NEAR(twigs[0].length_m, 0.6 * (2.015 - 0.6 * 2.015 / 36), 1e-9);
  // leaves: 25 · (0.5 + 0.5 · offset), by three on a card: 18.75 leaves in the mean, 6.25 cards
  EXPECT_NEAR(static_cast<double>(aspen.skeleton.instances.size()) / static_cast<double>(twigs.size()), 6.25, 0.1);
}

TEST(WeberPenn, LevelThreeThinsOutAlongItsParent) {
  // one branch, one twig on it in the middle, 8 stems on the twig: 8 · (1 - 0.5 · 0.5)
  const TreeParameters tree = tree_of(
      "Shape = 3\nLevels = 4\nScale = 10\n1Branches = 1\n1Length = 0.5\n2Branches = 1\n2Length = 0.5\n3Branches = 8\n"
      "3Length = 0.2\n");
  const Skeleton skeleton = grow_tree(tree, 0).skeleton;
  EXPECT_EQ(stems_of(skeleton, 1).size(), 1u);
  EXPECT_NEAR(stems_of(skeleton, 1)[0].length_m, 5, 1e-9);
  // 0.5 · (5 - 0.6 · 2.5)
  EXPECT_NEAR(stems_of(skeleton, 2)[0].length_m, 1.75, 1e-9);
  EXPECT_EQ(stems_of(skeleton, 3).size(), 6u);
}

TEST(WeberPenn, DownAnglesFollowTheHeight) {
  const TreeParameters tree =
      tree_of("Levels = 2\nScale = 10\n1Branches = 10\n1DownAngle = 60\n1DownAngleV = -50\n1Length = 0.3\n");
  const Skeleton skeleton = grow_tree(tree, 0).skeleton;
  const auto declination_deg = [](const GrownStem& stem) {
    return std::acos(stem.first->start.heading.z) * 180 / 3.14159265358979;
  };
  const std::vector<GrownStem> branches = stems_of(skeleton, 1);
  ASSERT_EQ(branches.size(), 10u);
  // at 0.95 of the height above: 60 - 50 · (1 - 2 · (0.2 + 0.8 · 0.95)); at 0.05: 60 - 50 · (1 - 2 · 0.24)
  EXPECT_NEAR(declination_deg(branches[0]), 106, 1e-6);
  EXPECT_NEAR(declination_deg(branches[9]), 34, 1e-6);
}

TEST(WeberPenn, ClonesShareTheSubstemsOfTheirStem) {
  const std::string text = "Levels = 2\nScale = 10\n0CurveRes = 4\n1Branches = 60\n1Length = 0.2\n1CurveRes = 1\n";
  const auto branches_of = [](const Skeleton& skeleton) {
    return std::ranges::count_if(skeleton.segments,
                                 [](const Segment& segment) { return std::abs(segment.length - 2.5) > 1e-9; });
  };
  EXPECT_EQ(branches_of(grow_tree(tree_of(text), 1).skeleton), 60);
  const Skeleton split = grow_tree(tree_of(text + "0BaseSplits = 2\n0SplitAngle = 25\n"), 1).skeleton;
  // one segment below, and three axes of three segments
  EXPECT_EQ(split.segments.size() - static_cast<std::size_t>(branches_of(split)), 10u);
  EXPECT_NEAR(static_cast<double>(branches_of(split)), 60, 3);
}

TEST(WeberPenn, PrunedStemsStayInTheEnvelope) {
  const TreeParameters willow = published("weeping_willow");
  const double scale_m = willow.scale;
  for (const Segment& segment : grow_tree(willow, 0).skeleton.segments)
    EXPECT_TRUE(segment.order == 0 || length(in_plan(segment.end().at)) < 1.6 * willow.prune_width * scale_m);
  TreeParameters wild = willow;
  wild.prune_ratio = 0;
  double widest_m = 0;
  for (const Segment& segment : grow_tree(wild, 0).skeleton.segments)
    widest_m = std::max(widest_m, length(in_plan(segment.end().at)));
  EXPECT_GT(widest_m, 1.6 * willow.prune_width * scale_m);
}

TEST(WeberPenn, AttractionTurnsTwigsUpOrDown) {
  const auto mean_rise = [](double attraction) {
    TreeParameters tree = published("quaking_aspen");
    tree.attraction_up = attraction;
    double sum = 0;
    const std::vector<Segment> segments = grow_tree(tree, 0).skeleton.segments;
    for (const Segment& segment : segments) sum += segment.order == 2 ? segment.start.heading.z : 0;
    return sum / static_cast<double>(segments.size());
  };
  EXPECT_GT(mean_rise(2), mean_rise(0) + 0.05);
  EXPECT_LT(mean_rise(-2), mean_rise(0) - 0.05);
}

TEST(WeberPenn, ATreeIsAFunctionOfItsSeed) {
  for (const char* name : {"quaking_aspen", "black_tupelo", "weeping_willow", "black_oak"}) {
    const TreeParameters tree = published(name);
    const Skeleton a = grow_tree(tree, 3).skeleton, b = grow_tree(tree, 3).skeleton,
                   other = grow_tree(tree, 4).skeleton;
    ASSERT_EQ(a.segments.size(), b.segments.size()) << name;
    for (std::size_t i = 0; i < a.segments.size(); ++i) ASSERT_EQ(a.segments[i].start.at, b.segments[i].start.at);
    EXPECT_NE(a.segments.back().start.at, other.segments.back().start.at) << name;
  }
}

TEST(WeberPenn, TreesAreBounded) {
  const std::string three = "Levels = 4\n1Branches = 1000\n2Branches = 1000\n3Branches = 1000\n";
  EXPECT_EQ(tree_error_of(three), "x.tree:4:1: expected at most 4000000 stems, found parameters for 1001001001");
  const GrownTree large = grow_tree(tree_of("Levels = 2\n1Branches = 100000\n1CurveRes = 64\n"), 0);
  EXPECT_TRUE(large.stopped);
  EXPECT_LE(large.skeleton.segments.size(), kMostPlantParts);
  EXPECT_FALSE(grow_tree(published("weeping_willow"), 0).stopped);
  // clones double with each of 63 segments
  EXPECT_TRUE(grow_tree(tree_of("Levels = 1\n0CurveRes = 64\n0SegSplits = 1\n"), 0).stopped);
}

TEST(ReadWeberPenn, ErrorsHaveOneLineWithTheirPlace) {
  EXPECT_EQ(tree_error_of("Scale = 10\n  1DownAngel = 3\n"),
            "x.tree:2:3: expected a parameter of Weber and Penn, such as Scale or 1DownAngle, found '1DownAngel'");
  EXPECT_EQ(tree_error_of("Scale 10"), "x.tree:1:1: expected 'name = value', found 'Scale 10'");
  EXPECT_EQ(tree_error_of("Shape = 9"), "x.tree:1:1: Shape: expected a whole number from 0 to 8, found '9'");
  EXPECT_EQ(tree_error_of("Shape = 1.5"), "x.tree:1:1: Shape: expected a whole number from 0 to 8, found '1.5'");
  EXPECT_EQ(tree_error_of("Scale = tall"), "x.tree:1:1: Scale: expected a number from 0.05 to 100, found 'tall'");
  EXPECT_EQ(tree_error_of("Scale = nan"), "x.tree:1:1: Scale: expected a number from 0.05 to 100, found 'nan'");
  EXPECT_EQ(tree_error_of("Scale = 3\nScale = 4"), "x.tree:2:1: 'Scale' is given twice");
  EXPECT_EQ(tree_error_of("4Length = 1"),
            "x.tree:1:1: expected a parameter of Weber and Penn, such as Scale or 1DownAngle, found '4Length'");
  EXPECT_EQ(tree_error_of("# a comment\n\nLeaf = poplar_leaf # its picture\n"), "");
}

}  // namespace
}  // namespace citykiln::lsystems

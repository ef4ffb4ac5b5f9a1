#include "compiler/ground/water/descending_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::ground {
namespace {

// A tree: each node flows into one with a lower number.
FlowGraph random_tree(std::uint64_t seed, std::uint32_t count) {
  const RandomSequence draw(seed, StableId{1}, "tree");
  FlowGraph flow{{}, std::vector<std::vector<std::uint32_t>>(count), std::vector<bool>(count, false)};
  for (std::uint32_t i = 0; i < count; ++i) {
    flow.given.push_back({{1.0 * draw.below(6, 3 * i), 1 + draw.below(4, 3 * i + 1), 1 + draw.below(9, 3 * i + 1)}});
    if (i > 0) flow.downstream[i] = {draw.below(i, 3 * i + 2)};
  }
  return flow;
}

double cost(const FlowGraph& flow, const std::vector<double>& heights) {
  double sum = 0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    for (const WeightedHeight& p : flow.given[i])
      sum += std::max(0.0, p.height_m - heights[i]) * static_cast<double>(p.below) +
             std::max(0.0, heights[i] - p.height_m) * static_cast<double>(p.above);
  return sum;
}

bool descends(const FlowGraph& flow, const std::vector<double>& heights) {
  for (std::size_t i = 0; i < heights.size(); ++i)
    for (const std::uint32_t d : flow.downstream[i])
      if (heights[d] > heights[i]) return false;
  return true;
}

TEST(DescendingFit, CostsNoMoreThanAnyOther) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const FlowGraph flow = random_tree(seed, 6);
    const std::vector<double> fit = fit_descending(flow);
    ASSERT_EQ(fit.size(), 6u);
    ASSERT_TRUE(descends(flow, fit));
    // the heights of a best fit are among those given
    std::vector<double> heights(6, 0);
    for (int code = 0; code < 6 * 6 * 6 * 6 * 6 * 6; ++code) {
      for (int i = 0, rest = code; i < 6; ++i, rest /= 6) heights[static_cast<std::size_t>(i)] = rest % 6;
      if (descends(flow, heights)) {
        ASSERT_LE(cost(flow, fit), cost(flow, heights)) << seed;
      }
    }
  }
}

TEST(DescendingFit, FallsWhereRiversPart) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    FlowGraph flow = random_tree(seed, 60);
    const RandomSequence draw(seed, StableId{2}, "arms");
    for (std::uint32_t i = 1; i < 60; ++i) {
      flow.downstream[i].push_back(draw.below(i, 2 * i));
      flow.given[i][0].height_m -= 3;
      flow.is_sea[i] = draw.below(10, 2 * i + 1) == 0;
      if (flow.is_sea[i]) flow.given[i] = {{0, 1 << 20, 1 << 20}};
    }
    const std::vector<double> fit = fit_descending(flow);
    ASSERT_EQ(fit.size(), 60u);
    EXPECT_TRUE(descends(flow, fit));
    for (std::uint32_t i = 0; i < 60; ++i)
      if (flow.is_sea[i]) {
        EXPECT_EQ(fit[i], 0);
      }
  }
}

}  // namespace
}  // namespace citykiln::ground

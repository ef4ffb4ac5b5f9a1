// Whittaker (1923) smoothing on a graph, with Cauchy's weights (Holland and Welsch 1977); windows are blended by a
// partition of unity (Babuska and Melenk 1997) instead of solving one system.
#include "compiler/ground/profiles/smoothing/smooth_profile.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <compare>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/profiles/graph/grade_rules.h"

namespace citykiln::ground {
namespace {

/// Share of the terrain's step below which there is only noise and the triangles of the grid.
constexpr double kStepShare = 0.75;
/// Rounds of reweighting.
constexpr int kReweightingRounds = 2;
constexpr double kOffGround = 0.05, kPinned = 1e4;

// The bending of a line that continues through a node: cost (a z_from + b z_node + c z_to)².
struct NodeBend {
  std::uint32_t from = 0, node = 0, to = 0;
  double a = 0, b = 0, c = 0;
};

// Lines off the ground have no noise of the terrain.
double smooth_m_of(const ProfileGraph& graph, const Leg& leg, double least_m) {
  const GraphWay& way = graph.ways[leg.way];
  return std::max(grade_rule_of(way.track->surface).smooth_m, way.road == kNone ? 0 : least_m);
}

NodeBend node_bend_of(const ProfileGraph& graph, std::uint32_t node, const Leg& from, const Leg& to, double least_m) {
  // shorter legs would have weights beyond rounding
  constexpr double kShortest_m = 0.5;
  const double h1 = std::max(from.length_m, kShortest_m), h2 = std::max(to.length_m, kShortest_m);
  const double smooth_m = std::min(smooth_m_of(graph, from, least_m), smooth_m_of(graph, to, least_m));
  const double root = smooth_m * smooth_m * std::sqrt((h1 + h2) / 2);
  const double a = root * 2 / (h1 * (h1 + h2)), c = root * 2 / (h2 * (h1 + h2));
  return {from.to, node, to.to, a, -(a + c), c};
}

// Returns the leg in which a line along `leg` continues: the only other one, or the straightest; kNone if none.
std::uint32_t goes_on_in(const ProfileGraph& graph, std::uint32_t node, std::uint32_t leg) {
  constexpr double kStraight = -0.5;
  const std::span<const Leg> legs = graph.legs_of(node);
  if (legs.size() == 2) return 1 - leg;
  const auto direction = [&](const Leg& l) { return unit(graph.nodes[l.to].at - graph.nodes[node].at); };
  std::uint32_t best = kNone;
  double straightest = kStraight;
  for (std::uint32_t other = 0; other < legs.size(); ++other) {
    const double turn = dot(direction(legs[leg]), direction(legs[other]));
    if (other != leg && turn < straightest) best = other, straightest = turn;
  }
  return best;
}

void add_bends_at_node(const ProfileGraph& graph, std::uint32_t node, double least_m, std::vector<NodeBend>& bends) {
  const std::span<const Leg> legs = graph.legs_of(node);
  for (std::uint32_t leg = 0; legs.size() > 1 && leg < legs.size(); ++leg) {
    const std::uint32_t other = goes_on_in(graph, node, leg);
    // a pair that chooses each other is added once
    if (other == kNone || (other < leg && goes_on_in(graph, node, other) == leg)) continue;
    if (legs[leg].to != legs[other].to) bends.push_back(node_bend_of(graph, node, legs[leg], legs[other], least_m));
  }
}

struct Cell {
  int x = 0, y = 0;
  auto operator<=>(const Cell&) const = default;
};

// Nodes by squares of half a window, which is also at least the halo and the blending together.
struct Bins {
  static constexpr double kBin_m = kWindow_m / 2;
  static_assert(kWindowBlend_m + kHalo_m <= kBin_m);
  std::vector<std::pair<Cell, std::uint32_t>> entries;

  explicit Bins(const ProfileGraph& graph) {
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
      const Vec2 at = graph.nodes[n].at;
      entries.push_back(
          {{static_cast<int>(std::floor(at.x / kBin_m)), static_cast<int>(std::floor(at.y / kBin_m))}, n});
    }
    std::ranges::sort(entries);
  }

  /// Returns the nodes of a window and one square about it, sorted.
  void gather(Cell square, std::vector<std::uint32_t>& nodes) const {
    nodes.clear();
    for (int x = 2 * square.x - 1; x <= 2 * square.x + 2; ++x) {
      auto entry = std::ranges::lower_bound(entries, std::pair(Cell{x, 2 * square.y - 1}, 0u));
      for (; entry != entries.end() && entry->first <= Cell{x, 2 * square.y + 2}; ++entry)
        nodes.push_back(entry->second);
    }
    std::ranges::sort(nodes);
  }

  /// Returns all windows that hold a node or blend into one that does, sorted.
  std::vector<Cell> squares() const {
    std::vector<Cell> squares;
    for (const auto& [bin, node] : entries)
      for (int dx = -1; dx <= 1; dx += 2)
        for (int dy = -1; dy <= 1; dy += 2) squares.push_back({(bin.x + dx) >> 1, (bin.y + dy) >> 1});
    sort_unique(squares);
    return squares;
  }
};

// The weight of a window at a place: 1 inside, 0 outside, linear across its borders.
double window_share_along(int square, double v) {
  const double inside_m = std::min(v - square * kWindow_m, (square + 1) * kWindow_m - v);
  return std::clamp((inside_m + kWindowBlend_m) / (2 * kWindowBlend_m), 0.0, 1.0);
}
double window_share(Cell square, Vec2 at) {
  return window_share_along(square.x, at.x) * window_share_along(square.y, at.y);
}

struct Smoother {
  const ProfileGraph& graph;
  std::span<const double> data_m;
  double least_m;                              // smoothing length on the ground
  std::vector<NodeBend> bends = {};            // by node
  std::vector<std::uint32_t> first_bend = {};  // of each node, and the end
  std::vector<double> run_m = {};              // length of line that each node stands for
  std::vector<std::uint32_t> local = {};       // number within the current window, kNone outside
  std::vector<double> weighted_m = {}, share = {};

  void prepare();
  void solve(Cell square, std::span<const std::uint32_t> nodes);
  double weight_of(std::uint32_t node) const;
};

void Smoother::prepare() {
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    first_bend.push_back(static_cast<std::uint32_t>(bends.size()));
    add_bends_at_node(graph, n, least_m, bends);
    double sum_m = 0;
    for (const Leg& leg : graph.legs_of(n)) sum_m += leg.length_m / 2;
    run_m.push_back(std::max(sum_m, 0.5));
  }
  first_bend.push_back(static_cast<std::uint32_t>(bends.size()));
  local.assign(graph.nodes.size(), kNone);
  weighted_m.assign(graph.nodes.size(), 0);
  share.assign(graph.nodes.size(), 0);
}

double Smoother::weight_of(std::uint32_t node) const {
  const GraphNode& n = graph.nodes[node];
  return run_m[node] * (n.is_pinned ? kPinned : n.is_on_ground ? 1 : kOffGround);
}

using Matrix = Eigen::SparseMatrix<double>;

void Smoother::solve(Cell square, std::span<const std::uint32_t> nodes) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  const double level_m = data_m[nodes.front()];
  const bool is_level = std::ranges::all_of(nodes, [&](std::uint32_t n) { return data_m[n] == level_m; });
  Eigen::VectorXd z = Eigen::VectorXd::Constant(count, 0);
  if (!is_level) {
    for (std::uint32_t i = 0; i < nodes.size(); ++i) local[nodes[i]] = i;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::uint32_t i, std::uint32_t j, double v) {
      entries.emplace_back(static_cast<int>(std::max(i, j)), static_cast<int>(std::min(i, j)), v);
    };
    for (const std::uint32_t node : nodes) {
      add(local[node], local[node], 0);
      for (std::uint32_t b = first_bend[node]; b < first_bend[node + 1]; ++b) {
        const NodeBend& bend = bends[b];
        const std::uint32_t i = local[bend.from], j = local[bend.node], k = local[bend.to];
        if (i == kNone || k == kNone) continue;
        add(i, i, bend.a * bend.a), add(j, j, bend.b * bend.b), add(k, k, bend.c * bend.c);
        add(i, j, bend.a * bend.b), add(j, k, bend.b * bend.c), add(i, k, bend.a * bend.c);
      }
    }
    Matrix stiff(count, count);
    stiff.setFromTriplets(entries.begin(), entries.end());
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver;
    solver.analyzePattern(stiff);
    Eigen::VectorXd weight(count), data(count), bending = stiff.diagonal();
    for (Eigen::Index i = 0; i < count; ++i) {
      weight[i] = weight_of(nodes[static_cast<std::size_t>(i)]);
      data[i] = data_m[nodes[static_cast<std::size_t>(i)]] - level_m;
    }
    Eigen::VectorXd doubted = weight;
    for (int round = 0; round <= kReweightingRounds; ++round) {
      for (Eigen::Index i = 0; i < count; ++i) stiff.coeffRef(i, i) = bending[i] + doubted[i];
      solver.factorize(stiff);
      z = solver.solve(doubted.cwiseProduct(data));
      for (Eigen::Index i = 0; i < count; ++i) {
        const double miss = (z[i] - data[i]) / kRobustScale_m;
        doubted[i] = weight[i] / (1 + miss * miss);
      }
    }
    for (const std::uint32_t node : nodes) local[node] = kNone;
  }
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const double part = window_share(square, graph.nodes[nodes[i]].at);
    weighted_m[nodes[i]] += part * (z[i] + level_m);
    share[nodes[i]] += part;
  }
}

}  // namespace

std::vector<double> smooth_heights(const ProfileGraph& graph, std::span<const double> data_m, double step_m) {
  assert(data_m.size() == graph.nodes.size() && step_m > 0);
  // level terrain: every window would return it unchanged
  if (std::ranges::all_of(data_m, [&](double z) { return z == data_m.front(); })) return {data_m.begin(), data_m.end()};
  Smoother smoother{graph, data_m, kStepShare * step_m};
  smoother.prepare();
  const Bins bins(graph);
  std::vector<std::uint32_t> nodes;
  for (const Cell square : bins.squares()) {
    bins.gather(square, nodes);
    if (!nodes.empty()) smoother.solve(square, nodes);
  }
  std::vector<double> z_m;
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    const bool is_fixed = graph.nodes[n].is_pinned || smoother.share[n] == 0;
    z_m.push_back(is_fixed ? data_m[n] : smoother.weighted_m[n] / smoother.share[n]);
  }
  return z_m;
}

}  // namespace citykiln::ground

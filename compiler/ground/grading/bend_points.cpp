#include "compiler/ground/grading/bend_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/ground/height_layer.h"
#include "compiler/map/locate.h"

namespace citykiln::ground {
namespace {

// Pieces farther from the cell cannot touch it.
constexpr double kNear_m = 1;
// A joint counts as a bend from this share of the allowed error on: small bends add up over many pieces.
constexpr double kBendShare = 1.0 / 8;

// The difference that grading makes to the terrain. The terrain's own bends have lines of their own.
Heights grading_at(GradedHeights& heights, Vec2 p) {
  auto [grading, terrain_m] = heights.at(p);
  for (double& height : grading) height -= terrain_m;
  return grading;
}

// The largest distance, over the layers, of the heights here from the straight line from a to b at this share of its
// length.
double error_m(const Heights& a, const Heights& b, const Heights& here, double share) {
  double most_m = 0;
  for (std::size_t layer = 0; layer < here.size(); ++layer)
    most_m = std::max(most_m, std::abs(here[layer] - (a[layer] + (b[layer] - a[layer]) * share)));
  return most_m;
}

// A line in equal pieces, from its lower end.
struct Pieces {
  Vec2 a, b;
  int count;

  Vec2 joint(int i) const {
    if (i == 0 || i == count) return i == 0 ? a : b;
    return snapped(a + (b - a) * (static_cast<double>(i) / count));
  }
  Box2 box(int i) const { return box_of_segment(joint(i), joint(i + 1)); }
};

Pieces pieces_of(Vec2 a, Vec2 b, double most_m) {
  int count = 1;
  while (distance(a, b) > count * most_m) count *= 2;
  return {a, b, count};
}

bool crosses_cells(Vec2 a, Vec2 b) {
  const auto cell = [](double x) { return std::floor(x / map::kCell_m); };
  return cell(a.x) != cell(b.x) || cell(a.y) != cell(b.y);
}

// A place on a line.
struct LinePlace {
  Vec2 at;
  Heights grading;
};

// Adds points by halving the line where its middle is off.
void add_bends_between(GradedHeights& heights, const SplitLimits& limits, const LinePlace& a, const LinePlace& b,
                       std::vector<Vec2>& bends) {
  if (distance(a.at, b.at) < limits.shortest_m) return;
  const Vec2 p = snapped((a.at + b.at) * 0.5);
  const LinePlace middle{p, grading_at(heights, p)};
  if (error_m(a.grading, b.grading, middle.grading, 0.5) <= limits.error_m) return;
  add_bends_between(heights, limits, a, middle, bends);
  bends.push_back(middle.at);
  add_bends_between(heights, limits, middle, b, bends);
}

// The joints between pieces, each sampled at most once.
struct Joints {
  GradedHeights& heights;
  SplitLimits limits;
  Pieces pieces;
  std::vector<std::optional<Heights>> grading;

  const Heights& at(int i) {
    auto& known = grading[static_cast<std::size_t>(i)];
    if (!known) known = grading_at(heights, pieces.joint(i));
    return *known;
  }

  bool is_bent(int i) {
    const double allowed_m = limits.error_m * kBendShare;
    return i > 0 && i < pieces.count && error_m(at(i - 1), at(i + 1), at(i), 0.5) > allowed_m;
  }
};

// The points of one piece that must be vertices: its ends, points between them.
struct PieceBends {
  bool first = false, last = false;
  std::vector<Vec2> between;
};

// The ends of a piece that crosses from cell to cell are always vertices: so both cells cut the same short segment at
// their common border.
PieceBends bends_of_piece(Joints& joints, int i) {
  PieceBends bends_here;
  const Pieces& pieces = joints.pieces;
  const Vec2 a = pieces.joint(i), b = pieces.joint(i + 1);
  if (pieces.count > 1) bends_here.first = bends_here.last = crosses_cells(a, b);
  if (!has_grading(joints.heights.graded(), pieces.box(i))) return bends_here;
  add_bends_between(joints.heights, joints.limits, {a, joints.at(i)}, {b, joints.at(i + 1)}, bends_here.between);
  bends_here.first |= !bends_here.between.empty() || joints.is_bent(i);
  bends_here.last |= !bends_here.between.empty() || joints.is_bent(i + 1);
  return bends_here;
}

bool is_bent_already(const LandCoverPolygon& surface) {
  const HeightLayer layer = layer_of(surface);
  return layer == HeightLayer::kRoad || layer == HeightLayer::kCarriageway;
}

Ring bent_ring(const Ring& ring, GradedHeights& heights, const Box2& cell) {
  Ring bent;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    bent.push_back(ring[i]);
    const std::vector<Vec2> bends = bend_points_along(heights, ring[i], ring[(i + 1) % ring.size()], cell);
    bent.insert(bent.end(), bends.begin(), bends.end());
  }
  return bent;
}

// The differences of graded terrain and terrain along a side of a cell, one per metre.
struct Side {
  std::vector<Vec2> places;
  std::vector<Heights> grading;
};

Side side_from(GradedHeights& heights, Vec2 from, Vec2 to) {
  Side side;
  const auto count = static_cast<int>(distance(from, to));
  for (int i = 0; i <= count; ++i) {
    const Vec2 p = from + (to - from) * (static_cast<double>(i) / count);
    side.places.push_back(p), side.grading.push_back(grading_at(heights, p));
  }
  return side;
}

double bend_m(const Side& side, std::size_t first, std::size_t last) {
  double most_m = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double share = static_cast<double>(i - first) / static_cast<double>(last - first);
    most_m = std::max(most_m, error_m(side.grading[first], side.grading[last], side.grading[i], share));
  }
  return most_m;
}

void split_side(const Side& side, std::size_t first, std::size_t last, std::vector<GridPoint>& points) {
  if (last - first < 2 || bend_m(side, first, last) <= kReferenceError_m) return;
  const std::size_t middle = (first + last) / 2;
  split_side(side, first, middle, points);
  points.push_back(grid_point(side.places[middle]));
  split_side(side, middle, last, points);
}

}  // namespace

std::vector<Vec2> bend_points_along(GradedHeights& heights, Vec2 a, Vec2 b, const Box2& cell,
                                    const SplitLimits& limits) {
  assert(limits.piece_m > 0 && limits.shortest_m > 0 && limits.error_m > 0);
  std::vector<Vec2> bends;
  const Box2 near = cell.widened(kNear_m);
  if (distance(a, b) < limits.shortest_m || !box_of_segment(a, b).touches(near)) return bends;
  const Pieces pieces = pieces_of(std::min(a, b), std::max(a, b), limits.piece_m);
  Joints joints{heights, limits, pieces, {}};
  joints.grading.resize(static_cast<std::size_t>(pieces.count) + 1);
  const auto add = [&](Vec2 p) {
    if (p != a && p != b && (bends.empty() || bends.back() != p)) bends.push_back(p);
  };
  for (int i = 0; i < pieces.count; ++i) {
    if (!pieces.box(i).touches(near)) continue;
    const PieceBends bends_here = bends_of_piece(joints, i);
    if (bends_here.first) add(pieces.joint(i));
    for (const Vec2 p : bends_here.between) add(p);
    if (bends_here.last) add(pieces.joint(i + 1));
  }
  if (b < a) std::ranges::reverse(bends);
  return bends;
}

std::vector<LandCoverPolygon> rings_with_bends(std::span<const LandCoverPolygon> surfaces, GradedHeights& heights,
                                               const Box2& cell) {
  std::vector<LandCoverPolygon> bent(surfaces.begin(), surfaces.end());
  for (LandCoverPolygon& surface : bent)
    if (!is_bent_already(surface))
      for (Ring& ring : surface.rings) ring = bent_ring(ring, heights, cell);
  return bent;
}

std::vector<GridPoint> bend_points_on_border(GradedHeights& heights, const Box2& cell) {
  std::vector<GridPoint> points;
  const Vec2 sw = cell.min, ne = cell.max, se{ne.x, sw.y}, nw{sw.x, ne.y};
  for (const auto& [from, to] : {std::pair{sw, se}, {sw, nw}, {se, ne}, {nw, ne}}) {
    const Side side = side_from(heights, from, to);
    split_side(side, 0, side.places.size() - 1, points);
  }
  return points;
}

}  // namespace citykiln::ground

#include "compiler/parcels/lot_borders.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/parcels/edge_owners.h"

namespace citykiln::parcels {
namespace {

// Labels are compared at this distance from a line.
constexpr double kBeside_m = 0.015;
// Shadows are looked for at this distance behind an obstacle.
constexpr double kBehind_m = 0.125;
// Lines are tested at least this often.
constexpr double kSightStep_m = 4;
// Shorter parts of lines are not tested.
constexpr double kLeastPart_m = 0.01;

using Cut = std::pair<Vec2, Vec2>;

struct Range {
  double from, to;
  bool is_empty() const { return !(from < to); }
};

// The shares of p → q within a convex ring, or up to `beyond_m` outside its edges.
Range range_in(const Ring& ring, Vec2 p, Vec2 q, Range range, double beyond_m = 0) {
  const Vec2 along = q - p;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 edge = ring[i] - ring[j];
    const double start = cross(edge, p - ring[j]) + (beyond_m > 0 ? beyond_m * length(edge) : 0);
    const double step = cross(edge, along);
    if (step > 0)
      range.from = std::max(range.from, -start / step);
    else if (step < 0)
      range.to = std::min(range.to, -start / step);
    else if (start < 0)
      return {1, 0};
  }
  return range;
}

// The line of equal distance from two pieces, within the land of both.
std::optional<Cut> bisector_of(const Piece& p, const Piece& q) {
  const Vec2 normal = p.normal - q.normal;
  const double squared = dot(normal, normal);
  if (squared < 1e-6) return std::nullopt;
  const double level = dot(p.normal, p.foot) - dot(q.normal, q.foot);
  const Vec2 start = p.foot + normal * ((level - dot(normal, p.foot)) / squared), along = unit(left_of(normal));
  const double most = 4 * kDepth_m + distance(start, p.foot);
  const Vec2 a = start - along * most, b = start + along * most;
  const Range range = range_in(q.land, a, b, range_in(p.land, a, b, {0, 1}));
  if (range.is_empty()) return std::nullopt;
  return Cut{a + (b - a) * range.from, a + (b - a) * range.to};
}

std::uint32_t label_at(const Field& field, std::span<const std::uint32_t> pieces, Vec2 p) {
  const std::uint32_t piece = nearest_piece(field, pieces, p);
  return piece == kNoIndex ? kRest : field.pieces[piece].label;
}

// The pieces that contain places up to kBeside_m from a → b, ascending.
std::vector<std::uint32_t> pieces_along(const Field& field, Vec2 a, Vec2 b) {
  std::vector<std::uint32_t> pieces = boxes_about(field.grid, box_of_segment(a, b).widened(kBeside_m));
  std::erase_if(pieces, [&](std::uint32_t i) {
    return range_in(field.pieces[i].land, a, b, {0, 1}, 2 * kBeside_m).is_empty();
  });
  return pieces;
}

// The shares of a → b at which the nearest of some pieces may change.
std::vector<double> changes_along(const Field& field, std::span<const std::uint32_t> pieces, const Piece& own, Vec2 a,
                                  Vec2 b) {
  std::vector<double> changes = {0, 1};
  for (const std::uint32_t i : pieces) {
    const Piece& piece = field.pieces[i];
    const Range range = range_in(piece.land, a, b, {0, 1});
    if (range.is_empty()) continue;
    changes.push_back(range.from), changes.push_back(range.to);
    const double at_a = distance_m(own, a) - distance_m(piece, a), at_b = distance_m(own, b) - distance_m(piece, b);
    if ((at_a < 0) != (at_b < 0)) changes.push_back(at_a / (at_a - at_b));
  }
  // sight may end anywhere
  const int steps = static_cast<int>(distance(a, b) / kSightStep_m);
  for (int i = 1; i < steps; ++i) changes.push_back(static_cast<double>(i) / steps);
  std::ranges::sort(changes);
  return changes;
}

// False if a piece owns no land beside p: another one is nearer, or obstacles hide its street edge from both sides.
bool may_be_nearest(const Field& field, std::span<const std::uint32_t> pieces, const Piece& own, Vec2 p, Vec2 beside) {
  return !is_any_nearer(field, pieces, p, distance_m(own, p) - 4 * kBeside_m) &&
         (is_seen_by(field, own, p + beside) || is_seen_by(field, own, p - beside));
}

// Appends the parts of a → b, a line of a piece, along which the labels of its two sides differ. `pieces` are those
// that may be the nearest beside it.
void keep_parts(const Field& field, std::span<const std::uint32_t> pieces, const Piece& own, Vec2 a, Vec2 b,
                std::vector<Cut>& cuts) {
  const double length = distance(a, b);
  const Vec2 along = unit(b - a), beside = left_of(along) * kBeside_m;
  const std::vector<double> changes = changes_along(field, pieces, own, a, b);
  double from = -1, to = -1;
  const auto flush = [&] {
    if (to > from) cuts.emplace_back(a + along * (from * length - kOverlap_m), a + along * (to * length + kOverlap_m));
  };
  for (std::size_t i = 1; i < changes.size(); ++i) {
    if ((changes[i] - changes[i - 1]) * length < kLeastPart_m) continue;
    const Vec2 middle = a + (b - a) * ((changes[i] + changes[i - 1]) / 2);
    if (!may_be_nearest(field, pieces, own, middle, beside)) continue;
    if (label_at(field, pieces, middle + beside) == label_at(field, pieces, middle - beside)) continue;
    if (to < 0 || (changes[i - 1] - to) * length > 2 * kLeastPart_m) {
      flush();
      from = changes[i - 1];
    }
    to = changes[i];
  }
  flush();
}

// The part of a line away from a street edge that is seen from it.
Vec2 last_seen(const Field& field, Vec2 from, Vec2 to) {
  const double length_m = distance(from, to);
  const Vec2 along = unit(to - from);
  const double seen_m = distance_to_obstacle(*field.obstacles, from, along, length_m);
  return seen_m < length_m ? from + along * std::min(seen_m + kBehind_m, length_m) : to;
}

// Appends a side of a piece, where it is a border.
void keep_side(const Field& field, const Piece& own, Vec2 a, Vec2 b, std::vector<Cut>& cuts) {
  if (distance(a, b) >= kLeastPart_m) keep_parts(field, pieces_along(field, a, b), own, a, b, cuts);
}

// Appends a bisector of a piece and another one, where it is a border: no piece that is farther than both matters.
void keep_bisector(const Field& field, const Piece& own, const Cut& bisector, std::vector<Cut>& cuts) {
  // names of their own: clang 14 captures no structured bindings
  const Vec2 a = bisector.first, b = bisector.second;
  if (distance(a, b) < kLeastPart_m) return;
  std::vector<std::uint32_t> pieces = pieces_along(field, a, b);
  std::erase_if(pieces, [&](std::uint32_t i) {
    const auto is_farther = [&](Vec2 p) { return distance_m(field.pieces[i], p) > distance_m(own, p) + 4 * kBeside_m; };
    return is_farther(a) && is_farther(b);
  });
  keep_parts(field, pieces, own, a, b, cuts);
}

// Appends the shadows of obstacles' ends: lines away from a street edge, behind which the land is not seen from it.
void add_shadows(const Field& field, const Piece& piece, const Box2& box, std::vector<Cut>& cuts) {
  if (piece.along == Vec2{}) return;
  const double depth = distance(piece.land[1], piece.land[2]);
  const Obstacles& obstacles = *field.obstacles;
  for (const std::uint32_t i : boxes_about(obstacles.grid, box))
    for (const Vec2 end : {obstacles.segments[i].first, obstacles.segments[i].second}) {
      if (!is_in_convex(piece.land, end)) continue;
      const Vec2 behind = end + piece.normal * kBehind_m, aside = piece.along * kBeside_m;
      if (is_seen_by(field, piece, behind + aside) == is_seen_by(field, piece, behind - aside)) continue;
      keep_side(field, piece, end, end + piece.normal * (depth - distance_m(piece, end)), cuts);
    }
}

bool overlap(const Box2& a, const Box2& b) { return a.touches(b); }

std::vector<Cut> borders_of_piece(const Field& field, const std::vector<Box2>& boxes, std::uint32_t number) {
  std::vector<Cut> cuts;
  const Piece& piece = field.pieces[number];
  // the first edge of a piece of a street edge is the street edge itself, those of a wedge begin at its tip
  const std::size_t first = piece.along == Vec2{} ? 0 : 1, last = piece.land.size() - 1;
  keep_side(field, piece, piece.land[first], last_seen(field, piece.land[first], piece.land[first + 1]), cuts);
  keep_side(field, piece, piece.land[first + 1], piece.land[last], cuts);
  keep_side(field, piece, piece.land[0], last_seen(field, piece.land[0], piece.land[last]), cuts);
  for (const std::uint32_t other : boxes_about(field.grid, boxes[number])) {
    if (other <= number || field.pieces[other].label == piece.label || !overlap(boxes[number], boxes[other])) continue;
    if (const auto cut = bisector_of(piece, field.pieces[other])) keep_bisector(field, piece, *cut, cuts);
  }
  add_shadows(field, piece, boxes[number], cuts);
  return cuts;
}

}  // namespace

std::vector<std::pair<Vec2, Vec2>> lot_borders(const Field& field, int threads) {
  std::vector<Box2> boxes;
  bool has_labels = false;
  for (const Piece& piece : field.pieces) {
    boxes.push_back(box_of(piece.land));
    has_labels = has_labels || piece.label != kRest;
  }
  if (!has_labels) return {};
  const auto parts = for_each_slot<std::vector<Cut>>(field.pieces.size(), threads, [&](std::size_t i) {
    return borders_of_piece(field, boxes, static_cast<std::uint32_t>(i));
  });
  std::vector<Cut> all;
  for (const std::vector<Cut>& cuts : parts) all.insert(all.end(), cuts.begin(), cuts.end());
  return all;
}

}  // namespace citykiln::parcels

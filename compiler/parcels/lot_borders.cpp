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

// The shares of p → q within a convex ring.
Range range_in(const Ring& ring, Vec2 p, Vec2 q, Range range) {
  const Vec2 along = q - p;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 edge = ring[i] - ring[j];
    const double start = cross(edge, p - ring[j]), step = cross(edge, along);
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

std::uint32_t label_at(const Field& field, Vec2 p) {
  const std::uint32_t piece = nearest_piece(field, p);
  return piece == kNoIndex ? kRest : field.pieces[piece].label;
}

// The shares of a → b at which the nearest piece may change.
std::vector<double> changes_along(const Field& field, const Piece& own, Vec2 a, Vec2 b) {
  std::vector<double> changes = {0, 1};
  Box2 box;
  box.grow(a), box.grow(b);
  for (const std::uint32_t i : boxes_about(field.grid, box)) {
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

// Appends the parts of a → b along which the labels of its two sides differ.
void keep_parts(const Field& field, const Piece& own, Vec2 a, Vec2 b, std::vector<Cut>& cuts) {
  const double length = distance(a, b);
  if (length < kLeastPart_m) return;
  const Vec2 along = unit(b - a), beside = left_of(along) * kBeside_m;
  const std::vector<double> changes = changes_along(field, own, a, b);
  double from = -1, to = -1;
  const auto flush = [&] {
    if (to > from) cuts.emplace_back(a + along * (from * length - kOverlap_m), a + along * (to * length + kOverlap_m));
  };
  for (std::size_t i = 1; i < changes.size(); ++i) {
    if ((changes[i] - changes[i - 1]) * length < kLeastPart_m) continue;
    const Vec2 middle = a + (b - a) * ((changes[i] + changes[i - 1]) / 2);
    if (label_at(field, middle + beside) == label_at(field, middle - beside)) continue;
    if (to < 0 || (changes[i - 1] - to) * length > 2 * kLeastPart_m) {
      flush();
      from = changes[i - 1];
    }
    to = changes[i];
  }
  flush();
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
      keep_parts(field, piece, end, end + piece.normal * (depth - distance_m(piece, end)), cuts);
    }
}

bool overlap(const Box2& a, const Box2& b) { return a.touches(b); }

std::vector<Cut> borders_of_piece(const Field& field, const std::vector<Box2>& boxes, std::uint32_t number) {
  std::vector<Cut> cuts;
  const Piece& piece = field.pieces[number];
  // the first edge of a piece of a street edge is the street edge itself, those of a wedge begin at its tip
  for (std::size_t i = piece.along == Vec2{} ? 0 : 1; i < piece.land.size(); ++i)
    keep_parts(field, piece, piece.land[i], piece.land[(i + 1) % piece.land.size()], cuts);
  for (const std::uint32_t other : boxes_about(field.grid, boxes[number])) {
    if (other <= number || field.pieces[other].label == piece.label || !overlap(boxes[number], boxes[other])) continue;
    if (const auto cut = bisector_of(piece, field.pieces[other]))
      keep_parts(field, piece, cut->first, cut->second, cuts);
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

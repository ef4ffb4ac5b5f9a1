#include "compiler/buildings/meshes/join_rectangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/segment.h"

namespace citykiln::buildings {
namespace {

// Copies of equal shapes meet to 8 µm (grammars/cga.md); a metre of two facets of a round tower bends by more.
constexpr double kJoint_m = 0x1p-14;

// A rectangle: corner 0 to corner 1 is its lower side, or on level ground the side that runs most nearly east.
struct Rectangle {
  std::array<Vec3, 4> corner;
  std::array<std::uint64_t, 4> number;  // by corner: corner_number
  std::size_t face = 0;                 // index of the face that was its first part
  double detail_distance_m = 0;
  bool is_joined = false;
};

bool is_rectangular(std::span<const Vec3> ring) {
  const Vec3 a = ring[1] - ring[0], b = ring[2] - ring[1];
  const double bend_m = length(ring[3] - ring[2] + a), a_m = length(a), b_m = length(b);
  return bend_m < kJoint_m && std::min(a_m, b_m) > kJoint_m && std::abs(dot(a, b)) < kJoint_m * std::min(a_m, b_m);
}

// The side from which the corners are counted.
std::size_t lower_side(std::span<const Vec3> ring) {
  constexpr double kLevel = 0.0087;  // as for texture coordinates, the sine of half a degree
  const Vec3 a = unit(ring[1] - ring[0]), b = unit(ring[2] - ring[1]), foot = cross(Vec3{0, 0, 1}, cross(a, b));
  const Vec3 along = length(foot) < kLevel ? Vec3{1, 0, 0} : foot;
  const double with_a = dot(a, along), with_b = dot(b, along);
  if (std::abs(with_a) >= std::abs(with_b)) return with_a > 0 ? 0 : 2;
  return with_b > 0 ? 1 : 3;
}

// Corners that round to equal multiples of kQuantum_m have equal numbers; so have corners 2 km apart, which are told
// apart later.
std::uint64_t corner_number(Vec3 p) {
  constexpr std::uint64_t kMask = (1u << 21) - 1;
  const auto steps = [](double m) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(m / kQuantum_m + 0.5))) & kMask;
  };
  return steps(p.x) << 42 | steps(p.y) << 21 | steps(p.z);
}

std::optional<Rectangle> rectangle_of(const DerivedFace& derived, std::size_t index) {
  const grammars::Ring3& ring = derived.face.outer;
  if (ring.size() != 4 || !derived.face.holes.empty() || !is_rectangular(ring)) return std::nullopt;
  Rectangle rectangle{{}, {}, index, derived.detail_distance_m};
  const std::size_t first = lower_side(ring);
  for (std::size_t i = 0; i < 4; ++i) {
    rectangle.corner[i] = ring[(first + i) % 4];
    rectangle.number[i] = corner_number(rectangle.corner[i]);
  }
  return rectangle;
}

bool is_before(const Rectangle& a, const Rectangle& b) {
  if (a.number != b.number) return a.number < b.number;
  return std::ranges::lexicographical_compare(a.corner, b.corner, [](Vec3 p, Vec3 q) {
    return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
  });
}

// In an order that does not depend on that of the faces. Most first corners differ, and numbers are moved faster than
// rectangles.
std::vector<Rectangle> sorted(const std::vector<Rectangle>& rectangles) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(rectangles.size());
  for (std::size_t i = 0; i < rectangles.size(); ++i) order.emplace_back(rectangles[i].number[0], i);
  std::ranges::sort(order, [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : is_before(rectangles[a.second], rectangles[b.second]);
  });
  std::vector<Rectangle> result;
  result.reserve(rectangles.size());
  for (const auto& [number, i] : order) result.push_back(rectangles[i]);
  return result;
}

// Rectangles are joined along an axis: across the far side of one and the near side of the next. `near_first` is the
// corner at which the near side begins; the far side is the opposite one.
struct JoinAxis {
  std::size_t near_first;
  std::size_t far_first() const { return (near_first + 2) % 4; }
  std::size_t far_last() const { return (near_first + 3) % 4; }
  std::size_t near_last() const { return (near_first + 1) % 4; }
};
constexpr JoinAxis kUpwards{0}, kAlong{3};

using SideNumber = std::pair<std::uint64_t, std::uint64_t>;

SideNumber near_side(const Rectangle& r, JoinAxis axis) {
  return {r.number[axis.near_first], r.number[axis.near_last()]};
}
// The corners are in the order of the next rectangle's near side, which runs the other way.
SideNumber far_side(const Rectangle& r, JoinAxis axis) {
  return {r.number[axis.far_last()], r.number[axis.far_first()]};
}

// True if the corners at which two rectangles meet are on the sides of their union.
bool meet_straight(const Rectangle& a, const Rectangle& b, JoinAxis axis) {
  const auto is_straight = [&](std::size_t near, std::size_t far) {
    const auto off_m = [&](Vec3 p) { return distance_to_segment(a.corner[near], b.corner[far], p); };
    return length(a.corner[far] - b.corner[near]) < kJoint_m && off_m(a.corner[far]) < kJoint_m &&
           off_m(b.corner[near]) < kJoint_m;
  };
  return is_straight(axis.near_first, axis.far_last()) && is_straight(axis.near_last(), axis.far_first());
}

void extend(Rectangle& a, const Rectangle& b, JoinAxis axis) {
  for (const std::size_t far : {axis.far_first(), axis.far_last()})
    a.corner[far] = b.corner[far], a.number[far] = b.number[far];
  a.face = std::min(a.face, b.face);
  a.detail_distance_m = std::max(a.detail_distance_m, b.detail_distance_m);
  a.is_joined = true;
}

constexpr std::size_t kNoNext = ~std::size_t{0};

// Rectangles by their near sides: a hash table whose buckets are lists in ascending order.
class NearSides {
 public:
  NearSides(const std::vector<Rectangle>& rectangles, JoinAxis axis)
      : first_(std::bit_ceil(rectangles.size() * 2), kNoNext), following_(rectangles.size()) {
    for (std::size_t i = rectangles.size(); i-- > 0;)
      following_[i] = std::exchange(first_[bucket(near_side(rectangles[i], axis))], i);
  }

  /// The first rectangle that may have the near side, or kNoNext.
  std::size_t first(SideNumber side) const { return first_[bucket(side)]; }
  /// The one after it.
  std::size_t following(std::size_t i) const { return following_[i]; }

 private:
  std::size_t bucket(SideNumber side) const {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio spreads near numbers widely
    const std::uint64_t mixed = ((side.first * kOdd) ^ side.second) * kOdd;
    return (mixed >> 32) & (first_.size() - 1);
  }

  std::vector<std::size_t> first_, following_;
};

// By rectangle: the one that follows it along the axis. No two have the same next one.
std::vector<std::size_t> next_along(const std::vector<Rectangle>& rectangles, JoinAxis axis) {
  const NearSides sides(rectangles, axis);
  std::vector<bool> is_taken(rectangles.size());
  std::vector<std::size_t> next(rectangles.size(), kNoNext);
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const SideNumber side = far_side(rectangles[i], axis);
    for (std::size_t at = sides.first(side); at != kNoNext && next[i] == kNoNext; at = sides.following(at))
      if (!is_taken[at] && near_side(rectangles[at], axis) == side &&
          meet_straight(rectangles[i], rectangles[at], axis))
        next[i] = at, is_taken[at] = true;
  }
  return next;
}

// Joins all runs of rectangles along an axis.
std::vector<Rectangle> joined_along(const std::vector<Rectangle>& rectangles, JoinAxis axis) {
  const std::vector<std::size_t> next = next_along(rectangles, axis);
  std::vector<bool> follows(rectangles.size());
  for (const std::size_t i : next)
    if (i != kNoNext) follows[i] = true;
  std::vector<Rectangle> joined;
  joined.reserve(rectangles.size());
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    if (follows[i]) continue;
    Rectangle run = rectangles[i];
    for (std::size_t at = next[i]; at != kNoNext; at = next[at]) {
      if (meet_straight(run, rectangles[at], axis)) {
        extend(run, rectangles[at], axis);
      } else {
        joined.push_back(std::exchange(run, rectangles[at]));
      }
    }
    joined.push_back(run);
  }
  return joined;
}

// Along one axis and the other in turn, until one finds nothing after the other.
std::vector<Rectangle> joined_in_turn(const std::vector<Rectangle>& rectangles, JoinAxis axis) {
  std::vector<Rectangle> joined = joined_along(rectangles, axis);
  for (std::size_t before = kNoNext; joined.size() < before;) {
    before = joined.size();
    axis = axis.near_first == kUpwards.near_first ? kAlong : kUpwards;
    joined = joined_along(joined, axis);
  }
  return joined;
}

std::vector<Rectangle> fewest_joined(const std::vector<Rectangle>& rectangles) {
  if (rectangles.size() < 2) return rectangles;
  std::vector<Rectangle> upwards = joined_in_turn(rectangles, kUpwards);
  if (upwards.size() == rectangles.size() || upwards.size() == 1) return upwards;
  std::vector<Rectangle> along = joined_in_turn(rectangles, kAlong);
  return along.size() < upwards.size() ? along : upwards;
}

DerivedFace derived_face(const Rectangle& rectangle, grammars::FaceTag tag) {
  DerivedFace derived;
  derived.face.outer = grammars::Ring3(rectangle.corner.begin(), rectangle.corner.end());
  derived.face.tag = tag;
  derived.detail_distance_m = rectangle.detail_distance_m;
  return derived;
}

}  // namespace

std::vector<DerivedFace> join_rectangles(std::vector<DerivedFace> faces) {
  std::vector<Rectangle> rectangles;
  std::vector<bool> is_part(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (const std::optional<Rectangle> rectangle = rectangle_of(faces[i], i))
      rectangles.push_back(*rectangle), is_part[i] = true;
  for (const Rectangle& r : fewest_joined(sorted(rectangles))) {
    is_part[r.face] = false;
    if (r.is_joined) faces[r.face] = derived_face(r, faces[r.face].face.tag);
  }
  std::vector<DerivedFace> kept;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!is_part[i]) kept.push_back(std::move(faces[i]));
  return kept;
}

}  // namespace citykiln::buildings

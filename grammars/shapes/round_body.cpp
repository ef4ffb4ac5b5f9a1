#include "grammars/shapes/round_body.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::grammars {
namespace {

constexpr int kSideNumbers[] = {3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, 64, 96, 128, 192, 256};
// Spheres of fewer sides would be spindles.
constexpr int kLeastSphereSides = 4;

double cosine_of_half_side(int sides) { return direction_of(0.5 / sides).x; }

// The deviation from a circle of radius 1 of a polygon whose corners are as far outside as its sides are inside.
double deviation_of(double inner_share) { return (1 - inner_share) / (1 + inner_share); }
double corner_radius_of(double inner_share) { return 2 / (1 + inner_share); }

/// The directions of the corners of a polygon across an axis. One side faces backwards along y, or along z if it stands
/// along x or y: in a scope whose z points up, it is the front, or the lower side.
std::vector<Vec2> corner_directions(int sides, int axis) {
  const double offset = axis == 1 ? -0.5 : -0.25;
  std::vector<Vec2> corners;
  for (int i = 0; i < sides; ++i) corners.push_back(direction_of((i + 0.5) / sides + offset));
  return corners;
}

/// Corners scaled so that they touch all sides of the square from -1 to 1.
void fill_square(std::vector<Vec2>& corners) {
  Vec2 low{1, 1}, high{-1, -1};
  for (const Vec2 c : corners) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  }
  for (Vec2& c : corners)
    c = {(2 * c.x - low.x - high.x) / (high.x - low.x), (2 * c.y - low.y - high.y) / (high.y - low.y)};
}

/// Coordinates of a body along an axis of a scope, from the middle of the scope's near end, in halves of its sizes
/// across and whole sizes along.
struct BodyFrame {
  Vec3 middle, across, up_across, along;
  Vec3 at(Vec2 c, double share, double height) const {
    return middle + across * (c.x * share) + up_across * (c.y * share) + along * height;
  }
};

BodyFrame body_frame(const Scope& scope, int axis) {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  const Vec3 across = scope.axis[b] * (scope.size_m[b] / 2), up = scope.axis[c] * (scope.size_m[c] / 2);
  return {scope.origin + across + up, across, up, scope.axis[axis] * scope.size_m[axis]};
}

double larger_radius_m(const Scope& scope, int axis) {
  return std::max(scope.size_m[(axis + 1) % 3], scope.size_m[(axis + 2) % 3]) / 2;
}

Ring3 ring_at(const BodyFrame& frame, const std::vector<Vec2>& corners, double share, double height) {
  Ring3 ring;
  ring.reserve(corners.size());
  for (const Vec2 c : corners) ring.push_back(frame.at(c, share, height));
  return ring;
}

void add_ring_face(std::vector<Face>& faces, Ring3 outer) { faces.emplace_back().outer = std::move(outer); }

void add_fan_to(std::vector<Face>& faces, const Ring3& ring, Vec3 apex, bool is_above) {
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % n];
    add_ring_face(faces, is_above ? Ring3{a, b, apex} : Ring3{b, a, apex});
  }
}

void add_band(std::vector<Face>& faces, const Ring3& low, const Ring3& high) {
  for (std::size_t i = 0, n = low.size(); i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add_ring_face(faces, {low[i], low[next], high[next], high[i]});
  }
}

Ring3 reversed_corners(const Ring3& ring) { return {ring.rbegin(), ring.rend()}; }

/// A circle of latitude on a sphere of radius 1.
struct Parallel {
  double radius = 0, height = 0;
};

// From the south pole, or from the equator, to the north pole. Poles have radius 0.
std::vector<Parallel> parallels_of(int sides, bool is_half) {
  const int bands = std::max((sides + 1) / 2, 2), half = (bands + 1) / 2;
  const int count = is_half ? half : 2 * half;
  std::vector<Parallel> parallels;
  for (int i = 0; i <= count; ++i) {
    const Vec2 d = direction_of((i - (is_half ? 0 : half)) * 0.25 / half);
    parallels.push_back({d.x, d.y});
  }
  parallels.back().radius = 0;
  if (!is_half) parallels.front().radius = 0;
  return parallels;
}

/// The distance from the centre to the middle of a face between two parallels, for corners at distance 1.
double inner_distance(Parallel a, Parallel b, double half_side_cosine) {
  const Vec2 p{a.radius * half_side_cosine, a.height}, q{b.radius * half_side_cosine, b.height};
  const Vec2 edge = q - p;
  const double along = std::clamp(-dot(p, edge) / dot(edge, edge), 0.0, 1.0);
  return length(p + edge * along);
}

double inner_share_of(const std::vector<Parallel>& parallels, int sides) {
  double least = 1;
  for (std::size_t i = 1; i < parallels.size(); ++i)
    least = std::min(least, inner_distance(parallels[i - 1], parallels[i], cosine_of_half_side(sides)));
  return least;
}

int sphere_sides(double radius_m, RoundSides sides) {
  if (sides.given > 0) return std::clamp(sides.given, kLeastSphereSides, RoundSides::kMost);
  for (const int n : kSideNumbers)
    if (n >= kLeastSphereSides && radius_m * deviation_of(inner_share_of(parallels_of(n, false), n)) <= sides.most_m)
      return n;
  return RoundSides::kMost;
}

/// The middle of the ellipsoid, and its half sizes, as a frame.
BodyFrame ellipsoid_frame(const Scope& scope, int axis, bool is_half) {
  BodyFrame frame = body_frame(scope, axis);
  if (is_half) return frame;
  frame.middle = frame.middle + frame.along * 0.5;
  frame.along = frame.along * 0.5;
  return frame;
}

RoundBody ellipsoid_in(const Scope& scope, int axis, RoundSides sides, bool is_half) {
  const BodyFrame frame = ellipsoid_frame(scope, axis, is_half);
  const double radius_m = std::max(larger_radius_m(scope, axis), length(frame.along));
  const int n = sphere_sides(radius_m, sides);
  const std::vector<Parallel> parallels = parallels_of(n, is_half);
  const double inner = inner_share_of(parallels, n), corner = sides.given > 0 ? 1 : corner_radius_of(inner);
  const std::vector<Vec2> corners = corner_directions(n, axis);
  RoundBody body;
  if (sides.given == 0) body.deviation_m = radius_m * deviation_of(inner);
  Ring3 before;
  if (is_half) before = ring_at(frame, corners, corner, 0), add_ring_face(body.faces, reversed_corners(before));
  for (std::size_t i = 1; i < parallels.size(); ++i) {
    const bool is_last = i + 1 == parallels.size();
    Ring3 ring = ring_at(frame, corners, corner * parallels[i].radius, corner * parallels[i].height);
    if (is_last) {
      add_fan_to(body.faces, before, frame.at({}, 0, corner * parallels[i].height), true);
    } else if (before.empty()) {
      add_fan_to(body.faces, ring, frame.at({}, 0, corner * parallels[0].height), false);
    } else {
      add_band(body.faces, before, ring);
    }
    before = std::move(ring);
  }
  return body;
}

}  // namespace

int sides_for(double radius_m, double most_m) {
  for (const int n : kSideNumbers)
    if (radius_m * deviation_of(cosine_of_half_side(n)) <= most_m) return n;
  return RoundSides::kMost;
}

RoundBody cylinder_in(const Scope& scope, int axis, double top, RoundSides sides) {
  assert(axis >= 0 && axis < 3);
  const BodyFrame frame = body_frame(scope, axis);
  const double radius_m = larger_radius_m(scope, axis);
  const int n = sides.given > 0 ? std::clamp(sides.given, RoundSides::kLeast, RoundSides::kMost)
                                : sides_for(radius_m, sides.most_m);
  std::vector<Vec2> corners = corner_directions(n, axis);
  RoundBody body;
  double corner = 1;
  if (sides.given > 0) {
    fill_square(corners);
  } else {
    const double inner = cosine_of_half_side(n);
    corner = corner_radius_of(inner);
    body.deviation_m = radius_m * deviation_of(inner);
  }
  const Ring3 low = ring_at(frame, corners, corner, 0);
  add_ring_face(body.faces, reversed_corners(low));
  if (top <= 0) return add_fan_to(body.faces, low, frame.at({}, 0, 1), true), body;
  const Ring3 high = ring_at(frame, corners, corner * std::min(top, 1.0), 1);
  add_band(body.faces, low, high);
  add_ring_face(body.faces, high);
  return body;
}

RoundBody sphere_in(const Scope& scope, int axis, RoundSides sides) { return ellipsoid_in(scope, axis, sides, false); }

RoundBody dome_in(const Scope& scope, int axis, RoundSides sides) { return ellipsoid_in(scope, axis, sides, true); }

}  // namespace citykiln::grammars

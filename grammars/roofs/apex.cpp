#include "grammars/roofs/apex.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/geometry/box.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/snap.h"
#include "grammars/roofs/facet.h"

namespace citykiln::roofs {
namespace {

// An apex is well inside if its distance from every edge's line is at least this share of the root of the area.
constexpr double kWellInside = 0.12;
// Points of a scaled outline closer than this are merged: eight grid steps, so that rounding turns no face over.
constexpr double kOnePoint_m = 0x1p-7;

Vec2 centroid_of(std::span<const Vec2> ring) {
  Vec2 sum{};
  double twice_m2 = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    sum = sum + (a + b) * cross(a, b);
    twice_m2 += cross(a, b);
  }
  return twice_m2 > 0 ? ring[0] + sum * (1 / (3 * twice_m2)) : ring[0];
}

// The smallest signed distance to an edge's line, positive inside.
double inward_m(std::span<const Vec2> ring, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    least = std::min(least, distance_left_of(ring[j], ring[i]).at(p));
  return least;
}

// The kernel: all points from which the whole ring is visible.
Ring kernel_of(std::span<const Vec2> ring) {
  const Box2 box = box_of(ring);
  Ring kernel = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size() && !kernel.empty(); j = i++)
    kernel = clipped(kernel, distance_left_of(ring[j], ring[i]));
  return kernel;
}

bool is_convex_ring(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0) return false;
  return true;
}

// Builds the roof from ring to ring towards the apex.
class Stack {
 public:
  Stack(std::span<const Vec2> ring, Vec2 apex) : ring_(ring), apex_(apex) {
    for (const Vec2 p : ring) below_.push_back(add_position(at_height(p, 0)));
    roof_.eaves.push_back(below_);
    const std::uint32_t middle = add_position(at_height(apex, 0));
    for (std::size_t i = 0, n = ring.size(); i < n; ++i)
      roof_.floor.push_back({below_[i], below_[(i + 1) % n], middle});
  }

  // Returns false if fewer than three distinct points are left.
  bool add_ring(double scale, double z_m) {
    const std::size_t n = ring_.size();
    std::vector<std::uint32_t> above(n);
    const auto position = [&](std::size_t i) { return snapped(apex_ + (ring_[i] - apex_) * scale); };
    std::vector<Vec2> positions;
    std::vector<std::size_t> rank(n);
    for (std::size_t i = 0; i < n; ++i) {
      // points merged in the ring below are merged here
      const bool is_one =
          i > 0 && (below_[i] == below_[i - 1] || distance(positions.back(), position(i)) < kOnePoint_m);
      if (!is_one) positions.push_back(position(i));
      rank[i] = positions.size() - 1;
    }
    if (positions.size() < 3) return false;
    const auto first = static_cast<std::uint32_t>(roof_.positions.size());
    for (const Vec2 p : positions) add_position(at_height(p, z_m));
    for (std::size_t i = 0; i < n; ++i) above[i] = first + static_cast<std::uint32_t>(rank[i]);
    join(above);
    return true;
  }

  void add_top(double z_m) { join(std::vector<std::uint32_t>(ring_.size(), add_position(at_height(apex_, z_m)))); }

  Roof take() && {
    roof_.parts.assign(roof_.triangles.size(), RoofPart::kRoof);
    return std::move(roof_);
  }

 private:
  std::uint32_t add_position(Vec3 p) {
    roof_.positions.push_back(snapped(p));
    roof_.height_m = std::max(roof_.height_m, roof_.positions.back().z);
    return static_cast<std::uint32_t>(roof_.positions.size()) - 1;
  }

  void add(Triangle t, std::size_t edge) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    roof_.triangles.push_back(t);
    roof_.faces.push_back(static_cast<std::uint32_t>(edge + ring_.size() * bands_));
  }

  void join(std::vector<std::uint32_t> above) {
    for (std::size_t i = 0, n = ring_.size(); i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      add({below_[i], below_[j], above[j]}, i);
      add({below_[i], above[j], above[i]}, i);
    }
    below_ = std::move(above);
    ++bands_;
  }

  std::span<const Vec2> ring_;
  Vec2 apex_;
  std::vector<std::uint32_t> below_;  // by vertex of the footprint: its vertex in the last ring
  std::size_t bands_ = 0;
  Roof roof_;
};

}  // namespace

std::optional<Vec2> apex_of(std::span<const Vec2> ring) {
  const double area = signed_area_m2(ring);
  if (ring.size() < 3 || area <= 0) return std::nullopt;
  const double enough_m = is_convex_ring(ring) ? 2 * kQuantum_m : kWellInside * std::sqrt(area);
  Vec2 apex = snapped(centroid_of(ring));
  if (inward_m(ring, apex) < enough_m) {
    const Ring kernel = kernel_of(ring);
    if (kernel.empty()) return std::nullopt;
    apex = snapped(centroid_of(kernel));
  }
  if (inward_m(ring, apex) < enough_m || winding_number(ring, apex) != 1) return std::nullopt;
  return apex;
}

double apex_span_m(std::span<const Vec2> ring, Vec2 apex) { return inward_m(ring, apex); }

double apex_radius_m(std::span<const Vec2> ring, Vec2 apex) {
  double reach_m = 0;
  for (const Vec2 p : ring) reach_m = std::max(reach_m, distance(apex, p));
  return reach_m;
}

Roof roof_over_apex(std::span<const Vec2> ring, Vec2 apex, const Section& section, double rise_m) {
  assert(ring.size() >= 3 && section.corners.size() >= 2);
  Stack stack(ring, apex);
  for (std::size_t k = 1; k + 1 < section.corners.size(); ++k)
    if (!stack.add_ring(section.corners[k].x, section.corners[k].y * rise_m)) break;
  stack.add_top(rise_m);
  Roof roof = std::move(stack).take();
  roof.error_m = section.error_m;
  return roof;
}

}  // namespace citykiln::roofs

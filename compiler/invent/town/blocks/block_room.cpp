#include "compiler/invent/town/blocks/block_room.h"

#include <algorithm>

#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/segment.h"
#include "compiler/invent/town/blocks/footprints.h"
#include "compiler/invent/town/streets/road_curve.h"
#include "compiler/invent/town/streets/street_graph.h"

namespace citykiln::invent {
namespace {

/// Half the width of a path, and some room beside it.
constexpr double kPathRoom_m = 2.2;

Vec2 longest_side(const Ring& ring) {
  Vec2 longest{1, 0};
  double most_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 side = ring[(i + 1) % ring.size()] - ring[i];
    if (length(side) <= most_m) continue;
    most_m = length(side);
    longest = unit(side);
  }
  return longest;
}

bool touches_path(const Ring& ring, const Polyline& path, double gap_m) {
  for (const Vec2 p : with_even_steps(path, 2))
    if (winding_number(ring, p) != 0 || distance_to_ring(ring, p) < gap_m) return true;
  return false;
}

bool are_apart(const Ring& a, const Ring& b, double gap_m) {
  if (borders_touch(a, b) || winding_number(a, b[0]) != 0 || winding_number(b, a[0]) != 0) return false;
  const auto is_far = [&](const Ring& from, const Ring& to) {
    return std::ranges::all_of(from, [&](Vec2 p) { return distance_to_ring(to, p) >= gap_m; });
  };
  return is_far(a, b) && is_far(b, a);
}

}  // namespace

BlockRoom::BlockRoom(const TownPlan& plan, const TownBlock& block, std::size_t number, const char* role)
    : plan_(plan), block_(block), draws_(plan.settings.seed, role, number), along_(longest_side(block.land.outer)) {}

bool BlockRoom::take(const Ring& ring, double margin_m, double gap_m) {
  if (ring.size() < 3 || !lies_within(ring, land(), margin_m)) return false;
  const bool is_wet = std::ranges::any_of(ring, [&](Vec2 p) { return plan_.water.may_be_water(p); });
  if (is_wet || !std::ranges::all_of(taken_, [&](const Ring& other) { return are_apart(ring, other, gap_m); }))
    return false;
  if (std::ranges::any_of(paths_, [&](const Polyline& path) { return touches_path(ring, path, kPathRoom_m); }))
    return false;
  taken_.push_back(ring);
  return true;
}

std::optional<Ring> BlockRoom::take_box(double width_m, double depth_m, double margin_m, double gap_m, int tries) {
  const Vec2 u = along_, n = left_of(along_);
  Box2 box;
  for (const Vec2 p : land()) box.grow({dot(p, u), dot(p, n)});
  for (int i = 0; i < tries; ++i) {
    const double x = draws_.between(box.min.x, box.max.x), y = draws_.between(box.min.y, box.max.y);
    const Vec2 corner = u * x + n * y, across = u * width_m, back = n * depth_m;
    const Ring ring = {on_place_grid(corner), on_place_grid(corner + across), on_place_grid(corner + across + back),
                       on_place_grid(corner + back)};
    if (take(ring, margin_m, gap_m)) return ring;
  }
  return std::nullopt;
}

std::optional<Ring> BlockRoom::take_box_shrunk(double width_m, double depth_m, double margin_m, double gap_m) {
  for (const double share : {1.0, 0.9, 0.8, 0.7, 0.6})
    if (auto ring = take_box(width_m * share, depth_m * share, margin_m, gap_m)) return ring;
  return std::nullopt;
}

bool BlockRoom::is_free(Vec2 p, double margin_m, double gap_m) const {
  if (winding_number(land(), p) == 0 || distance_to_ring(land(), p) < margin_m || plan_.water.may_be_water(p))
    return false;
  const bool is_apart = std::ranges::all_of(
      taken_, [&](const Ring& ring) { return winding_number(ring, p) == 0 && distance_to_ring(ring, p) >= gap_m; });
  return is_apart && std::ranges::all_of(paths_, [&](const Polyline& path) {
           return distance_to_polyline(path, p) >= std::max(gap_m, kPathRoom_m - 0.4);
         });
}

// true if the way from a street's vertex to a place crosses nothing but the block's own land
bool BlockRoom::reaches(Vec2 from, Vec2 to) const {
  for (std::size_t i = 0; i < block_.ring.size(); ++i) {
    const Vec2 a = block_.ring[i], b = block_.ring[(i + 1) % block_.ring.size()];
    if (a != from && b != from && crossing_shares(from, to, a, b)) return false;
  }
  const bool is_dry = !plan_.water.may_be_water((from + to) * 0.5) && !plan_.water.may_be_water(to);
  return is_dry && winding_number(block_.ring, from + (to - from) * 0.1) != 0 &&
         std::ranges::none_of(taken_, [&](const Ring& ring) {
           return touches_path(ring, {from, to}, 1.5);
         });
}

std::vector<Polyline> BlockRoom::take_paths(std::size_t count) {
  const Vec2 hub = on_place_grid(block_.middle);
  std::vector<Polyline> paths;
  if (winding_number(land(), hub) == 0) return paths;
  const std::size_t n = block_.ring.size();
  for (std::size_t k = 0; k < count && k < n; ++k) {
    const Vec2 gate = block_.ring[k * n / count];
    const bool is_near_other = std::ranges::any_of(
        paths, [&](const Polyline& path) { return dot(unit(path.front() - hub), unit(gate - hub)) > 0.9; });
    if (is_near_other || distance(gate, hub) < 12) continue;
    // a bend to the left on each, so that paths meet at the hub only
    const Vec2 bend = on_place_grid((gate + hub) * 0.5 + left_of(hub - gate) * 0.06);
    if (reaches(gate, bend) && reaches(bend, hub)) paths.push_back({gate, bend, hub});
  }
  for (const Polyline& path : paths) paths_.push_back(path);
  return paths;
}

void BlockRoom::scatter(InventedMap& map, const Tags& tags, double each_m2, double margin_m, double gap_m) {
  const Box2 box = box_of(land());
  const auto tries = static_cast<int>(box.width() * box.height() / each_m2);
  std::vector<Vec2> placed;
  for (int i = 0; i < tries; ++i) {
    const Vec2 p = on_place_grid({draws_.between(box.min.x, box.max.x), draws_.between(box.min.y, box.max.y)});
    const bool is_apart = std::ranges::none_of(placed, [&](Vec2 q) { return distance(p, q) < 4.5; });
    if (!is_apart || !is_free(p, margin_m, gap_m)) continue;
    placed.push_back(p);
    map.points.push_back({p, tags});
  }
}

void BlockRoom::line_border(InventedMap& map, const Tags& tags, double inset_m, double step_m) {
  for (std::size_t i = 0; i < land().size(); ++i) {
    const Vec2 a = land()[i], b = land()[(i + 1) % land().size()], inward = left_of(unit(b - a));
    const auto steps = static_cast<int>(distance(a, b) / step_m);
    for (int k = 0; k < steps; ++k) {
      const Vec2 p = on_place_grid(a + (b - a) * ((k + 0.5) / steps) + inward * inset_m);
      if (is_free(p, inset_m * 0.8, 3)) map.points.push_back({p, tags});
    }
  }
}

}  // namespace citykiln::invent

// Outlines of junctions: rings from cuts and corners, then polygons that share no area.
#include <algorithm>
#include <array>

#include "compiler/contract/for_each_slot.h"
#include "compiler/geometry/overlay.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/junctions/junction_ring.h"

namespace citykiln::roads {
namespace {

// The axis of an arm up to the next node of its junction.
Polyline walk_inside(std::span<const Road> roads, const Arm& arm, std::span<const Vec2> places) {
  const Polyline& axis = roads[arm.road].axis;
  Polyline path = {axis[arm.vertex]};
  for (std::int64_t v = static_cast<std::int64_t>(arm.vertex) + arm.step;
       v >= 0 && v < static_cast<std::int64_t>(axis.size()); v += arm.step) {
    path.push_back(axis[static_cast<std::size_t>(v)]);
    if (std::ranges::binary_search(places, path.back())) break;
  }
  return path;
}

void stroke_arm(std::span<const Road> roads, const Arm& arm, const Cut& cut, std::span<const Vec2> places,
                std::vector<Ring>& rings) {
  const ArmLine line = line_of(roads, arm);
  Strip piece{{}, {}, {}, line.left_m, line.right_m};
  piece.axis = cut.length_m == kWholeLink_m ? walk_inside(roads, arm, places) : walk(roads, arm, cut.length_m);
  piece.axis.back() = snapped(piece.axis.back());
  if (piece.axis.back() == piece.axis[piece.axis.size() - 2]) piece.axis.pop_back();
  if (piece.axis.size() < 2) return;
  for (Ring& ring : stroke(piece)) rings.push_back(std::move(ring));
}

// A disk about a node, as a 16-gon or, above 4 m, a 32-gon.
Ring disk_at(Vec2 place, double radius_m) {
  constexpr double kFine_m = 4;
  const int halvings = radius_m > kFine_m ? 3 : 2;
  Ring ring;
  const std::array<Vec2, 4> quarters = {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
  for (int q = 0; q < 4; ++q) {
    ring.push_back(snapped(place + quarters[q] * radius_m));
    add_arc(place, quarters[q], quarters[(q + 1) % 4], radius_m, halvings, ring);
  }
  return ring;
}

// The radius of the disk that fills the wedge between arms more than half a turn apart, 0 where there is none: the
// smaller half width of the second widest arm, because a wide street that ends on a narrow one opens no wedge.
double open_half_m(const JunctionArms& junction_arms, Vec2 place) {
  constexpr double kWedgeSine = -0.08;
  double widest = 0, second = 0;
  bool is_open = false;
  for (std::size_t a = 0; a < junction_arms.lines.size(); ++a) {
    const ArmLine& line = junction_arms.lines[a];
    if (line.from != place) continue;
    is_open |= cross(line.along, junction_arms.lines[junction_arms.next[a]].along) < kWedgeSine;
    const double half = std::min(line.left_m, line.right_m);
    second = std::max(second, std::min(widest, half));
    widest = std::max(widest, half);
  }
  return !is_open ? 0 : second > 0 ? second : widest;
}

void push_ring(std::vector<Ring>& rings, const Ring& ring) {
  Ring clean = without_repeats(ring);
  if (clean.size() >= 3 && signed_area_m2(clean) > 0) rings.push_back(std::move(clean));
}

}  // namespace

Box2 box_of(const Junction& junction, double widest_arm_m) {
  return citykiln::box_of(junction.places).widened(kJunctionRadius_m + 0.75 * widest_arm_m);
}

const Road& main_road(std::span<const Road> roads, std::span<const Arm> arms) {
  const auto rank = [&](const Arm& arm) {
    const Road& road = roads[arm.road];
    return std::tuple(map::values_of(road.surface).priority, width_m(road), road.id);
  };
  return roads[std::ranges::max_element(arms, {}, rank)->road];
}

std::vector<Ring> stroke_pieces(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                const JunctionArms& junction_arms) {
  std::vector<Ring> rings;
  for (std::size_t a = 0; a < arms.size(); ++a) stroke_arm(roads, arms[a], junction.cuts[a], junction.places, rings);
  for (std::size_t p = 0; p < junction.places.size(); ++p) {
    const Vec2 place = junction.places[p];
    push_ring(rings, disk_at(place, std::max(open_half_m(junction_arms, place), junction_arms.disks_m[p])));
  }
  for (std::uint32_t arm = 0; arm < arms.size(); ++arm) {
    const std::uint32_t next = junction_arms.next[arm];
    const double radius = junction.cuts[arm].radius_m;
    if (radius == 0) continue;
    const auto fillet = fillet_between(junction_arms.paths[arm], junction_arms.paths[next], radius);
    if (!fillet) continue;
    if (auto corner = corner_ring(junction_arms.paths[arm], junction_arms.paths[next], *fillet))
      rings.push_back(std::move(*corner));
  }
  return rings;
}

std::vector<Ring> stroke(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms) {
  const JunctionArms all = junction_arms(junction, roads, arms);
  if (auto ring = trace_outline(junction, roads, arms, all)) return {std::move(*ring)};
  return stroke_pieces(junction, roads, arms, all);
}

std::vector<std::vector<Arm>> arms_of(std::span<const Junction> junctions, std::span<const Road> roads) {
  struct Place {
    Family family;
    Vec2 at;
    std::uint32_t junction, number;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places;
  std::vector<std::vector<std::vector<Arm>>> by_place(junctions.size());
  for (std::uint32_t j = 0; j < junctions.size(); ++j) {
    by_place[j].resize(junctions[j].places.size());
    for (std::uint32_t p = 0; p < junctions[j].places.size(); ++p)
      places.push_back({junctions[j].family, junctions[j].places[p], j, p});
  }
  std::sort(places.begin(), places.end());
  for (std::uint32_t road = 0; road < roads.size(); ++road) {
    const Polyline& axis = roads[road].axis;
    for (std::uint32_t v = 0; v < axis.size(); ++v) {
      const auto found =
          std::lower_bound(places.begin(), places.end(), Place{family_of(roads[road].surface), axis[v], 0, 0});
      if (found == places.end() || found->at != axis[v] || found->family != family_of(roads[road].surface)) continue;
      std::vector<Arm>& arms = by_place[found->junction][found->number];
      if (v > 0) arms.push_back({road, v, -1});
      if (v + 1 < axis.size()) arms.push_back({road, v, 1});
    }
  }
  std::vector<std::vector<Arm>> arms(junctions.size());
  for (std::size_t j = 0; j < junctions.size(); ++j)
    for (const std::vector<Arm>& here : by_place[j]) arms[j].insert(arms[j].end(), here.begin(), here.end());
  return arms;
}

namespace {

// The rings of a junction, their box and the junction's rank.
struct Covered {
  std::vector<Ring> rings;
  Box2 box;
  int priority = 0;
};

// Removes spikes, corner by corner: subtracting other junctions can leave thin points. May leave less than a triangle.
Ring without_spikes(Ring ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() >= 3;) {
    if (!is_spike(ring, i)) {
      ++i;
      continue;
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    i = i > 0 ? i - 1 : 0;
  }
  return ring;
}

std::vector<Polygon> trimmed(std::vector<Polygon> polygons) {
  std::vector<Polygon> sound;
  for (Polygon& polygon : polygons) {
    Ring ring = without_spikes(polygon.outer);
    if (ring.size() < 3 || !is_simple(ring)) continue;
    sound.push_back({std::move(ring), std::move(polygon.holes)});
  }
  return sound;
}

// False where two junctions certainly share no area: only decided for single rings, which are simple.
bool may_share(const Covered& a, const Covered& b) {
  if (a.rings.size() != 1 || b.rings.size() != 1) return true;
  const Ring &r = a.rings.front(), &s = b.rings.front();
  return borders_touch(r, s) || winding_number(r, s.front()) != 0 || winding_number(s, r.front()) != 0;
}

// Junctions in squares of the plane, so that neighbours are found without looking at all.
class Neighbours {
 public:
  explicit Neighbours(std::span<const Covered> covered) : covered_(covered) {
    // junctions of arms a millimetre long cover nothing
    for (const Covered& c : covered)
      if (!c.box.is_empty()) all_.grow(c.box.min), all_.grow(c.box.max);
    if (all_.is_empty()) return;
    columns_ = std::max(1, static_cast<int>(all_.width() / kSquare_m) + 1);
    squares_.resize(static_cast<std::size_t>(columns_) * std::max(1, static_cast<int>(all_.height() / kSquare_m) + 1));
    for (std::uint32_t i = 0; i < covered.size(); ++i)
      for_each_square(covered[i].box, [&](std::vector<std::uint32_t>& square) { square.push_back(i); });
  }

  std::vector<std::uint32_t> touching(std::uint32_t i) {
    std::vector<std::uint32_t> found;
    for_each_square(covered_[i].box, [&](const std::vector<std::uint32_t>& square) {
      for (const std::uint32_t other : square)
        if (other != i && covered_[other].box.touches(covered_[i].box)) found.push_back(other);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  static constexpr double kSquare_m = 64;

  template <typename Visit>
  void for_each_square(const Box2& box, Visit visit) {
    if (box.is_empty()) return;
    const auto number = [](double from, double v) { return static_cast<int>((v - from) / kSquare_m); };
    for (int y = number(all_.min.y, box.min.y); y <= number(all_.min.y, box.max.y); ++y)
      for (int x = number(all_.min.x, box.min.x); x <= number(all_.min.x, box.max.x); ++x)
        visit(squares_[static_cast<std::size_t>(y) * columns_ + x]);
  }

  std::span<const Covered> covered_;
  Box2 all_;
  int columns_ = 1;
  std::vector<std::vector<std::uint32_t>> squares_;
};

}  // namespace

std::vector<std::vector<Polygon>> outline(std::span<const Junction> junctions, std::span<const Road> roads,
                                          int threads) {
  const std::vector<std::vector<Arm>> arms = arms_of(junctions, roads);
  const auto covered = for_each_slot<Covered>(junctions.size(), threads, [&](std::size_t j) {
    Covered c{stroke(junctions[j], roads, arms[j]), {}, map::values_of(main_road(roads, arms[j]).surface).priority};
    for (const Ring& ring : c.rings)
      for (const Vec2 p : ring) c.box.grow(p);
    return c;
  });
  Neighbours neighbours(covered);
  const auto lies_over = [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(-covered[a].priority, junctions[a].places.front()) <
           std::tuple(-covered[b].priority, junctions[b].places.front());
  };
  std::vector<std::vector<std::uint32_t>> above(junctions.size());
  for (std::uint32_t j = 0; j < junctions.size(); ++j)
    for (const std::uint32_t other : neighbours.touching(j))
      if (lies_over(other, j)) above[j].push_back(other);
  return for_each_slot<std::vector<Polygon>>(junctions.size(), threads, [&](std::size_t j) {
    const std::vector<Ring>& rings = covered[j].rings;
    std::vector<OwnedSegment> segments;
    for (const std::uint32_t other : above[j])
      if (may_share(covered[other], covered[j]))
        for (const Ring& ring : covered[other].rings) add_ring(segments, ring, 0);
    if (segments.empty() && rings.size() == 1) return std::vector<Polygon>{{rings.front(), {}}};
    for (const Ring& ring : rings) add_ring(segments, ring, 1);
    return trimmed(std::move(overlay(segments, 2)[1]));
  });
}

}  // namespace citykiln::roads

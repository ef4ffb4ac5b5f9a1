#include "compiler/ground/water/river_network.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/profile.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/inside_rings.h"

namespace citykiln::ground {
namespace {

constexpr double kRiverStep_m = 0.125;
// Finer terrain shows the stones of the bed.
constexpr double kClosestStops_m = 8;
// Sampling distance: finds ditches between two ponds and causeways of this width.
constexpr double kLook_m = 8;
// Places across a line on each of its sides.
constexpr int kAcross = 4;
// Weight of a metre of shore against a metre of river: heightmaps see shores better than beds between trees and in
// gorges.
constexpr std::int64_t kShoreWeight = 8;
constexpr std::int64_t kSeaWeight = std::int64_t{1} << 44;

// An interval of a line within standing water.
struct Wet {
  double from_m, to_m;
  std::uint32_t water;
};

struct Axis {
  const Polyline* points;
  std::vector<double> along;
  std::vector<Wet> wets;
  bool is_covered = false;
  double length_m() const { return along.back(); }
};

Vec2 point_on_axis(const Axis& axis, double at_m) {
  const auto after = std::upper_bound(axis.along.begin(), axis.along.end(), at_m);
  const std::size_t i =
      std::clamp<std::size_t>(static_cast<std::size_t>(after - axis.along.begin()), 1, axis.along.size() - 1);
  const double t = (at_m - axis.along[i - 1]) / std::max(axis.along[i] - axis.along[i - 1], kQuantum_m);
  const Vec2 a = (*axis.points)[i - 1], b = (*axis.points)[i];
  return a + (b - a) * std::clamp(t, 0.0, 1.0);
}

// Standing polygons, from the top down.
struct StandingCover {
  std::vector<BandedRings> rings;
  std::vector<std::uint32_t> water;
  std::vector<std::pair<Vec2, std::uint32_t>> shore;  // vertices and their waters, sorted

  std::uint32_t water_at(Vec2 p, std::span<const std::uint32_t> near) const {
    for (const std::uint32_t i : near)
      if (is_inside(rings[i], p)) return water[i];
    return kNoWater;
  }

  std::uint32_t water_with_vertex(Vec2 p) const {
    const auto found = std::lower_bound(shore.begin(), shore.end(), std::pair(p, std::uint32_t{0}));
    return found != shore.end() && found->first == p ? found->second : kNoWater;
  }
};

StandingCover cover_of(std::span<const LandCoverPolygon> surfaces, const StandingWaters& waters) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i)
    if (waters.water_of[i] != kNoWater) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return covers(surfaces[a], surfaces[b]); });
  StandingCover cover;
  for (const std::uint32_t i : order) {
    cover.rings.push_back(band_rings(surfaces[i]));
    cover.water.push_back(waters.water_of[i]);
    for (const Ring& ring : surfaces[i].rings)
      for (const Vec2 p : ring) cover.shore.emplace_back(p, waters.water_of[i]);
  }
  std::sort(cover.shore.begin(), cover.shore.end());
  return cover;
}

// Bisects between two places, of which one is in the water, to find the shore within 1/8 m.
double shore_between(const Axis& axis, const StandingCover& cover, std::span<const std::uint32_t> near, double dry_m,
                     double wet_m, std::uint32_t water) {
  while (std::abs(wet_m - dry_m) > kRiverStep_m / 2) {
    const double middle_m = (dry_m + wet_m) / 2;
    (cover.water_at(point_on_axis(axis, middle_m), near) == water ? wet_m : dry_m) = middle_m;
  }
  return wet_m;
}

// Returns all vertices and places at most kLook_m apart between them.
std::vector<double> places_to_look(const Axis& axis) {
  std::vector<double> places = {0};
  for (std::size_t i = 1; i < axis.along.size(); ++i) {
    const double from_m = axis.along[i - 1], long_m = axis.along[i] - from_m;
    const int n = std::max(1, static_cast<int>(std::ceil(long_m / kLook_m)));
    for (int k = 1; k <= n; ++k) places.push_back(from_m + long_m * k / n);
  }
  return places;
}

std::vector<Wet> find_wets(const Axis& axis, const StandingCover& cover) {
  const Box2 box = box_of(*axis.points);
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < cover.rings.size(); ++i)
    if (cover.rings[i].box.touches(box)) near.push_back(i);
  std::vector<Wet> wets;
  if (near.empty()) return wets;
  double before_m = 0;
  std::uint32_t before = kNoWater;
  for (const double at_m : places_to_look(axis)) {
    const std::uint32_t here = cover.water_at(point_on_axis(axis, at_m), near);
    if (here != before && before != kNoWater)
      wets.back().to_m = shore_between(axis, cover, near, at_m, before_m, before);
    if (here != before && here != kNoWater)
      wets.push_back({at_m > 0 ? shore_between(axis, cover, near, before_m, at_m, here) : 0, axis.length_m(), here});
    before_m = at_m, before = here;
  }
  return wets;
}

// Widens intervals to whole eighths of a metre, so that water is level over its shore, and joins those that touch.
std::vector<Wet> widened(const std::vector<Wet>& wets, double length_m) {
  std::vector<Wet> wide;
  for (const Wet& wet : wets) {
    const double from_m = std::floor(wet.from_m / kRiverStep_m) * kRiverStep_m;
    const double to_m = std::min(std::ceil(wet.to_m / kRiverStep_m) * kRiverStep_m, length_m);
    if (!wide.empty() && wide.back().water == wet.water && from_m <= wide.back().to_m)
      wide.back().to_m = to_m;
    else if (wide.empty() || wide.back().to_m <= to_m)
      wide.push_back({wide.empty() ? from_m : std::max(from_m, wide.back().to_m), to_m, wet.water});
  }
  return wide;
}

Axis axis_of(const Polyline& points, bool is_covered, const StandingCover& cover) {
  Axis axis{&points, roads::distances_along(points, 0), {}, is_covered};
  if (!is_covered) axis.wets = widened(find_wets(axis, cover), axis.length_m());
  return axis;
}

const Wet* wet_at(const Axis& axis, double at_m) {
  const auto after = std::ranges::lower_bound(axis.wets, at_m, {}, &Wet::to_m);
  return after != axis.wets.end() && after->from_m <= at_m ? &*after : nullptr;
}

struct VertexUse {
  Vec2 at;
  std::uint32_t line, vertex;
  auto operator<=>(const VertexUse&) const = default;
};

std::vector<VertexUse> all_vertices(std::span<const Axis> axes) {
  std::vector<VertexUse> uses;
  for (std::uint32_t l = 0; l < axes.size(); ++l)
    for (std::uint32_t v = 0; v < axes[l].points->size(); ++v) uses.push_back({(*axes[l].points)[v], l, v});
  std::sort(uses.begin(), uses.end());
  return uses;
}

bool is_end(const Axis& axis, std::uint32_t vertex) { return vertex == 0 || vertex + 1 == axis.points->size(); }

class NetworkMaker {
 public:
  NetworkMaker(std::span<const Axis> axes, const StandingCover& cover, const StandingWaters& waters,
               const map::Heightfield& heights)
      : axes_(axes), cover_(cover), heights_(heights), marks_(axes.size()) {
    for (const StandingWater& water : waters.waters)
      network_.nodes.push_back({water.level_m, water.level_m, weight_of(water)});
    network_.water_count = waters.waters.size();
  }

  RiverNetwork make() {
    mark_meetings();
    mark_shores();
    for (std::uint32_t l = 0; l < axes_.size(); ++l) network_.lines.push_back({stops_of(l)});
    return std::move(network_);
  }

 private:
  static std::int64_t weight_of(const StandingWater& water) {
    if (water.is_sea) return kSeaWeight;
    return static_cast<std::int64_t>(std::min(water.shore_m, 1e6)) * 1000 * kShoreWeight;
  }

  double land_m(Vec2 p) const { return std::floor(height_m_at(heights_, p) / kProfileQuantum_m) * kProfileQuantum_m; }

  // The lowest land on a line across the axis that is as long as the lateral error to both sides.
  double lowest_across_m(const Axis& axis, double at_m) const {
    const Vec2 at = point_on_axis(axis, at_m);
    const Vec2 along = point_on_axis(axis, at_m + kLook_m) - point_on_axis(axis, at_m - kLook_m);
    const double long_m = length(along), aside_m = kMappedError_m + heights_.longer_sample_step_m() / 2;
    double lowest_m = land_m(at);
    if (long_m == 0) return lowest_m;
    const Vec2 across{-along.y / long_m, along.x / long_m};
    for (int k = 1; k <= kAcross; ++k)
      for (const double side : {-1.0, 1.0}) {
        const Vec2 p = at + across * (side * aside_m * k / kAcross);
        if (heights_.box().contains(p)) lowest_m = std::min(lowest_m, land_m(p));
      }
    return lowest_m;
  }

  std::uint32_t add_node(Vec2 at) {
    network_.nodes.push_back({land_m(at), land_m(at), 1});
    return static_cast<std::uint32_t>(network_.nodes.size() - 1);
  }

  // adds a node for every end and every vertex used more than once
  void mark_meetings() {
    const std::vector<VertexUse> uses = all_vertices(axes_);
    for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
      while (last < uses.size() && uses[last].at == uses[first].at) ++last;
      const std::span<const VertexUse> here(uses.data() + first, last - first);
      if (here.size() < 2 && !is_end(axes_[here[0].line], here[0].vertex)) continue;
      const std::uint32_t node = node_of(here);
      for (const VertexUse& use : here) {
        const double at_m = axes_[use.line].along[use.vertex];
        if (wet_at(axes_[use.line], at_m) == nullptr) marks_[use.line].push_back({at_m, node, true});
      }
    }
  }

  // returns the standing water that any of the lines is in or has its shore at; else a new node
  std::uint32_t node_of(std::span<const VertexUse> here) {
    for (const VertexUse& use : here)
      if (const Wet* wet = wet_at(axes_[use.line], axes_[use.line].along[use.vertex])) return wet->water;
    const std::uint32_t water = cover_.water_with_vertex(here[0].at);
    return water != kNoWater ? water : add_node(here[0].at);
  }

  void mark_shores() {
    for (std::size_t l = 0; l < axes_.size(); ++l) {
      for (const Wet& wet : axes_[l].wets) {
        marks_[l].push_back({wet.from_m, wet.water, true});
        if (wet.to_m > wet.from_m) marks_[l].push_back({wet.to_m, wet.water, true});
      }
      std::ranges::sort(marks_[l], {}, [](const RiverStation& s) { return std::pair(s.at_m, s.node); });
      erase_repeated(marks_[l], &RiverStation::at_m);
    }
  }

  // returns the marks and as many stations between them as fit
  std::vector<RiverStation> stops_of(std::uint32_t l) {
    const Axis& axis = axes_[l];
    std::vector<RiverStation> stops;
    for (const RiverStation& mark : marks_[l]) {
      if (!stops.empty() && !is_within_water(axis, stops.back(), mark)) fill(axis, stops, mark);
      stops.push_back(mark);
    }
    return stops;
  }

  static bool is_within_water(const Axis& axis, const RiverStation& a, const RiverStation& b) {
    const Wet* wet = wet_at(axis, a.at_m);
    return wet != nullptr && a.node == b.node && b.at_m <= wet->to_m;
  }

  void fill(const Axis& axis, std::vector<RiverStation>& stops, const RiverStation& next) {
    const RiverStation last = stops.back();
    const double long_m = next.at_m - last.at_m,
                 spacing_m = std::max(heights_.shorter_sample_step_m() / 2, kClosestStops_m);
    const int n = axis.is_covered ? 1 : static_cast<int>(std::ceil(long_m / spacing_m));
    const auto length_mm = static_cast<std::int64_t>(long_m / n * 1000);
    for (int i = 1; i < n; ++i) {
      const double at_m = snapped_to(kRiverStep_m, last.at_m + long_m * i / n);
      stops.push_back({at_m, add_node(point_on_axis(axis, at_m)), false});
      weigh(stops.back().node, axis, at_m, length_mm);
    }
    if (axis.is_covered) return;
    weigh(last.node, axis, last.at_m, length_mm / 2);
    weigh(next.node, axis, next.at_m, length_mm / 2);
  }

  void weigh(std::uint32_t number, const Axis& axis, double at_m, std::int64_t length_mm) {
    if (network_.is_water(number) || !heights_.box().contains(point_on_axis(axis, at_m))) return;
    RiverNode& node = network_.nodes[number];
    node.weight_mm += length_mm;
    node.low_m = std::min(node.low_m, lowest_across_m(axis, at_m));
  }

  std::span<const Axis> axes_;
  const StandingCover& cover_;
  const map::Heightfield& heights_;
  std::vector<std::vector<RiverStation>> marks_;  // per line
  RiverNetwork network_;
};

}  // namespace

RiverNetwork make_river_network(std::span<const roads::Strip> streams, std::span<const Polyline> covered,
                                std::span<const LandCoverPolygon> surfaces, const StandingWaters& waters,
                                const map::Heightfield& heights) {
  assert(waters.water_of.size() == surfaces.size());
  const StandingCover cover = cover_of(surfaces, waters);
  std::vector<Axis> axes;
  for (const roads::Strip& stream : streams) axes.push_back(axis_of(stream.axis, false, cover));
  for (const Polyline& line : covered) axes.push_back(axis_of(line, true, cover));
  return NetworkMaker(axes, cover, waters, heights).make();
}

}  // namespace citykiln::ground

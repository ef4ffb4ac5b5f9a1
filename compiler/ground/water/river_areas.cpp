#include "compiler/ground/water/river_areas.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/ground/cover/inside_rings.h"
#include "compiler/ground/cover/shared_borders.h"

namespace citykiln::ground {
namespace {

// Axes and banks are sampled at this distance.
constexpr double kAreaSample_m = 32;

struct AxisPlace {
  Vec2 at;
  std::uint32_t stream;
  auto operator<=>(const AxisPlace&) const = default;
};

// Visits points from a to b at most kAreaSample_m apart, without b.
template <typename Visit>
void walk(Vec2 a, Vec2 b, Visit visit) {
  const int n = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kAreaSample_m)));
  for (int i = 0; i < n; ++i) visit(a + (b - a) * (static_cast<double>(i) / n));
}

std::vector<AxisPlace> axis_places_of(std::span<const roads::Strip> streams, std::uint32_t s) {
  std::vector<AxisPlace> places;
  const Polyline& axis = streams[s].axis;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    walk(axis[i], axis[i + 1], [&](Vec2 p) { places.push_back({p, s}); });
  places.push_back({axis.back(), s});
  return places;
}

// Areas with common borders, and samples of the axes that run through them, from west to east.
struct RiverGroup {
  std::vector<std::uint32_t> surfaces;
  std::vector<BandedRings> rings;
  std::vector<AxisPlace> places;
};

std::vector<RiverGroup> group_areas(std::span<const LandCoverPolygon> surfaces) {
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].surface == map::LandCoverClass::kRiver) members.push_back(i);
  const std::vector<std::uint32_t> group = groups_of(members.size(), shared_borders(surfaces, members));
  std::vector<RiverGroup> groups(members.size());
  for (std::uint32_t m = 0; m < members.size(); ++m) {
    groups[group[m]].surfaces.push_back(members[m]);
    groups[group[m]].rings.push_back(band_rings(surfaces[members[m]]));
  }
  std::erase_if(groups, [](const RiverGroup& g) { return g.surfaces.empty(); });
  return groups;
}

void add_axes(RiverGroup& group, std::span<const roads::Strip> streams, std::span<const Box2> boxes) {
  for (std::uint32_t s = 0; s < streams.size(); ++s) {
    const auto is_near = [&](const BandedRings& rings) { return rings.box.touches(boxes[s]); };
    if (std::ranges::none_of(group.rings, is_near)) continue;
    const std::vector<AxisPlace> places = axis_places_of(streams, s);
    const bool runs_through = std::ranges::any_of(places, [&](const AxisPlace& place) {
      return std::ranges::any_of(group.rings, [&](const BandedRings& rings) { return is_inside(rings, place.at); });
    });
    if (runs_through) group.places.insert(group.places.end(), places.begin(), places.end());
  }
  std::sort(group.places.begin(), group.places.end());
}

struct Nearest {
  std::uint32_t stream = 0;
  double distance_m = INFINITY;
};

// Searches from p to both sides until the distance in x alone exceeds the nearest found.
Nearest nearest_place(const std::vector<AxisPlace>& places, Vec2 p) {
  Nearest nearest;
  const auto look = [&](const AxisPlace& place) {
    const double d = distance(place.at, p);
    if (d < nearest.distance_m || (d == nearest.distance_m && place.stream < nearest.stream))
      nearest = {place.stream, d};
    return std::abs(place.at.x - p.x) <= nearest.distance_m;
  };
  const auto middle = std::lower_bound(places.begin(), places.end(), AxisPlace{p, 0});
  for (auto east = middle; east != places.end() && look(*east);) ++east;
  for (auto west = middle; west != places.begin() && look(*--west);) continue;
  return nearest;
}

// Returns the streams nearest to some place on the area's banks, each with the farthest such place.
std::vector<Nearest> farthest_banks(const LandCoverPolygon& surface, const RiverGroup& group, const Box2& box) {
  std::vector<Nearest> farthest;
  const auto look = [&](Vec2 p) {
    if (!box.contains(p)) return;
    const Nearest nearest = nearest_place(group.places, p);
    const auto known = std::ranges::find(farthest, nearest.stream, &Nearest::stream);
    if (known == farthest.end())
      farthest.push_back(nearest);
    else
      known->distance_m = std::max(known->distance_m, nearest.distance_m);
  };
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) walk(ring[j], ring[i], look);
  return farthest;
}

double reach_for(double distance_m) {
  return std::ceil((distance_m + kAreaSample_m / 2) * 1.25 / kInfluenceStep_m) * kInfluenceStep_m;
}

void set_reaches(std::span<const LandCoverPolygon> surfaces, const RiverGroup& group, const Box2& box,
                 RiverAreas& areas) {
  for (const std::uint32_t s : group.surfaces) {
    const std::vector<Nearest> banks =
        group.places.empty() ? std::vector<Nearest>{} : farthest_banks(surfaces[s], group, box);
    const auto is_too_far = [](const Nearest& n) { return reach_for(n.distance_m) > kMaxInfluence_m; };
    areas.has_no_axis[s] = group.places.empty() || std::ranges::any_of(banks, is_too_far);
    if (areas.has_no_axis[s]) continue;
    for (const Nearest& bank : banks)
      areas.influence_radius_m[bank.stream] =
          std::max(areas.influence_radius_m[bank.stream], reach_for(bank.distance_m));
  }
}

}  // namespace

RiverAreas find_river_axes(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                           const Box2& box) {
  assert(std::ranges::none_of(streams, [](const roads::Strip& s) { return s.axis.size() < 2; }));
  RiverAreas areas{std::vector<double>(streams.size(), 0), std::vector<bool>(surfaces.size(), false)};
  std::vector<Box2> boxes;
  for (const roads::Strip& stream : streams) boxes.push_back(box_of(stream.axis));
  for (RiverGroup& group : group_areas(surfaces)) {
    add_axes(group, streams, boxes);
    set_reaches(surfaces, group, box, areas);
  }
  return areas;
}

}  // namespace citykiln::ground

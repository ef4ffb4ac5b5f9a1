#include "compiler/ground/water/measure_waters.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace citykiln::ground {
namespace {

// Less is rounding.
constexpr double kRise_m = 1e-9;
// Streams are sampled at this distance.
constexpr double kApart_m = 16;

// A sample of a stream.
struct Seen {
  double at_m;
  Vec2 at;
  double water_m;
};

std::vector<Seen> places_of(const roads::Strip& stream, const map::Heightfield& heights) {
  const std::vector<double> along = roads::distances_along(stream.axis, stream.start_along_m);
  std::vector<Seen> places;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const double long_m = along[i + 1] - along[i];
    const int n = std::max(1, static_cast<int>(std::ceil(long_m / kApart_m)));
    for (int k = 0; k < n; ++k) {
      const double t = static_cast<double>(k) / n, at_m = along[i] + long_m * t;
      const Vec2 p = stream.axis[i] + (stream.axis[i + 1] - stream.axis[i]) * t;
      places.push_back({at_m, p, water_at_station_m(stream, at_m, p, heights)});
    }
  }
  const Vec2 last = stream.axis.back();
  places.push_back({along.back(), last, water_at_station_m(stream, along.back(), last, heights)});
  return places;
}

// A vertex of a stream.
struct Passing {
  Vec2 at;
  double water_m;
  std::uint32_t stream;
};

// Compares the heights of streams at their common vertices.
void measure_meetings(std::vector<Passing>& passings, std::vector<double>& rises) {
  std::ranges::sort(passings, {}, [](const Passing& p) { return std::tuple(p.at, p.stream, p.water_m); });
  for (std::size_t first = 0, last = 0; first < passings.size(); first = last) {
    while (last < passings.size() && passings[last].at == passings[first].at) ++last;
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = first; k < last; ++k)
        if (passings[i].stream != passings[k].stream)
          rises[passings[i].stream] = std::max(rises[passings[i].stream], passings[k].water_m - passings[i].water_m);
  }
}

double rise_along_m(const std::vector<Seen>& places, const Profile& profile) {
  double rise = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) rise = std::max(rise, places[i + 1].water_m - places[i].water_m);
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) rise = std::max(rise, profile[i + 1].z_m - profile[i].z_m);
  return rise;
}

struct LevelEdge {
  Vec2 low, high;
  double level_m;
  auto operator<=>(const LevelEdge&) const = default;
};

std::size_t count_not_level(std::span<const LandCoverPolygon> surfaces) {
  std::vector<LevelEdge> edges;
  for (const LandCoverPolygon& surface : surfaces)
    for (const Ring& ring : surface.rings)
      for (std::size_t i = 0, j = ring.size() - 1; surface.level_m && i < ring.size(); j = i++)
        edges.push_back({std::min(ring[i], ring[j]), std::max(ring[i], ring[j]), *surface.level_m});
  std::sort(edges.begin(), edges.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    count += edges[i].low == edges[i + 1].low && edges[i].high == edges[i + 1].high &&
             edges[i].level_m != edges[i + 1].level_m;
  return count;
}

}  // namespace

double water_at_station_m(const roads::Strip& stream, double at_m, Vec2 there, const map::Heightfield& heights) {
  return stream.profile.empty() ? height_m_at(heights, there) : knot_at(stream.profile, at_m).z_m;
}

WaterMeasures measure_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                             const map::Heightfield& heights) {
  WaterMeasures measures;
  measures.streams = streams.size();
  measures.standing = static_cast<std::size_t>(
      std::ranges::count_if(surfaces, [](const LandCoverPolygon& s) { return s.level_m.has_value(); }));
  measures.waters_not_level = count_not_level(surfaces);
  std::vector<double> rises(streams.size(), 0);
  std::vector<Passing> passings;
  for (std::uint32_t s = 0; s < streams.size(); ++s) {
    const std::vector<Seen> places = places_of(streams[s], heights);
    rises[s] = rise_along_m(places, streams[s].profile);
    const std::vector<double> along = roads::distances_along(streams[s].axis, streams[s].start_along_m);
    for (std::size_t v = 0; v < along.size(); ++v)
      passings.push_back(
          {streams[s].axis[v], water_at_station_m(streams[s], along[v], streams[s].axis[v], heights), s});
    for (const Seen& place : places) {
      if (!heights.box().contains(place.at)) continue;
      const double above_m = place.water_m - height_m_at(heights, place.at);
      measures.highest_above_land_m = std::max(measures.highest_above_land_m, above_m);
      measures.deepest_below_land_m = std::max(measures.deepest_below_land_m, -above_m);
    }
  }
  measure_meetings(passings, rises);
  for (const double rise : rises) {
    measures.largest_rise_m = std::max(measures.largest_rise_m, rise);
    measures.streams_that_rise += rise > kRise_m;
  }
  return measures;
}

}  // namespace citykiln::ground

#include "compiler/ground/water/measure_waters.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace citykiln::ground {
namespace {

// Less is rounding.
constexpr double kRise_m = 1e-9;
// Streams are sampled at this distance.
constexpr double kStreamSample_m = 16;

// A sample of a stream.
struct StreamSample {
  double at_m;
  Vec2 at;
  double water_m;
};

// Returns the height of a stream's water at a distance along its whole way; without a profile, that of the terrain at
// `there`, the place at that distance.
double water_at_station_m(const roads::Strip& stream, double at_m, Vec2 there, const map::Heightfield& heights) {
  return stream.profile.empty() ? height_m_at(heights, there) : knot_at(stream.profile, at_m).z_m;
}

std::vector<StreamSample> samples_of_stream(const roads::Strip& stream, const map::Heightfield& heights) {
  const std::vector<double> along = roads::distances_along(stream.axis, stream.start_along_m);
  std::vector<StreamSample> places;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const double long_m = along[i + 1] - along[i];
    const int n = std::max(1, static_cast<int>(std::ceil(long_m / kStreamSample_m)));
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
struct StreamVertex {
  Vec2 at;
  double water_m;
  std::uint32_t stream;
};

// Compares the heights of streams at their common vertices.
void measure_meetings(std::vector<StreamVertex>& vertices, std::vector<double>& rises) {
  std::ranges::sort(vertices, {}, [](const StreamVertex& p) { return std::tuple(p.at, p.stream, p.water_m); });
  for (std::size_t first = 0, last = 0; first < vertices.size(); first = last) {
    while (last < vertices.size() && vertices[last].at == vertices[first].at) ++last;
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = first; k < last; ++k)
        if (vertices[i].stream != vertices[k].stream)
          rises[vertices[i].stream] = std::max(rises[vertices[i].stream], vertices[k].water_m - vertices[i].water_m);
  }
}

double rise_along_m(const std::vector<StreamSample>& places, const Profile& profile) {
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

WaterMeasures measure_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                             const map::Heightfield& heights) {
  WaterMeasures measures;
  measures.streams = streams.size();
  measures.standing = static_cast<std::size_t>(
      std::ranges::count_if(surfaces, [](const LandCoverPolygon& s) { return s.level_m.has_value(); }));
  measures.waters_not_level = count_not_level(surfaces);
  std::vector<double> rises(streams.size(), 0);
  std::vector<StreamVertex> vertices;
  for (std::uint32_t s = 0; s < streams.size(); ++s) {
    const std::vector<StreamSample> places = samples_of_stream(streams[s], heights);
    rises[s] = rise_along_m(places, streams[s].profile);
    const std::vector<double> along = roads::distances_along(streams[s].axis, streams[s].start_along_m);
    for (std::size_t v = 0; v < along.size(); ++v)
      vertices.push_back(
          {streams[s].axis[v], water_at_station_m(streams[s], along[v], streams[s].axis[v], heights), s});
    for (const StreamSample& place : places) {
      if (!heights.box().contains(place.at)) continue;
      const double above_m = place.water_m - height_m_at(heights, place.at);
      measures.highest_above_land_m = std::max(measures.highest_above_land_m, above_m);
      measures.deepest_below_land_m = std::max(measures.deepest_below_land_m, -above_m);
    }
  }
  measure_meetings(vertices, rises);
  for (const double rise : rises) {
    measures.largest_rise_m = std::max(measures.largest_rise_m, rise);
    measures.streams_that_rise += rise > kRise_m;
  }
  return measures;
}

}  // namespace citykiln::ground

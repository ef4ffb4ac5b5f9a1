#include "compiler/ground/levelling/airports.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/segment.h"
#include "compiler/ground/levelling/fitted_surface.h"
#include "compiler/map/plane/smooth_land.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

// Samples of one airport to which its surface is fitted, at most about.
constexpr std::size_t kMostFitted = 4096;
// Smaller areas are no airports.
constexpr double kLeastAirport_m2 = 10'000;

// Calls each(column, row) for the samples in a box.
template <typename Each>
void for_each_sample(const map::Heightfield& samples, const Box2& box, Each each) {
  const auto within = [](double at, int count) { return static_cast<int>(std::clamp(at, 0.0, count - 1.0)); };
  const Vec2 from = box.min - samples.min, to = box.max - samples.min;
  for (int j = within(from.y / samples.step_m.y, samples.rows); j <= within(to.y / samples.step_m.y, samples.rows); ++j)
    for (int i = within(from.x / samples.step_m.x, samples.columns);
         i <= within(to.x / samples.step_m.x, samples.columns); ++i)
      each(i, j);
}

struct AirportSamples {
  const map::Heightfield& samples;
  std::vector<std::uint32_t> numbers{};  // row by row

  // Cells under the strip have all of their samples on the surface.
  double beyond_m() const { return kAirportStrip_m + length(samples.step_m); }

  void add(const Box2& box, const std::function<bool(Vec2)>& contains) {
    for_each_sample(samples, box, [&](int i, int j) {
      if (contains(samples.vertex(i, j))) numbers.push_back(static_cast<std::uint32_t>(j * samples.columns + i));
    });
  }

  void add_line(const map::Track& track) {
    const double reach_m = map::carriageway_width_m(track.section) / 2 + beyond_m();
    for (std::size_t s = 0; s + 1 < track.axis.size(); ++s) {
      const Vec2 a = track.axis[s], b = track.axis[s + 1];
      add(box_of_segment(a, b).widened(reach_m), [&](Vec2 p) { return distance_to_segment(a, b, p) <= reach_m; });
    }
  }

  void add_area(const Ring& ring) {
    add(box_of(ring).widened(beyond_m()),
        [&](Vec2 p) { return winding_number(ring, p) != 0 || distance_to_ring(ring, p) <= beyond_m(); });
  }
};

std::vector<std::uint32_t> samples_in_airports(const map::Heightfield& samples, const map::FeatureView& features) {
  AirportSamples found{samples};
  for (const map::Track& track : features.tracks)
    if (track.surface == LandCoverClass::kRunway && track.passage == map::Passage::kGround) found.add_line(track);
  for (const map::AreaFeature& area : features.areas)
    if (area.surface == LandCoverClass::kRunway ||
        (area.surface == LandCoverClass::kApron && area.area_m2 > kLeastApron_m2))
      found.add_area(area.polygon.outer);
  sort_unique(found.numbers);
  return std::move(found.numbers);
}

// The neighbours of a sample, with their distances.
template <typename Each>
void for_each_neighbour(const map::Heightfield& samples, std::uint32_t number, Each each) {
  const int columns = samples.columns, i = static_cast<int>(number) % columns, j = static_cast<int>(number) / columns;
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      if ((di == 0 && dj == 0) || i + di < 0 || i + di >= columns || j + dj < 0 || j + dj >= samples.rows) continue;
      each(static_cast<std::uint32_t>((j + dj) * columns + i + di),
           length(Vec2{di * samples.step_m.x, dj * samples.step_m.y}));
    }
}

// The connected groups of samples, each sorted.
std::vector<std::vector<std::uint32_t>> airports_of(const map::Heightfield& samples,
                                                    std::span<const std::uint32_t> numbers) {
  std::vector<bool> is_taken(numbers.size());
  std::vector<std::vector<std::uint32_t>> airports;
  for (std::size_t first = 0; first < numbers.size(); ++first) {
    if (is_taken[first]) continue;
    is_taken[first] = true;
    std::vector<std::uint32_t> airport{numbers[first]};
    for (std::size_t next = 0; next < airport.size(); ++next)
      for_each_neighbour(samples, airport[next], [&](std::uint32_t number, double) {
        const auto found = std::ranges::lower_bound(numbers, number);
        if (found == numbers.end() || *found != number || is_taken[static_cast<std::size_t>(found - numbers.begin())])
          return;
        is_taken[static_cast<std::size_t>(found - numbers.begin())] = true;
        airport.push_back(number);
      });
    std::ranges::sort(airport);
    airports.push_back(std::move(airport));
  }
  return airports;
}

Vec2 place_of(const map::Heightfield& samples, std::uint32_t number) {
  return samples.vertex(static_cast<int>(number) % samples.columns, static_cast<int>(number) / samples.columns);
}

FittedSurface surface_of_airport(const map::Heightfield& samples, std::span<const std::uint32_t> airport) {
  const std::size_t every = airport.size() / kMostFitted + 1;
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < airport.size(); k += every) {
    const Vec2 at = place_of(samples, airport[k]);
    points.push_back({at.x, at.y, samples.heights[airport[k]] * map::kHeightQuantum_m});
  }
  return fitted_surface(points, SurfaceForm::kBent, kAirportSlope);
}

std::int32_t sample_at_m(double height_m) {
  return static_cast<std::int32_t>(std::floor(height_m / map::kHeightQuantum_m + 0.5));
}

// Lays the land about an airport between banks, outwards until it lies between them already (Dijkstra 1959).
class Banks {
 public:
  Banks(map::Heightfield& samples, const FittedSurface& surface, std::span<const std::uint32_t> airport)
      : samples_(samples), surface_(surface) {
    for (const std::uint32_t number : airport) improve(number, 0, number);
  }

  void lay() {
    while (!queue_.empty()) {
      const auto [away_m, number] = queue_.top();
      queue_.pop();
      const Reached reached = reached_.at(number);
      if (away_m > reached.away_m || !move(number, reached)) continue;
      for_each_neighbour(samples_, number,
                         [&](std::uint32_t to, double step_m) { improve(to, reached.away_m + step_m, reached.from); });
    }
  }

 private:
  struct Reached {
    double away_m = 0;
    std::uint32_t from = 0;  // the sample of the airport
  };

  void improve(std::uint32_t number, double away_m, std::uint32_t from) {
    if (away_m > kMostAirportBank_m) return;
    const auto [found, is_new] = reached_.try_emplace(number, Reached{away_m, from});
    if (!is_new && found->second.away_m <= away_m) return;
    found->second = {away_m, from};
    queue_.push({away_m, number});
  }

  // Returns false where the land lies between the banks.
  bool move(std::uint32_t number, const Reached& reached) {
    const double surface_m = surface_.height_m(place_of(samples_, reached.from));
    const double off_m = samples_.heights[number] * map::kHeightQuantum_m - surface_m;
    const double bank_m =
        std::max(kAirportBank * reached.away_m, std::abs(off_m) * reached.away_m / kMostAirportBank_m);
    if (reached.away_m > 0 && std::abs(off_m) <= bank_m) return false;
    samples_.heights[number] = sample_at_m(surface_m + std::copysign(std::min(std::abs(off_m), bank_m), off_m));
    return true;
  }

  using Next = std::pair<double, std::uint32_t>;
  map::Heightfield& samples_;
  const FittedSurface& surface_;
  std::unordered_map<std::uint32_t, Reached> reached_;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue_;
};

}  // namespace

map::Heightfield with_level_airports(const map::Heightfield& heights, const map::FeatureView& features) {
  const int parts = heights.parts;
  map::Heightfield samples = map::samples_of(heights);
  const std::vector<std::uint32_t> numbers = samples_in_airports(samples, features);
  if (numbers.empty()) return heights;
  const double sample_m2 = samples.step_m.x * samples.step_m.y;
  for (const std::vector<std::uint32_t>& airport : airports_of(samples, numbers)) {
    if (static_cast<double>(airport.size()) * sample_m2 < kLeastAirport_m2) continue;
    const FittedSurface surface = surface_of_airport(samples, airport);
    Banks(samples, surface, airport).lay();
  }
  return map::smooth_land(std::move(samples), parts);
}

}  // namespace citykiln::ground

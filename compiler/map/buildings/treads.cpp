#include "compiler/map/buildings/treads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/part_outlines.h"
#include "compiler/map/buildings/uncovered_pieces.h"

namespace citykiln::map {
namespace {

// Usual steps; treads are at least as deep as a ladder's.
constexpr double kStepRise_m = 0.17, kStepDepth_m = 0.3, kLeastDepth_m = 0.125;
constexpr double kMostTreads = 100;

bool are_steps(const Footprint& f) { return f.building_class == static_cast<std::uint8_t>(BuildingClass::kSteps); }

// The outward normal of the edge that faces most away from a place, or of the longest edge.
Vec2 descent(const Footprint& steps, const Footprint* outline) {
  if (steps.roof.direction) return *steps.roof.direction;
  const Ring& ring = steps.polygon.outer;
  const Vec2 away = outline ? centroid(steps.polygon) - centroid(outline->polygon) : Vec2{};
  double best = -std::numeric_limits<double>::infinity();
  Vec2 down{1, 0};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    if (length(along) == 0) continue;
    const Vec2 normal = unit(left_of(along)) * -1;
    const double rank = dot(normal, away) * length(along) + length(along) / 1024;
    if (rank > best) best = rank, down = normal;
  }
  return down;
}

// Where steps lie along the direction of descent, as distances from the origin.
struct Flight {
  Vec2 down;
  double top_at_m, bottom_at_m;
  double low_m, high_m;
};

Flight flight_of(const Footprint& steps, const Footprint* outline) {
  Flight flight{descent(steps, outline), std::numeric_limits<double>::infinity(), 0, steps.min_height_m,
                steps.height_m};
  flight.bottom_at_m = -flight.top_at_m;
  for (const Vec2 p : steps.polygon.outer) {
    flight.top_at_m = std::min(flight.top_at_m, dot(flight.down, p));
    flight.bottom_at_m = std::max(flight.bottom_at_m, dot(flight.down, p));
  }
  const double run_m = flight.bottom_at_m - flight.top_at_m;
  if (steps.has_default_height && steps.roof.height_m == 0)
    flight.high_m = flight.low_m + std::min(steps.height_m - steps.min_height_m, run_m * kStepRise_m / kStepDepth_m);
  else if (steps.has_default_height)
    flight.high_m = flight.low_m + steps.roof.height_m;
  else if (steps.roof.height_m > 0 && steps.has_roof_in_height)
    flight.low_m = std::max(flight.low_m, flight.high_m - steps.roof.height_m);
  else if (steps.roof.height_m > 0)
    flight.low_m = flight.high_m, flight.high_m += steps.roof.height_m;
  return flight;
}

// A rectangle that covers what lies between two distances along the descent.
Polygon strip(const Flight& flight, Vec2 about, double from_m, double to_m, double half_width_m) {
  const Vec2 across = left_of(flight.down), origin = across * dot(across, about);
  return {{origin + flight.down * from_m - across * half_width_m, origin + flight.down * to_m - across * half_width_m,
           origin + flight.down * to_m + across * half_width_m, origin + flight.down * from_m + across * half_width_m},
          {}};
}

std::vector<Footprint> treads_of(const Footprint& steps, const Footprint* outline) {
  const Flight flight = flight_of(steps, outline);
  const double run_m = flight.bottom_at_m - flight.top_at_m, rise_m = flight.high_m - flight.low_m;
  const double most = std::clamp(std::floor(run_m / kLeastDepth_m), 1.0, kMostTreads);
  const double count = std::clamp(std::floor(rise_m / kStepRise_m + 0.5), 1.0, most);
  const Vec2 about = steps.polygon.outer.front();
  const double reach_m = run_m + length(box_of(steps.polygon.outer).max - box_of(steps.polygon.outer).min);
  std::vector<Footprint> treads;
  for (double i = 0; i < count; ++i) {
    const double from_m = flight.top_at_m + run_m * (i / count), to_m = flight.top_at_m + run_m * ((i + 1) / count);
    const std::array outside{strip(flight, about, flight.top_at_m - reach_m, from_m, reach_m),
                             strip(flight, about, to_m, flight.bottom_at_m + reach_m, reach_m)};
    for (Polygon& polygon : difference(steps.polygon, outside)) {
      Footprint tread = steps;
      tread.id = piece_id(steps.id, static_cast<std::uint32_t>(treads.size()));
      tread.polygon = std::move(polygon);
      tread.height_m = snapped(flight.high_m - rise_m * (i / count));
      tread.has_roof_in_height = tread.has_roof_shape = true, tread.roof = {};
      tread.has_default_height = false;
      treads.push_back(std::move(tread));
    }
  }
  return treads;
}

}  // namespace

std::vector<Footprint> with_treads(std::vector<Footprint> footprints, std::span<const std::uint32_t> outlines,
                                   Account& account, Report& report) {
  std::vector<Footprint> all;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Footprint* outline = outlines[i] != kNoOutline ? &footprints[outlines[i]] : nullptr;
    if (!are_steps(footprints[i]) || footprints[i].has_parts || footprints[i].polygon.outer.size() < 3) continue;
    std::vector<Footprint> treads = treads_of(footprints[i], outline);
    if (treads.empty()) continue;
    const std::uint64_t counts = report.counts(footprints[i].id.osm);
    account.split += counts * (treads.size() - 1), account.out += counts * (treads.size() - 1);
    for (std::size_t k = 1; k < treads.size(); ++k) all.push_back(std::move(treads[k]));
    footprints[i] = std::move(treads[0]);
  }
  footprints.insert(footprints.end(), std::make_move_iterator(all.begin()), std::make_move_iterator(all.end()));
  return footprints;
}

}  // namespace citykiln::map

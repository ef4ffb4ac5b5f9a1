// Fields of farmland and meadows: as mapped one by one, and as land of which the borders are left out is divided.
#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/segment.h"
#include "tests/charts/assumed_lands.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

constexpr double kHa_m2 = 1e4, kKm2_m2 = 1e6;
/// Borders are compared at the places of a grid. A border is at a place if it is this near.
constexpr double kPlaces_m = 16, kAtBorder_m = 15;
constexpr double kPieceBucket_m = 64;
/// Assumed fields on both sides of a border are at most this far apart.
constexpr double kAssumedGap_m = 1;

/// The fields of one land, and the area of the land.
struct FieldsOfLand {
  std::vector<double> fields_m2;
  double land_m2 = 0;

  double median_ha() const {
    std::vector<double> sorted_m2 = fields_m2;
    std::ranges::sort(sorted_m2);
    return sorted_m2.empty() ? land_m2 / kHa_m2 : sorted_m2[sorted_m2.size() / 2] / kHa_m2;
  }
  /// Undivided land is one field.
  double per_km2() const { return static_cast<double>(std::max<std::size_t>(fields_m2.size(), 1)) * kKm2_m2 / land_m2; }
};

bool is_of_land(const map::AreaFeature& area) {
  return area.surface == map::LandCoverClass::kFarmland || area.surface == map::LandCoverClass::kMeadow ||
         map::is_field(area.surface);
}

/// The assumed fields of each land of features that have joined fields, by the land's element.
std::map<OsmId, FieldsOfLand> assumed_fields(const map::Features& features) {
  std::map<OsmId, FieldsOfLand> lands;
  for (const map::AreaFeature& area : features.areas) {
    if (!is_of_land(area)) continue;
    const double own_m2 = area_m2(area.polygon);
    FieldsOfLand& land = lands[area.id.osm];
    if (!is_of_field(area.id))
      land.land_m2 += own_m2;
    else if (own_m2 >= kLeastField_m2)
      land.fields_m2.push_back(own_m2);
  }
  std::erase_if(lands, [](const auto& land) { return land.second.land_m2 <= 0; });
  return lands;
}

Values values_of_lands(const map::Features& features, double (FieldsOfLand::*value)() const) {
  Values values;
  for (const auto& [id, land] : assumed_fields(features)) values[{id, 0}] = (land.*value)();
  return values;
}

/// The parts of the mapped fields of a land between the lines that divide them.
std::vector<Polygon> mapped_parts(const Land& land, const DividingWays& ways) {
  std::vector<Polygon> parts;
  for (const map::AreaFeature* field : land.fields)
    for (Polygon& part : parts_between(field->polygon, ways)) parts.push_back(std::move(part));
  return parts;
}

double area_of_land_m2(const Land& land) {
  double all_m2 = 0;
  for (const Polygon& outline : land.outlines) all_m2 += area_m2(outline);
  return all_m2;
}

/// Samples of each mapped field on lands of a class: value(area of the field, number of the fields of its land, area of
/// the land).
template <typename Value>
std::vector<Sample> field_samples(const Place& place, map::LandCoverClass surface, Value value) {
  const DividingWays ways = dividing_ways(place.mapped);
  std::vector<Sample> samples;
  for (const Land& land : lands_of(place.mapped)) {
    if (land.surface != surface) continue;
    const std::vector<Polygon> parts = mapped_parts(land, ways);
    const double land_m2 = area_of_land_m2(land);
    for (const Polygon& part : parts)
      samples.push_back({.key = {land.id.osm, 0},
                         .at = box_of(part.outer).centre(),
                         .tagged = value(area_m2(part), parts.size(), land_m2)});
  }
  return samples;
}

double hectares(double field_m2, std::size_t, double) { return field_m2 / kHa_m2; }

/// Straight pieces of lines, found by place.
struct PieceIndex {
  std::vector<BorderPiece> pieces;
  BoxGrid grid;

  explicit PieceIndex(std::vector<BorderPiece> all) : pieces(std::move(all)) {
    std::vector<Box2> boxes;
    for (const auto& [a, b] : pieces) boxes.push_back(box_of_segment(a, b));
    if (!boxes.empty()) grid = grid_of(boxes, kPieceBucket_m);
  }
  bool is_at(Vec2 p) const {
    return !pieces.empty() && any_about(grid, Box2{p, p}.widened(kAtBorder_m), [&](std::uint32_t i) {
      return distance_to_segment(pieces[i].first, pieces[i].second, p) <= kAtBorder_m;
    });
  }
};

/// Calls visit(key, place) for each place of the grid in a polygon.
template <typename Visit>
void for_each_place(const Polygon& land, Visit visit) {
  constexpr std::int64_t kPlacesInRow = 1 << 24;
  const Box2 box = box_of(land.outer);
  const auto number = [](double v) { return static_cast<std::int64_t>(std::floor(v / kPlaces_m)); };
  for (std::int64_t row = number(box.min.y); row <= number(box.max.y); ++row)
    for (std::int64_t column = number(box.min.x); column <= number(box.max.x); ++column) {
      const Vec2 at{(static_cast<double>(column) + 0.5) * kPlaces_m, (static_cast<double>(row) + 0.5) * kPlaces_m};
      if (contains(land, at)) visit(ValueKey{{OsmType::kLot, row * kPlacesInRow + column}, 0}, at);
    }
}

/// Drops samples, evenly, until `count` are left.
std::vector<Sample> thinned_to(std::size_t count, const std::vector<Sample>& samples) {
  std::vector<Sample> kept;
  for (std::size_t i = 0; i < count; ++i) kept.push_back(samples[i * samples.size() / count]);
  return kept;
}

}  // namespace

std::vector<Sample> tagged_field_sizes(const Place& place) {
  return field_samples(place, map::LandCoverClass::kFarmland, hectares);
}
std::vector<Sample> tagged_meadow_sizes(const Place& place) {
  return field_samples(place, map::LandCoverClass::kMeadow, hectares);
}
Values built_field_sizes(const map::Features& features) { return values_of_lands(features, &FieldsOfLand::median_ha); }

std::vector<Sample> tagged_fields_per_km2(const Place& place) {
  return field_samples(place, map::LandCoverClass::kFarmland, [](double, std::size_t fields, double land_m2) {
    return static_cast<double>(fields) * kKm2_m2 / land_m2;
  });
}
Values built_fields_per_km2(const map::Features& features) { return values_of_lands(features, &FieldsOfLand::per_km2); }

std::vector<Sample> tagged_field_borders(const Place& place) {
  const PieceIndex ways(dividing_ways(place.mapped).pieces);
  std::vector<Sample> samples;
  for (const Land& land : lands_of(place.mapped)) {
    const PieceIndex borders(land.borders);
    std::vector<Sample> at_border, elsewhere;
    for (const Polygon& outline : land.outlines)
      for_each_place(outline, [&](const ValueKey& key, Vec2 at) {
        if (ways.is_at(at)) return;
        const bool is_at = borders.is_at(at);
        (is_at ? at_border : elsewhere).push_back({.key = key, .at = at, .tagged = is_at ? 1.0 : 0.0});
      });
    for (const std::vector<Sample>* all : {&at_border, &elsewhere}) {
      const std::vector<Sample> kept = thinned_to(std::min(at_border.size(), elsewhere.size()), *all);
      samples.insert(samples.end(), kept.begin(), kept.end());
    }
  }
  return samples;
}

Values built_field_borders(const map::Features& features) {
  std::map<OsmId, std::vector<const Polygon*>> fields;
  for (const map::AreaFeature& area : features.areas)
    if (is_of_land(area) && is_of_field(area.id)) fields[area.id.osm].push_back(&area.polygon);
  Values values;
  for (const map::AreaFeature& land : features.areas) {
    if (!is_of_land(land) || is_of_field(land.id)) continue;
    const PieceIndex borders(inner_borders(fields[land.id.osm], kAssumedGap_m));
    for_each_place(land.polygon, [&](const ValueKey& key, Vec2 at) { values[key] = borders.is_at(at) ? 1 : 0; });
  }
  return values;
}

}  // namespace citykiln::charts

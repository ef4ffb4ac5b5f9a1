#include "compiler/cars/bay_places.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"

namespace citykiln::cars {
namespace {

using pitches::PitchKind;

// The bays of pitches.inc.
constexpr double kBay_m = 2.5, kBayDepth_m = 5;
// Mapped spaces may be as narrow as a car.
constexpr double kSpace_m = 2;
// The shortest drive on which a car has room.
constexpr double kLeastDrive_m = 4.75;
// The distances of places on plots from its borders; grass lies at the rear.
constexpr double kFromSide_m = 3, kFromFront_m = 1, kFromRear_m = 2.5;

// Equal for the pitch in all tiles; pitches of one area have the same id.
StableId key_of(const pitches::Pitch& pitch) {
  const auto steps = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v / kQuantum_m)); };
  return stable_id(stable_id(stable_id(pitch.id), "bays", steps(pitch.from.x)), "bays", steps(pitch.from.y));
}

// A bay whose mouth is towards -ahead.
Place bay(StableId key, const pitches::Pitch& pitch, Vec2 at, Vec2 ahead, map::CountryGroup country) {
  return {.key = key,
          .feature = pitch.id.osm,
          .at = at,
          .ahead = ahead,
          .length_m = kBayDepth_m,
          .width_m = kBay_m,
          .kind = PlaceKind::kBay,
          .use = PlaceUse::kCarPark,
          .country = country,
          .may_turn = true};
}

}  // namespace

std::vector<Place> places_in_bays(const pitches::Pitch& pitch, map::CountryGroup country) {
  const bool is_two_rows = pitch.kind == PitchKind::kBaysOfRows;
  if (!is_two_rows && pitch.kind != PitchKind::kBaysOfRow) return {};
  const Vec2 along = unit(pitch.to - pitch.from), left = left_of(along), middle = (pitch.from + pitch.to) * 0.5;
  const double row_m = distance(pitch.from, pitch.to) / 2 - kBayDepth_m / 2;
  const int bays = static_cast<int>(pitch.width_m / kBay_m + 0.5);
  std::vector<Place> places;
  for (const double end : {1.0, -1.0}) {
    // a single row lies at the end `to`
    if (end < 0 && !is_two_rows) break;
    for (int i = 0; i < bays; ++i) {
      const double across_m = (i + 0.5) * kBay_m - pitch.width_m / 2;
      const StableId key = stable_id(key_of(pitch), "bay", 2 * static_cast<std::uint64_t>(i) + (end > 0));
      places.push_back(bay(key, pitch, middle + along * (end * row_m) + left * across_m, along * end, country));
    }
  }
  return places;
}

std::vector<Place> places_on_drives(const lots::Yard& yard) {
  const lots::Frame frame = lots::frame_at(yard.frame);
  std::vector<Place> places;
  for (std::size_t i = 0; i < yard.strips.size(); ++i) {
    const lots::YardStrip& strip = yard.strips[i];
    const Vec2 a = frame.plane(strip.from), b = frame.plane(strip.to);
    if (!strip.is_drive || distance(a, b) < kLeastDrive_m) continue;
    const bool is_inward = strip.to.y >= strip.from.y;
    places.push_back({.key = stable_id(stable_id(yard.building), "drive", i),
                      .feature = yard.building.osm,
                      .at = (a + b) * 0.5,
                      .ahead = unit(is_inward ? b - a : a - b),
                      .length_m = std::min(distance(a, b), kBayDepth_m),
                      .width_m = 2,
                      .kind = PlaceKind::kDrive,
                      .use = PlaceUse::kDrive,
                      .country = yard.country,
                      .may_turn = true});
  }
  return places;
}

std::vector<Place> places_on_plot(const lots::Yard& plot) {
  if (plot.kind != lots::LotKind::kCarPark || plot.polygon.outer.size() != 4) return {};
  // the ring runs from the front left corner along the front
  const Ring& ring = plot.polygon.outer;
  const Vec2 along = unit(ring[1] - ring[0]), back = unit(ring[3] - ring[0]);
  const double width_m = distance(ring[0], ring[1]) - 2 * kFromSide_m, depth_m = distance(ring[0], ring[3]);
  const int count = static_cast<int>(width_m / kBay_m);
  std::vector<Place> places;
  for (const bool is_rear : {false, true})
    for (int i = 0; i < count; ++i) {
      const double x_m = kFromSide_m + (i + 0.5) * kBay_m,
                   y_m = is_rear ? depth_m - kFromRear_m - kBayDepth_m / 2 : kFromFront_m + kBayDepth_m / 2;
      const auto number = static_cast<std::uint64_t>(2 * i + (is_rear ? 1 : 0));
      places.push_back({.key = stable_id(stable_id(plot.building), "plot", number),
                        .feature = plot.building.osm,
                        .at = ring[0] + along * x_m + back * y_m,
                        .ahead = is_rear ? back : back * -1.0,
                        .length_m = kBayDepth_m,
                        .width_m = kBay_m,
                        .kind = PlaceKind::kPlot,
                        .use = PlaceUse::kCarPark,
                        .country = plot.country,
                        .may_turn = true});
    }
  return places;
}

Place place_of_space(const things::Thing& space, map::CountryGroup country) {
  return {.key = stable_id(stable_id(space.id), "space", 0),
          .feature = space.id.osm,
          .at = space.at,
          .ahead = things::unit_vector(space.direction),
          .length_m = kBayDepth_m,
          .width_m = kSpace_m,
          .kind = PlaceKind::kSpace,
          .use = PlaceUse::kCarPark,
          .country = country,
          .may_turn = true};
}

}  // namespace citykiln::cars

#include "compiler/things/parked_cars.h"

#include <array>
#include <cmath>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/things/outline_places.h"
#include "compiler/map/things/thing_role.h"

namespace citykiln::things {
namespace {

using map::LandCoverClass;
using map::ThingFeature;

constexpr double kCarLength_m = 4.375, kCarWidth_m = 1.75, kCarHeight_m = 1.5;
// The length of a place along the kerb, and its width where cars stand side by side.
constexpr double kPlace_m = 5.8, kPlaceAcross_m = 2.6;
// Parking lanes from this width on have cars across them.
constexpr double kLeastAcross_m = 4;
// Car parks: a lane between two rows of places.
constexpr double kRow_m = 5, kLane_m = 6;
constexpr double kLargestCarPark_m = 400;
// The largest number of places of a parking lane or car park.
constexpr std::uint32_t kPlaces = 1 << 16;

constexpr std::array<map::Srgb, 8> kColours = {{{0xd9, 0xda, 0xd8},
                                                {0x1f, 0x20, 0x22},
                                                {0x6e, 0x72, 0x75},
                                                {0xb4, 0xb8, 0xba},
                                                {0x2b, 0x3f, 0x63},
                                                {0x7d, 0x22, 0x22},
                                                {0x3d, 0x4a, 0x3f},
                                                {0xa8, 0x9c, 0x86}}};

// Draws of a place.
enum : std::uint32_t { kIsOccupied, kColour, kTurned };

// A place for a car: its middle, and the direction in which a car that drove in forwards looks.
struct ParkingPlace {
  ObjectId id;
  Vec2 at, ahead;
};

class Cars {
 public:
  Cars(FreePlaces& places, std::uint64_t seed) : places_(places), seed_(seed) {}

  // Adds a car with the draw of its place, if it lies on this land cover.
  void add(const ParkingPlace& place, LandCoverClass surface, bool may_turn) {
    const RandomSequence draw(seed_, stable_id(place.id), "parked");
    if (draw.unit(kIsOccupied) >= kOccupied || !lies_on(place, surface)) return;
    add_car(place, may_turn && draw.unit(kTurned) < 0.5, draw);
  }

  void add_mapped(const ThingFeature& space) {
    const RandomSequence draw(seed_, stable_id(space.id), "parked");
    if (draw.unit(kIsOccupied) >= kOccupied) return;
    const Vec2 across = space.along.value_or(Vec2{1, 0});
    add_car({space.id, space.at, left_of(across)}, draw.unit(kTurned) < 0.5, draw);
  }

  std::vector<ThingFeature> cars;

 private:
  bool lies_on(const ParkingPlace& place, LandCoverClass surface) {
    const Vec2 ahead = place.ahead * (kCarLength_m / 2), left = left_of(place.ahead) * (kCarWidth_m / 2);
    for (const Vec2 corner : {ahead + left, ahead - left, left - ahead, ahead * -1.0 - left})
      if (places_.surface_at(place.at + corner) != surface) return false;
    return true;
  }

  void add_car(const ParkingPlace& place, bool is_turned, const RandomSequence& draw) {
    ThingFeature car{.id = place.id,
                     .at = snapped(place.at),
                     .kind = std::string(map::name_of(map::ThingRole::kCar)),
                     .value = "parked",
                     .width_m = kCarWidth_m,
                     .depth_m = kCarLength_m,
                     .height_m = kCarHeight_m};
    car.colour = kColours[draw.below(kColours.size(), kColour)];
    car.faces = is_turned ? place.ahead * -1.0 : place.ahead;
    car.is_in_way = true;
    cars.push_back(std::move(car));
  }

  FreePlaces& places_;
  std::uint64_t seed_;
};

// The places of one parking lane, whose middle is `left_m` to the left of the axis.
void add_along_lane(const roads::Road& road, const map::Lane& lane, std::uint32_t number, double left_m, Cars& cars) {
  const bool is_across = lane.width_m >= kLeastAcross_m;
  const double place_m = is_across ? kPlaceAcross_m : kPlace_m;
  const std::vector<double> along = roads::distances_along(road);
  const double sign = lane.way == map::LaneDirection::kBackward ? -1 : 1;
  const auto first = static_cast<std::uint32_t>(std::ceil(along.front() / place_m - 0.5));
  for (std::uint32_t k = first; (k + 0.5) * place_m < along.back(); ++k) {
    const double at_m = (k + 0.5) * place_m;
    const Vec2 on_axis = point_at(road.axis, along, at_m);
    const Vec2 ahead = unit(point_at(road.axis, along, at_m + 0.5) - point_at(road.axis, along, at_m - 0.5));
    const Vec2 left = left_of(ahead);
    const double off_m = left_m + roads::drift_m(road, at_m);
    const ObjectId id = derived_id(road.id, 4 * kPlaces, number * kPlaces + k % kPlaces);
    const Vec2 looks = is_across ? left * (off_m > 0 ? 1.0 : -1.0) : ahead * sign;
    cars.add({id, on_axis + left * off_m, looks}, LandCoverClass::kParkingLane, is_across);
  }
}

void add_beside(const roads::Road& road, Cars& cars) {
  double from_left_m = 0;  // of the carriageway
  std::uint32_t number = 0;
  for (const map::Lane& lane : road.section.lanes) {
    if (lane.is_raised) continue;
    if (lane.kind == map::LaneKind::kParking)
      add_along_lane(road, lane, number++ % 4, road.section.axis_offset_m - from_left_m - lane.width_m / 2, cars);
    from_left_m += lane.width_m;
  }
}

// Pairs of rows along the longer side, which look at each other across a lane; the outer rows stand at the border.
void add_on_car_park(const map::AreaFeature& area, Cars& cars) {
  const map::OutlineRectangle box = map::smallest_rectangle(area.polygon.outer);
  if (std::max(box.length_m, box.width_m) > kLargestCarPark_m) return;
  const Vec2 along = box.length_m >= box.width_m ? box.along : left_of(box.along), across = left_of(along);
  const double long_m = std::max(box.length_m, box.width_m), wide_m = std::min(box.length_m, box.width_m);
  const auto columns = static_cast<std::uint32_t>(long_m / kPlaceAcross_m);
  const auto rows = static_cast<std::uint32_t>(2 * ((wide_m + kLane_m / 2) / (2 * kRow_m + kLane_m)) + 0.5);
  for (std::uint32_t row = 0; row < rows; ++row) {
    const bool is_second = row % 2 == 1;
    const double y_m =
        -wide_m / 2 + (row / 2) * (2 * kRow_m + kLane_m) + (is_second ? kRow_m + kLane_m : 0) + kRow_m / 2;
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double x_m = (column + 0.5) * kPlaceAcross_m - columns * kPlaceAcross_m / 2;
      const ObjectId id = derived_id(area.id, kPlaces, row * columns + column);
      cars.add({id, box.middle + along * x_m + across * y_m, across * (is_second ? 1.0 : -1.0)},
               LandCoverClass::kParking, true);
    }
  }
}

}  // namespace

std::vector<ThingFeature> parked_cars(std::span<const ThingFeature> spaces, const map::FeatureView& features,
                                      std::span<const roads::Road> roads, FreePlaces& places, std::uint64_t seed) {
  Cars cars(places, seed);
  for (const ThingFeature& space : spaces) cars.add_mapped(space);
  for (const roads::Road& road : roads) add_beside(road, cars);
  for (const map::AreaFeature& area : features.areas)
    if (area.surface == LandCoverClass::kParking) add_on_car_park(area, cars);
  return std::move(cars.cars);
}

}  // namespace citykiln::things

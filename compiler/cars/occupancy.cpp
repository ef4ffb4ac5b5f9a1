#include "compiler/cars/occupancy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::cars {
namespace {

constexpr double kDay_h = 24, kStep_h = 3;
using Day = std::array<double, 8>;

struct UseOfDay {
  Day workday, weekend;
};
constexpr auto kUses = std::to_array<UseOfDay>({
#define PLACE_USE(use, workday, weekend) {{Day workday}, {Day weekend}},
#include "compiler/cars/occupancy.inc"
#undef PLACE_USE
});
static_assert(kUses.size() == static_cast<std::size_t>(PlaceUse::kCount));

struct Habit {
  map::CountryGroup country;
  double kerb, lane, car_park, drive;
};
constexpr auto kHabits = std::to_array<Habit>({
#define PARKING_HABIT(country, kerb, lane, car_park, drive) {map::CountryGroup::country, kerb, lane, car_park, drive},
#include "compiler/cars/occupancy.inc"
#undef PARKING_HABIT
});
static_assert(kHabits.size() == static_cast<std::size_t>(map::CountryGroup::kCount));

double factor_of(const Place& place) {
  const auto habit = std::ranges::find(kHabits, place.country, &Habit::country);
  switch (place.kind) {
    case PlaceKind::kKerb:
      return habit->kerb;
    case PlaceKind::kLane:
      return habit->lane;
    case PlaceKind::kDrive:
      return habit->drive;
    default:
      return habit->car_park;
  }
}

// The share of a day of the week, counted from Monday, at one of its steps.
double share_at(const UseOfDay& use, int step) {
  const int steps = static_cast<int>(kDay_h / kStep_h), day = step / steps % 7;
  const std::size_t i = static_cast<std::size_t>(step % steps);
  return day >= 5 ? use.weekend[i] : use.workday[i];
}

}  // namespace

double usual_share(const Place& place, buildings::WeekTime time) {
  const UseOfDay& use = kUses[static_cast<std::size_t>(place.use)];
  const double at = time.hours / kStep_h;
  const int before = static_cast<int>(std::floor(at));
  const double later = at - before;
  const double share = share_at(use, before) * (1 - later) + share_at(use, before + 1) * later;
  return std::min(1.0, share * factor_of(place));
}

bool is_taken(const Place& place, const CarShare& cars, buildings::WeekTime time, std::uint64_t seed) {
  const double share = cars.is_by_table ? usual_share(place, time) : cars.share;
  return RandomSequence(seed, place.key, "parked").unit(0) < share;
}

}  // namespace citykiln::cars

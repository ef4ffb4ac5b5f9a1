#include "compiler/people/presence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::people {
namespace {

constexpr double kDay_h = 24, kStep_h = 3;
constexpr int kSteps = 8;
using Day = std::array<double, kSteps>;

struct Presence {
  double most;
  Day workday, weekend;
};
constexpr auto kPresence = std::to_array<Presence>({
#define PEOPLE_AT(use, most, workday, weekend) {most, {Day workday}, {Day weekend}},
#include "compiler/people/presence.inc"
#undef PEOPLE_AT
});
static_assert(kPresence.size() == static_cast<std::size_t>(SpotUse::kCount));

struct WalkingHabit {
  map::CountryGroup country;
  double factor;
};
constexpr auto kWalkingHabits = std::to_array<WalkingHabit>({
#define WALKING_HABIT(country, factor) {map::CountryGroup::country, factor},
#include "compiler/people/presence.inc"
#undef WALKING_HABIT
});
static_assert(kWalkingHabits.size() == static_cast<std::size_t>(map::CountryGroup::kCount));

// The share of a day of the week, counted from Monday, at one of its steps.
double share_at_step(const Presence& presence, int step) {
  const int day = step / kSteps % 7;
  const auto i = static_cast<std::size_t>(step % kSteps);
  return day >= 5 ? presence.weekend[i] : presence.workday[i];
}

}  // namespace

double usual_presence(const Spot& spot, buildings::WeekTime time) {
  const Presence& presence = kPresence[static_cast<std::size_t>(spot.use)];
  const double at = time.hours / kStep_h;
  const int before = static_cast<int>(std::floor(at));
  const double later = at - before;
  const double share = share_at_step(presence, before) * (1 - later) + share_at_step(presence, before + 1) * later;
  const auto habit = std::ranges::find(kWalkingHabits, spot.country, &WalkingHabit::country);
  return std::min(1.0, share * presence.most / 100 * spot.extent * habit->factor);
}

bool is_somebody_at(const Spot& spot, const PeopleShare& wish, buildings::WeekTime time, std::uint64_t seed) {
  const double share = wish.is_by_table ? usual_presence(spot, time) : wish.share;
  return RandomSequence(seed, spot.key, "somebody").unit(0) < share;
}

}  // namespace citykiln::people

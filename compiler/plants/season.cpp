#include "compiler/plants/season.h"

#include <algorithm>
#include <cmath>

namespace citykiln::plants {
namespace {

constexpr double kTropic_deg = 23.4;

using Thousandths = std::array<int, 3>;

struct PhaseRow {
  char letter;
  SeasonState state;
};

struct YearRow {
  Species species;
  std::string_view months;
  Thousandths young, turned;
};

constexpr PhaseRow kPhases[] = {
#define PHASE(letter, leaf_share, young, turned, height_share) \
  {letter, {leaf_share, young, turned, height_share, {}, {}}},
#define YEAR(species, months, yr, yg, yb, tr, tg, tb)
#include "compiler/plants/phenology.inc"
#undef YEAR
#undef PHASE
};

constexpr YearRow kYears[] = {
#define PHASE(letter, leaf_share, young, turned, height_share)
#define YEAR(species, months, yr, yg, yb, tr, tg, tb) {Species::species, months, {yr, yg, yb}, {tr, tg, tb}},
#include "compiler/plants/phenology.inc"
#undef YEAR
#undef PHASE
};

constexpr bool is_phase(char letter) {
  return std::ranges::any_of(kPhases, [&](const PhaseRow& row) { return row.letter == letter; });
}
static_assert(std::ranges::all_of(kYears, [](const YearRow& year) {
  return year.months.size() == 12 && year.months[5] == 's' && std::ranges::all_of(year.months, is_phase);
}));

// How far each variant is ahead of the mean where leaves turn; the first two, which are all that some levels have, as
// much ahead as behind.
constexpr std::array<double, kVariants> kAhead = {-0.25, 0.25, 0.1, -0.4, 0.2, -0.1, 0.25, -0.05};

int digit(std::string_view text, std::size_t at) {
  return at < text.size() && text[at] >= '0' && text[at] <= '9' ? text[at] - '0' : -1;
}

}  // namespace

Month month_for(std::string_view time, double latitude_deg) {
  const int tens = digit(time, 5), ones = digit(time, 6), month = 10 * tens + ones;
  if (tens < 0 || ones < 0 || month < 1 || month > 12 || std::abs(latitude_deg) < kTropic_deg) return kMidsummer;
  return static_cast<Month>(latitude_deg > 0 ? month : (month + 5) % 12 + 1);
}

SeasonState season_state_of(Prototype prototype, Month month) {
  const auto year = std::ranges::find(kYears, prototype.species, &YearRow::species);
  if (year == std::end(kYears)) return {};
  const char letter = year->months[(static_cast<std::size_t>(month) + 11) % 12];
  SeasonState state = std::ranges::find(kPhases, letter, &PhaseRow::letter)->state;
  state.young_leaf = year->young, state.turned_leaf = year->turned;
  if (state.turned > 0 && state.turned < 1)
    state.turned = std::clamp(state.turned + kAhead[prototype.variant % kVariants], 0.0, 1.0);
  return state;
}

}  // namespace citykiln::plants

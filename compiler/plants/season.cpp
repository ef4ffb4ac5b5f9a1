#include "compiler/plants/season.h"

#include <algorithm>
#include <cassert>

namespace citykiln::plants {
namespace {

struct StateRow {
  char letter;
  SeasonState state;
};

// The states for which the letters of SpeciesValues::months stand.
constexpr StateRow kStates[] = {{'.', {0, 0, 0, 1}},     // bare
                                {'y', {0.75, 1, 0, 1}},  // young leaves
                                {'s', {1, 0, 0, 1}},     // summer, the colours of species.inc
                                {'t', {1, 0, 0.75, 1}},  // turning, by variant
                                {'d', {1, 0, 1, 1}},     // turned, or dead and standing
                                {'l', {0.35, 0, 1, 1}},  // the last leaves
                                {'g', {1, 1, 0, 0.15}},  // sown
                                {'m', {1, 1, 0, 0.6}},   // half grown
                                {'h', {1, 0, 1, 0.2}},   // stubble
                                {'-', {0, 0, 0, 0}}};    // bare field

constexpr bool is_state(char letter) {
  return std::ranges::any_of(kStates, [&](const StateRow& row) { return row.letter == letter; });
}
constexpr bool are_states(std::string_view months) {
  return months.size() == 12 && months[5] == 's' && std::ranges::all_of(months, is_state);
}
static_assert(std::ranges::all_of(kSpecies, are_states, &SpeciesValues::months));

// How far each variant's turned share is ahead of the mean. The first two, which are all that some levels use, average
// to 0.
constexpr std::array<double, kVariants> kAhead = {-0.25, 0.25, 0.1, -0.4, 0.2, -0.1, 0.25, -0.05};

}  // namespace

climate::LocalMonth local_month_of(std::chrono::month month, double latitude_deg) {
  assert(month.ok());
  return static_cast<climate::LocalMonth>(unsigned{latitude_deg < 0 ? month + std::chrono::months(6) : month});
}

Month month_for(climate::LocalMonth month, climate::ClimateClass climate) {
  return Month{climate::equivalent_month(climate, month)};
}

bool are_months(std::string_view months) { return are_states(months); }

SeasonState season_state_of(Prototype prototype, Month month) {
  return season_state_of(values_of(prototype.species), prototype.variant, month);
}

SeasonState season_state_of(const SpeciesValues& species, std::uint8_t variant, Month month) {
  assert(variant < kVariants && Month{1} <= month && month <= Month{12});
  const char letter = species.months[static_cast<std::size_t>(month) - 1];
  SeasonState state = std::ranges::find(kStates, letter, &StateRow::letter)->state;
  if (state.turned > 0 && state.turned < 1) state.turned = std::clamp(state.turned + kAhead[variant], 0.0, 1.0);
  return state;
}

}  // namespace citykiln::plants

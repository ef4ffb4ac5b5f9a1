#include "compiler/verify/check_results.h"

namespace citykiln::verify {
namespace {

// In the order of printing.
constexpr Check CheckResults::*kChecks[] = {&CheckResults::files,          &CheckResults::stale,
                                            &CheckResults::ledger,         &CheckResults::glb_bytes,
                                            &CheckResults::area,           &CheckResults::height,
                                            &CheckResults::seams,          &CheckResults::jumps,
                                            &CheckResults::roads,          &CheckResults::rivers,
                                            &CheckResults::lakes,          &CheckResults::footing,
                                            &CheckResults::standing,       &CheckResults::openings,
                                            &CheckResults::land,           &CheckResults::on_earth,
                                            &CheckResults::areas,          &CheckResults::tracks,
                                            &CheckResults::decks,          &CheckResults::parts,
                                            &CheckResults::trunks,         &CheckResults::things,
                                            &CheckResults::wires,          &CheckResults::assumed_pavements,
                                            &CheckResults::assumed_lamps,  &CheckResults::assumed_railings,
                                            &CheckResults::assumed_masts,  &CheckResults::assumed_yards,
                                            &CheckResults::assumed_houses, &CheckResults::assumed_fronts,
                                            &CheckResults::tileset,        &CheckResults::tileset_boxes,
                                            &CheckResults::tileset_errors, &CheckResults::tileset_seams};
// Printed if something was tested.
constexpr Check CheckResults::*kOptionalChecks[] = {&CheckResults::bend, &CheckResults::usd_layers,
                                                    &CheckResults::usd_same, &CheckResults::usd_scene};

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void add_check(Check& all, const Check& more) {
  all.tests += more.tests;
  append(all.failures, more.failures);
}

}  // namespace

std::vector<const Check*> all_of(const CheckResults& results) {
  std::vector<const Check*> all;
  for (const auto claim : kChecks) all.push_back(&(results.*claim));
  for (const auto claim : kOptionalChecks)
    if ((results.*claim).tests > 0) all.push_back(&(results.*claim));
  return all;
}

void add(CheckResults& results, const CheckResults& of_tile) {
  for (const auto claim : kChecks) add_check(results.*claim, of_tile.*claim);
  for (const auto claim : kOptionalChecks) add_check(results.*claim, of_tile.*claim);
  results.reference_errors = combined(results.reference_errors, of_tile.reference_errors);
  append(results.ways_into_walls, of_tile.ways_into_walls);
  append(results.blank_walls, of_tile.blank_walls);
}

}  // namespace citykiln::verify

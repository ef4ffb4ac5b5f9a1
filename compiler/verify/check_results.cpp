#include "compiler/verify/check_results.h"

namespace citykiln::verify {
namespace {

// In the order of printing.
constexpr Check CheckResults::*kChecks[] = {
    &CheckResults::files,        &CheckResults::stale,   &CheckResults::ledger,        &CheckResults::glb_bytes,
    &CheckResults::area,         &CheckResults::height,  &CheckResults::seams,         &CheckResults::jumps,
    &CheckResults::roads,        &CheckResults::rivers,  &CheckResults::lakes,         &CheckResults::footing,
    &CheckResults::trunks,       &CheckResults::tileset, &CheckResults::tileset_boxes, &CheckResults::tileset_errors,
    &CheckResults::tileset_seams};
constexpr Check CheckResults::*kUsdChecks[] = {&CheckResults::usd_layers, &CheckResults::usd_same,
                                               &CheckResults::usd_scene};

void add_check(Check& all, const Check& more) {
  all.tests += more.tests;
  all.failures.insert(all.failures.end(), more.failures.begin(), more.failures.end());
}

}  // namespace

std::vector<const Check*> all_of(const CheckResults& results) {
  std::vector<const Check*> all;
  for (const auto claim : kChecks) all.push_back(&(results.*claim));
  for (const auto claim : kUsdChecks)
    if ((results.*claim).tests > 0) all.push_back(&(results.*claim));
  return all;
}

void add(CheckResults& results, const CheckResults& of_tile) {
  for (const auto claim : kChecks) add_check(results.*claim, of_tile.*claim);
  for (const auto claim : kUsdChecks) add_check(results.*claim, of_tile.*claim);
  results.reference_errors = combined(results.reference_errors, of_tile.reference_errors);
}

}  // namespace citykiln::verify

#include "grammars/derivation/leave_out_details.h"

#include <algorithm>
#include <cassert>

#include "grammars/derivation/simplify.h"

namespace citykiln::grammars {
namespace {

bool is_in_details(const Execution& execution, std::size_t terminal) {
  return std::ranges::any_of(execution.details, [&](const DetailChild& detail) {
    return detail.terminals.first <= terminal && terminal < detail.terminals.end;
  });
}

std::vector<std::size_t> other_terminals(const Execution& execution, std::size_t first) {
  std::vector<std::size_t> others;
  for (std::size_t i = first; i < execution.run.out.terminals.size(); ++i)
    if (!is_in_details(execution, i)) others.push_back(i);
  return others;
}

// The distance of the points from the terminal, of whose faces one has to be near to all of them.
double distance_to_terminal_m(std::span<const Vec3> points, const Terminal& terminal, double enough_m) {
  double best_m = kUnbounded_m;
  for (const Face& face : terminal.faces)
    best_m = std::min(best_m, farthest_from_ring_m(points, face.outer, face.holes.empty(), std::min(best_m, enough_m)));
  return best_m;
}

/// The distance of a detail's terminal from the terminals that stay; above `most_m` it may be too small.
double distance_to_others_m(const Run& run, std::size_t terminal, std::span<const std::size_t> others, double most_m) {
  const Terminal& detail = run.out.terminals[terminal];
  const VisibleAppearances seen = visible_appearance(run, detail);
  double farthest_m = 0;
  for (const Face& face : detail.faces) {
    double best_m = kUnbounded_m;
    for (const std::size_t other : others) {
      if (seen.include_other_than(run.out.terminals[other].appearance)) continue;
      best_m = std::min(best_m, distance_to_terminal_m(face.outer, run.out.terminals[other], most_m));
      if (best_m <= farthest_m) break;
    }
    farthest_m = std::max(farthest_m, best_m);
    if (farthest_m > most_m) break;
  }
  return farthest_m + detail.error_m;
}

double distance_of_detail_m(const Run& run, const DetailChild& detail, std::span<const std::size_t> others) {
  const double most_m = run.options.tolerance_m;
  double farthest_m = 0;
  for (std::size_t i = detail.terminals.first; i < detail.terminals.end && farthest_m <= most_m; ++i) {
    if (!run.out.terminals[i].asset.empty()) return kUnbounded_m;
    farthest_m = std::max(farthest_m, distance_to_others_m(run, i, others, most_m));
  }
  return farthest_m + detail.left_out_m + run.merged_m;
}

// Removes the terminals at `gone`, which are in rising order.
void remove_terminals(Run& run, const std::vector<std::size_t>& gone) {
  if (gone.empty()) return;
  std::vector<Terminal> kept;
  std::vector<TerminalOrigin> origins;
  for (std::size_t i = gone.front(); i < run.out.terminals.size(); ++i) {
    if (std::ranges::binary_search(gone, i)) continue;
    kept.push_back(run.out.terminals[i]);
    origins.push_back(run.origins[i]);
  }
  remove_terminals_from(run, gone.front());
  for (Terminal& terminal : kept) run.out.terminals.push_back(std::move(terminal));
  run.origins.insert(run.origins.end(), origins.begin(), origins.end());
}

}  // namespace

void leave_out_details(Execution& execution, std::size_t first) {
  Run& run = execution.run;
  if (execution.details.empty() || !run.measures()) return;
  const std::vector<std::size_t> others = other_terminals(execution, first);
  if (others.empty()) return;
  std::vector<std::size_t> gone;
  for (const DetailChild& detail : execution.details) {
    const double distance_m = distance_of_detail_m(run, detail, others);
    if (!(distance_m <= run.options.tolerance_m)) continue;
    for (std::size_t i = detail.terminals.first; i < detail.terminals.end; ++i) gone.push_back(i);
    execution.left_out_m = std::max(execution.left_out_m, distance_m);
    run.out.error_m = std::max(run.out.error_m, distance_m);
  }
  remove_terminals(run, gone);
}

}  // namespace citykiln::grammars

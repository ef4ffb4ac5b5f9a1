#include "grammars/derivation/leave_out_details.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "grammars/derivation/simplify.h"

namespace citykiln::grammars {
namespace {

/// The axis-aligned box of a terminal's vertices.
struct TerminalBox {
  Vec3 low{kUnbounded_m, kUnbounded_m, kUnbounded_m}, high{-kUnbounded_m, -kUnbounded_m, -kUnbounded_m};
  void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  /// A lower bound of the distance to another box.
  double gap_m(const TerminalBox& other) const {
    const Vec3 above = low - other.high, below = other.low - high;
    return std::max({above.x, above.y, above.z, below.x, below.y, below.z, 0.0});
  }
};

TerminalBox box_of(const Terminal& terminal) {
  TerminalBox box;
  for (const Face& face : terminal.faces)
    for (const Vec3 p : face.outer) box.add(p);
  return box;
}

/// The children of a node while it is decided which of them stay.
struct DetailChoice {
  const Run& run;
  std::size_t first = 0;              ///< The first terminal of the node.
  std::vector<TerminalBox> boxes;     ///< By terminal, from `first` on.
  std::vector<std::size_t> child_of;  ///< By terminal, from `first` on; the number of children for none.
  std::vector<bool> is_left_out;      ///< By child.
  std::vector<bool> stays;            ///< By child: others were left out because they are near to it.
};

DetailChoice choice_of(const Execution& execution, std::size_t first) {
  const std::vector<Terminal>& terminals = execution.run.out.terminals;
  const std::size_t children = execution.details.size();
  DetailChoice choice{execution.run, first, {}, {}, {}, {}};
  choice.is_left_out.resize(children);
  choice.stays.resize(children);
  choice.child_of.resize(terminals.size() - first, children);
  for (std::size_t i = first; i < terminals.size(); ++i) choice.boxes.push_back(box_of(terminals[i]));
  for (std::size_t child = 0; child < children; ++child)
    for (std::size_t i = execution.details[child].terminals.first; i < execution.details[child].terminals.end; ++i)
      choice.child_of[i - first] = child;
  return choice;
}

// The distance of the points from the terminal: one of its faces has to be near to all of them.
double distance_to_terminal_m(std::span<const Vec3> points, const Terminal& terminal, double enough_m) {
  double best_m = kUnbounded_m;
  for (const Face& face : terminal.faces)
    best_m = std::min(best_m, farthest_from_ring_m(points, face.outer, face.holes.empty(), std::min(best_m, enough_m)));
  return best_m;
}

/// The terminal to which a face is near, and the distance.
struct NearTerminal {
  double distance_m = kUnbounded_m;
  std::size_t terminal = 0;
};

NearTerminal nearest_terminal(const DetailChoice& choice, std::size_t own, const Face& face, VisibleAppearances seen) {
  const std::vector<Terminal>& terminals = choice.run.out.terminals;
  const double most_m = choice.run.options.tolerance_m;
  const std::size_t child = choice.child_of[own - choice.first];
  NearTerminal nearest;
  for (std::size_t i = choice.first; i < terminals.size(); ++i) {
    const std::size_t other = choice.child_of[i - choice.first];
    if (other == child || (other < choice.is_left_out.size() && choice.is_left_out[other])) continue;
    if (choice.boxes[i - choice.first].gap_m(choice.boxes[own - choice.first]) > most_m) continue;
    if (seen.include_other_than(terminals[i].appearance)) continue;
    const double distance_m =
        distance_to_terminal_m(face.outer, terminals[i], std::min(nearest.distance_m, 2 * most_m));
    if (distance_m < nearest.distance_m) nearest = {distance_m, i};
  }
  return nearest;
}

/// Decides about a child. Returns its distance from the terminals that stay; more than the tolerance if it stays.
double distance_of_child_m(DetailChoice& choice, const DetailChild& detail, std::vector<std::size_t>& near) {
  const double most_m = choice.run.options.tolerance_m;
  double farthest_m = 0;
  for (std::size_t i = detail.terminals.first; i < detail.terminals.end; ++i) {
    const Terminal& terminal = choice.run.out.terminals[i];
    if (!terminal.asset.empty()) return kUnbounded_m;
    const VisibleAppearances seen = visible_appearance(choice.run, terminal);
    for (const Face& face : terminal.faces) {
      const NearTerminal nearest = nearest_terminal(choice, i, face, seen);
      farthest_m =
          std::max(farthest_m, nearest.distance_m + terminal.error_m + detail.left_out_m + choice.run.merged_m);
      if (!(farthest_m <= most_m)) return kUnbounded_m;
      near.push_back(choice.child_of[nearest.terminal - choice.first]);
    }
  }
  return farthest_m;
}

double diagonal_m(const DetailChoice& choice, const DetailChild& detail) {
  TerminalBox box;
  for (std::size_t i = detail.terminals.first; i < detail.terminals.end; ++i) {
    box.add(choice.boxes[i - choice.first].low);
    box.add(choice.boxes[i - choice.first].high);
  }
  return detail.terminals.size() == 0 ? 0 : length(box.high - box.low);
}

// The children by size, the smallest first. Sizes are rounded to 1 µm, so that equal ones keep their order.
std::vector<std::size_t> smallest_first(const Execution& execution, const DetailChoice& choice) {
  std::vector<double> sizes;
  for (const DetailChild& detail : execution.details)
    sizes.push_back(std::floor(diagonal_m(choice, detail) / kSame_m + 0.5));
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sizes[i]; });
  return order;
}

// Removes the terminals of children that were left out.
void remove_left_out(Run& run, const DetailChoice& choice) {
  const auto is_gone = [&](std::size_t i) {
    const std::size_t child = choice.child_of[i - choice.first];
    return child < choice.is_left_out.size() && choice.is_left_out[child];
  };
  std::size_t from = choice.first;
  while (from < run.out.terminals.size() && !is_gone(from)) ++from;
  std::vector<Terminal> kept;
  std::vector<TerminalOrigin> origins;
  for (std::size_t i = from; i < run.out.terminals.size(); ++i) {
    if (is_gone(i)) continue;
    kept.push_back(run.out.terminals[i]);
    origins.push_back(run.origins[i]);
  }
  remove_terminals_from(run, from);
  for (Terminal& terminal : kept) run.out.terminals.push_back(std::move(terminal));
  run.origins.insert(run.origins.end(), origins.begin(), origins.end());
}

}  // namespace

void leave_out_details(Execution& execution, std::size_t first) {
  Run& run = execution.run;
  if (execution.details.empty() || !run.measures()) return;
  DetailChoice choice = choice_of(execution, first);
  bool is_any = false;
  for (const std::size_t child : smallest_first(execution, choice)) {
    std::vector<std::size_t> near;
    if (choice.stays[child] || execution.details[child].terminals.size() == 0) continue;
    const double distance_m = distance_of_child_m(choice, execution.details[child], near);
    if (!(distance_m <= run.options.tolerance_m)) continue;
    is_any = choice.is_left_out[child] = true;
    for (const std::size_t other : near)
      if (other < choice.stays.size()) choice.stays[other] = true;
    execution.left_out_m = std::max(execution.left_out_m, distance_m);
    run.out.error_m = std::max(run.out.error_m, distance_m);
  }
  if (is_any) remove_left_out(run, choice);
}

}  // namespace citykiln::grammars

#include "grammars/derivation/sizes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::grammars {
namespace {

constexpr double kNearlyWhole = 1e-9;      // 3 · 0.1 fits into 0.3
constexpr double kLeastFloating_m = 1e-9;  // ~0 gets the length that no other size takes

struct Divider {
  double whole_m = 0;  ///< The length that relative sizes are shares of.
  std::size_t most = 0;
  Intervals made;
  double at_m = 0;  ///< The end of the last interval.
  bool too_many = false;

  void add(double to_m, std::uint32_t leaf) {
    if (to_m - at_m < kSliver_m) return;
    too_many |= made.size() >= most;
    if (too_many) return;
    made.push_back({at_m, to_m, leaf});
    at_m = to_m;
  }
};

double size_of(const SizeItem& item) {
  return std::max(item.size, item.kind == SizeKind::kFloating ? kLeastFloating_m : 0.0);
}

/// The sums of a list of sizes before scaling.
struct Natural {
  double fixed_m = 0, floating_m = 0;
  double length_m() const { return fixed_m + floating_m; }
};

Natural natural_of(std::span<const SizeItem> items, double whole_m) {
  Natural natural;
  for (const SizeItem& item : items) {
    const double size = size_of(item);
    if (item.kind == SizeKind::kAbsolute) natural.fixed_m += size;
    if (item.kind == SizeKind::kRelative) natural.fixed_m += size * whole_m;
    if (item.kind == SizeKind::kFloating) natural.floating_m += size;
    if (item.kind == SizeKind::kRepeat) natural.floating_m += natural_of(item.nested, whole_m).length_m();
  }
  return natural;
}

// The number of repetitions that fit (sizes.h, 2 and 3).
double times_fitting(Natural group, double room_m, bool others_float) {
  const double least = others_float ? 0 : 1;
  if (room_m <= kSliver_m) return 0;
  if (!(group.length_m() > kSliver_m)) return least;
  if (group.floating_m == 0) {
    const double times = room_m / group.length_m();
    return others_float ? std::floor(times + kNearlyWhole) : std::ceil(times - kNearlyWhole);
  }
  double times = std::floor(room_m / group.length_m() + 0.5);
  if (group.fixed_m > 0) times = std::min(times, std::floor(room_m / group.fixed_m + kNearlyWhole));
  return std::max(times, least);
}

/// One list with the numbers of repetitions.
struct Plan {
  SmallVector<double, 8> times;  ///< Repetitions of each item; 1 unless it is a group.
  double scale = 0;              ///< The factor of floating sizes.
  bool fills = false;            ///< A size floats, and there is length left for it.
};

bool is_repeat(const SizeItem& item) { return item.kind == SizeKind::kRepeat; }

Plan plan_of(std::span<const SizeItem> items, double length_m, double whole_m) {
  Natural all;
  for (const SizeItem& item : items) {
    const Natural natural = is_repeat(item) ? Natural{} : natural_of({&item, 1}, whole_m);
    all.fixed_m += natural.fixed_m, all.floating_m += natural.floating_m;
  }
  const auto repeats = static_cast<double>(std::count_if(items.begin(), items.end(), is_repeat));
  const double room_m = (length_m - all.length_m()) / std::max(repeats, 1.0);
  const bool others_float = all.floating_m > 0 || repeats > 1;
  Plan plan;
  plan.times.reserve(items.size());
  for (const SizeItem& item : items) {
    const Natural group = natural_of(item.nested, whole_m);
    plan.times.push_back(is_repeat(item) ? times_fitting(group, room_m, others_float) : 1);
    all.fixed_m += is_repeat(item) ? plan.times.back() * group.fixed_m : 0;
    all.floating_m += is_repeat(item) ? plan.times.back() * group.floating_m : 0;
  }
  plan.fills = all.floating_m > 0 && all.fixed_m < length_m;
  plan.scale = plan.fills ? (length_m - all.fixed_m) / all.floating_m : 0;
  return plan;
}

void divide(Divider& divider, std::span<const SizeItem> items, double from_m, double length_m);

/// Adds one item at `at_m` and returns its end. @param end_m  The end of the list.
double add_item(Divider& divider, const SizeItem& item, double at_m, double scale, double end_m) {
  double size_m = size_of(item);
  if (item.kind == SizeKind::kRelative) size_m *= divider.whole_m;
  if (item.kind == SizeKind::kFloating) size_m *= scale;
  if (is_repeat(item)) size_m = natural_of(item.nested, divider.whole_m).length_m() * scale;
  const double to_m = std::min(at_m + size_m, end_m);
  if (is_repeat(item)) {
    divide(divider, item.nested, at_m, to_m - at_m);
  } else {
    divider.add(to_m, item.leaf);
  }
  return to_m;
}

void divide(Divider& divider, std::span<const SizeItem> items, double from_m, double length_m) {
  const Plan plan = plan_of(items, length_m, divider.whole_m);
  const double end_m = from_m + length_m;
  double at_m = from_m;
  for (std::size_t i = 0; i < items.size() && !divider.too_many; ++i) {
    if (!is_repeat(items[i])) {
      at_m = add_item(divider, items[i], at_m, plan.scale, end_m);
      continue;
    }
    divider.too_many |= plan.times[i] > static_cast<double>(divider.most);
    for (double time = 0; time < plan.times[i] && !divider.too_many; ++time)
      for (const SizeItem& item : items[i].nested) at_m = add_item(divider, item, at_m, plan.scale, end_m);
  }
  // floating sizes end exactly at the end of the list
  if (!plan.fills || divider.made.empty() || divider.at_m <= from_m) return;
  divider.made.back().to_m = divider.at_m = end_m;
}

}  // namespace

std::optional<Intervals> intervals_of(std::span<const SizeItem> items, double length_m, std::size_t most) {
  assert(std::isfinite(length_m));
  Divider divider{length_m, most, {}, 0, false};
  divider.made.reserve(items.size());
  divide(divider, items, 0, std::max(length_m, 0.0));
  if (divider.too_many) return std::nullopt;
  return std::move(divider.made);
}

}  // namespace citykiln::grammars

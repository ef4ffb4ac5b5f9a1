#include "compiler/contract/texts/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace citykiln {
namespace {

// The optimal string alignment distance, by rows of the usual table (R. Lowrance and R. A. Wagner, 1975).
std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(above, row);
  }
  return above.back();
}

}  // namespace

std::string_view nearest_name(std::string_view typed, std::span<const std::string> known) {
  std::string_view nearest;
  std::size_t fewest = 0;
  for (const std::string& name : known) {
    const std::size_t errors = typing_errors(typed, name);
    if (errors * 3 > std::max<std::size_t>(name.size(), 3)) continue;
    if (nearest.empty() || errors < fewest) nearest = name, fewest = errors;
  }
  return nearest;
}

std::string did_you_mean(std::string_view typed, std::span<const std::string> known) {
  const std::string_view name = nearest_name(typed, known);
  return name.empty() ? "" : "; did you mean " + std::string(name) + "?";
}

}  // namespace citykiln

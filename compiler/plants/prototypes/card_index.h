// Finds cards by position, with a grid of their centres. A card is a rectangle with a picture of leaves (foliage.h).
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/plants/prototypes/foliage.h"

namespace citykiln::plants {

/// Cards, and the sorted grid cells of their centres.
struct CardIndex {
  struct Entry {
    std::uint64_t cell;
    std::uint32_t card;
    auto operator<=>(const Entry&) const = default;
  };
  std::span<const Card> cards;
  double cell_m = 1;
  std::vector<Entry> entries{};
};

/// Returns the number of the grid cell that contains a position, in the order of layers, rows and columns.
/// @param dy, dz  Offset in rows and layers to another cell.
inline std::uint64_t grid_cell(Vec3 place, double cell_m, int dy = 0, int dz = 0) {
  constexpr double kOffset = 1 << 20;
  const auto step = [&](double v) { return static_cast<std::uint64_t>(std::floor(v / cell_m) + kOffset); };
  return (step(place.z) + static_cast<std::uint64_t>(dz)) << 42 |
         (step(place.y) + static_cast<std::uint64_t>(dy)) << 21 | step(place.x);
}

/// Builds the index. O(n log n).
/// @param cards  Must outlive the index; their centres are within 2^19 cells of the origin.
inline CardIndex index_cards(std::span<const Card> cards, double cell_m) {
  assert(cell_m > 0);
  CardIndex index{cards, cell_m};
  for (std::uint32_t i = 0; i < cards.size(); ++i) index.entries.push_back({grid_cell(cards[i].centre(), cell_m), i});
  std::ranges::sort(index.entries);
  return index;
}

/// True if a card fulfils a condition, among the cards whose centres lie in the grid cell of `place` or in a cell
/// beside it.
template <typename Condition>
bool any_near(const CardIndex& index, Vec3 place, Condition condition) {
  for (const int dz : {0, -1, 1})
    for (const int dy : {0, -1, 1}) {
      const std::uint64_t cell = grid_cell(place, index.cell_m, dy, dz);
      auto entry = std::ranges::lower_bound(index.entries, cell - 1, {}, &CardIndex::Entry::cell);
      for (; entry != index.entries.end() && entry->cell <= cell + 1; ++entry)
        if (condition(index.cards[entry->card])) return true;
    }
  return false;
}

}  // namespace citykiln::plants

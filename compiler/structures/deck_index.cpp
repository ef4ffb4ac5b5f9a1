#include "compiler/structures/deck_index.h"

#include <algorithm>

namespace citykiln::structures {

DeckIndex index_decks(std::span<const Span> bridges, double margin_m) {
  constexpr double kBucket_m = 64;
  DeckIndex index;
  std::vector<Box2> boxes;
  for (std::uint32_t b = 0; b < bridges.size(); ++b) {
    const std::vector<Rib> ribs = ribs_of(bridges[b]);
    const DeckDimensions deck = deck_dimensions(bridges[b], 0);
    const double half_m = std::max(deck.left_m, deck.right_m) + margin_m;
    for (std::size_t i = 0; i + 1 < ribs.size(); ++i) {
      index.pieces.push_back(
          {.bridge = b, .from = ribs[i], .to = ribs[i + 1], .left_m = deck.left_m, .right_m = deck.right_m});
      boxes.push_back(box_of_segment(ribs[i].at, ribs[i + 1].at).widened(half_m));
    }
  }
  index.grid = grid_of(boxes, kBucket_m);
  return index;
}

}  // namespace citykiln::structures

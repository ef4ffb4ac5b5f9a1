#include "compiler/impostor/pack_boxes.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <utility>

namespace citykiln::impostor {
namespace {

// Boxes of equal height stay in their order.
std::vector<std::size_t> by_height(std::span<const BoxSize> boxes) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return boxes[i].rows; });
  return order;
}

PackedBoxes shelve_boxes(std::span<const BoxSize> boxes, std::span<const std::size_t> order, std::uint32_t columns) {
  PackedBoxes packed{std::vector<BoxPlace>(boxes.size()), columns, 0};
  std::uint32_t column = 0, row = 0, end = 0;
  for (const std::size_t i : order) {
    if (column + boxes[i].columns > columns) column = 0, row = end;
    packed.places[i] = {column, row};
    column += boxes[i].columns, end = std::max(end, row + boxes[i].rows);
  }
  packed.rows = std::bit_ceil(end);
  return packed;
}

}  // namespace

PackedBoxes pack_boxes(std::span<const BoxSize> boxes) {
  assert(std::ranges::none_of(boxes, [](const BoxSize& b) { return b.columns == 0 || b.rows == 0; }));
  if (boxes.empty()) return {};
  const std::vector<std::size_t> order = by_height(boxes);
  const auto cost = [](const PackedBoxes& p) {
    return std::pair(std::uint64_t{p.columns} * p.rows, std::max(p.columns, p.rows));
  };
  PackedBoxes best;
  std::uint32_t columns = std::bit_ceil(std::ranges::max_element(boxes, {}, &BoxSize::columns)->columns);
  for (bool is_high = true; is_high; columns *= 2) {
    PackedBoxes packed = shelve_boxes(boxes, order, columns);
    is_high = packed.rows > packed.columns;
    if (best.places.empty() || cost(packed) < cost(best)) best = std::move(packed);
  }
  return best;
}

}  // namespace citykiln::impostor

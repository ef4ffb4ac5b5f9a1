#include "preview/morton_order.h"

#include <algorithm>

namespace citykiln::preview {
namespace {

// Moves the lower 16 bits to the even positions.
std::uint32_t spread_16_bits(std::uint32_t v) {
  v = (v | (v << 8)) & 0x00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0fu;
  v = (v | (v << 2)) & 0x33333333u;
  return (v | (v << 1)) & 0x55555555u;
}

std::uint32_t code_of(const GridPlace& place) {
  return spread_16_bits(static_cast<std::uint32_t>(place.x)) |
         (spread_16_bits(static_cast<std::uint32_t>(place.y)) << 1);
}

}  // namespace

std::vector<GridPlace> in_morton_order(int width, int height) {
  std::vector<GridPlace> places;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) places.push_back({x, y});
  std::ranges::sort(places, {}, code_of);
  return places;
}

}  // namespace citykiln::preview

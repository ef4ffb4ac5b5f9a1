#include "compiler/bake/baking.h"

#include <algorithm>

namespace citykiln::bake {

std::uint32_t number_of(const BakedTile& tile, OsmId feature) {
  return static_cast<std::uint32_t>(std::lower_bound(tile.features.begin(), tile.features.end(), feature) -
                                    tile.features.begin());
}

}  // namespace citykiln::bake

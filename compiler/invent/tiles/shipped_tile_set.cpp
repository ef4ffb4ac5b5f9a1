#include "compiler/invent/tiles/shipped_tile_set_generated.h"
#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {

std::string_view shipped_tile_set() { return kShippedTileSet; }

}  // namespace citykiln::invent

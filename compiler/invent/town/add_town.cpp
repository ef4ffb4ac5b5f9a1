#include "compiler/invent/town/add_town.h"

namespace citykiln::invent {

void add_town(const Terrain& /*terrain*/, const TownSettings& /*settings*/, InventedMap& /*map*/) {}

}  // namespace citykiln::invent

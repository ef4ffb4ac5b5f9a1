// Towns: roads, quarters, lots, houses, and what stands in them.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

enum class TownKind : std::uint8_t { kVillage, kTown, kCity };

struct TownSettings {
  TownKind kind = TownKind::kTown;
  double side_m = 1000;  ///< The mapped square about the middle of the world.
  std::uint64_t seed = 1;
};

/// Adds the town on a terrain: main roads, streets, paths, a railway, land use, buildings with addresses, parks,
/// things. The terrain is not changed: compile grades it under roads.
void add_town(const Terrain& terrain, const TownSettings& settings, InventedMap& map);

}  // namespace citykiln::invent

// Quarters: what each block of a town is used for.
#pragma once

#include "compiler/invent/town/streets/street_edges.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

enum class BlockUse : std::uint8_t {
  // divided into lots
  kCore,  ///< Houses side by side about courtyards, shops below.
  kTerraces,
  kHouses,  ///< Detached and semi-detached.
  kVillas,
  kFlats,
  kCommerce,
  kIndustry,
  kFarms,
  // one land use on the whole block
  kPark,
  kSquare,
  kSchool,
  kChurch,
  kCemetery,
  kSports,
  kAllotments,
  kMarket,  ///< A supermarket and its cars.
  kCount
};

inline bool has_lots(BlockUse use) { return use < BlockUse::kPark; }

struct TownBlock {
  Ring ring;  ///< Along the axes of its streets; empty if it is open land.
  /// The largest piece without streets, holes filled; empty if there is none or the block exceeds 40 ha.
  Polygon land;
  double area_m2 = 0;
  Vec2 middle;
  bool is_whole = true;  ///< The land is not empty, and no dead end, water or railway lies in it.
  BlockUse use = BlockUse::kHouses;
};

/// Returns the use of each block. A use that few blocks have, such as a school, is given to as many blocks as towns of
/// this area have, and blocks of one such use are far apart.
///
/// @param land_inset_m  The distance from a street's axis to the land beside it.
std::vector<TownBlock> plan_quarters(const TownPlan& plan, const StreetBlocks& blocks, double land_inset_m);

/// The use of land that no block has, along streets into the country.
BlockUse use_at(const TownPlan& plan, Vec2 p);

}  // namespace citykiln::invent

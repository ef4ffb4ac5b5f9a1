// Lots of a town: divides the land beside its streets by parcels/divide.h, as is done for real maps, which do not
// contain lots. A street edge is a part of a street between junctions (streets/street_edges.h).
#pragma once

#include "compiler/invent/town/quarters.h"
#include "compiler/parcels/parcels.h"

namespace citykiln::invent {

/// A lot, and its frontage: the part of its ring on the border of the street from which it is entered.
struct TownLot {
  Ring ring;                       ///< Counter-clockwise.
  std::vector<char> is_on_street;  ///< Entry i: 1 if ring[i] to ring[i + 1] is on the border of any street.
  Vec2 from, to;                   ///< The ends of the frontage, in the order of the ring. More than 3 m apart.
  std::uint32_t edge = 0;          ///< Index of the street edge from which the lot is entered.
  bool is_on_left = false;         ///< True if the lot is to the left of that edge, as seen along its axis.
  double at_m = 0;                 ///< Distance along the axis of that edge to the middle of the frontage.
  BlockUse use = BlockUse::kHouses;
  double density = 0;  ///< TownPlan::density at the middle of the frontage: above kTownEdge, 1 in the middle of a city.

  /// Returns the unit vector along the frontage; the lot is to its left.
  Vec2 along() const { return unit(to - from); }
  /// Returns the unit vector from the street into the lot.
  Vec2 inward() const { return left_of(along()); }
  double frontage_m() const { return distance(from, to); }
};

/// Lots, and the blocks that they are parts of.
struct TownLots {
  std::vector<TownLot> lots;       ///< In the order of divide().
  std::vector<InventedArea> land;  ///< Land use of blocks with lots.
};

/// Divides the land of all blocks whose use has lots (has_lots()). Lots are simple rings and share no area with streets
/// (carriageway, parking and pavement), railways, water or blocks of other uses, but they meet streets in their
/// frontages. Lots with a frontage of at most 3 m, a hole, water at a vertex, or a density of at most kTownEdge are
/// left out. Cost: that of parcels/divide.h.
TownLots divide_town(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
                     const std::vector<TownBlock>& blocks);

}  // namespace citykiln::invent

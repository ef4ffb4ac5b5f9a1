// Lots of a town: the land beside its streets, divided as that of silent maps is.
#pragma once

#include "compiler/invent/town/quarters.h"
#include "compiler/parcels/parcels.h"

namespace citykiln::invent {

/// A lot, and how it lies on its street.
struct TownLot {
  Ring ring;                       ///< Counter-clockwise.
  std::vector<char> is_on_street;  ///< For each edge from its vertex: 1 if it lies on a street.
  Vec2 from, to;                   ///< The ends of its frontage on its street, in the order of the ring.
  std::uint32_t edge = 0;          ///< The street edge that it is entered from.
  bool is_on_left = false;         ///< The side of the edge.
  double at_m = 0;                 ///< Along the edge, to the middle of its frontage.
  BlockUse use = BlockUse::kHouses;
  double density = 0;

  Vec2 along() const { return unit(to - from); }
  Vec2 inward() const { return left_of(along()); }
  double frontage_m() const { return distance(from, to); }
};

/// Lots, and the blocks that they are parts of.
struct TownLots {
  std::vector<TownLot> lots;       ///< In the order of divide().
  std::vector<InventedArea> land;  ///< Land use of blocks with lots.
};

/// Divides the land of blocks with lots. Lots touch no street, no water and no land of other uses, are simple and have
/// a frontage. Cost: that of parcels/divide.h.
TownLots divide_town(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
                     const std::vector<TownBlock>& blocks);

}  // namespace citykiln::invent

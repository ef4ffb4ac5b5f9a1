// Decides which building each part of a street edge belongs to.
//
//      ┌──┐   ┌────┐  ·garage     1. rays square to the edge find the first building
//      │  │   │    │  ┌┐          2. gaps between two buildings are cut in the middle, so that
//   ───────|───────|─────────        no building behind them is cut if possible
//     a    |   b   |              3. land farther than a usual frontage from any has no owner
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/parcels/field.h"

namespace citykiln::parcels {

/// A label says whom land belongs to. kOff: not in a block. kRest: land without an owner. kFirstBuilding + i: footprint
/// i. Labels after the last footprint belong to sections without buildings (divide.cpp).
inline constexpr std::uint32_t kOff = 0, kRest = 1, kFirstBuilding = 2;
inline std::uint32_t label_of_building(std::uint32_t footprint) { return kFirstBuilding + footprint; }

/// A part of a street edge, and to whom it belongs.
struct Span {
  double from_m = 0, to_m = 0;
  std::uint32_t label = kRest;
  double depth_m = 0;  ///< The rear border's distance.
};

/// Smaller buildings are sheds: they have a lot of their own only where no larger building is near. Garages of one car
/// have 15 to 30 m2.
inline constexpr double kShed_m2 = 36;

/// The spans of each street edge, in order and without gaps.
using EdgeOwners = std::vector<std::vector<Span>>;

/// Returns what each part of each street edge belongs to. Cost: a ray for each corner of a building in front of each
/// street edge.
EdgeOwners edge_owners_of(const RightsOfWay& ways, const std::vector<Footprint>& footprints,
                          const std::vector<LotSize>& sizes, const Obstacles& obstacles);

/// Returns the pieces of all spans, labelled.
std::vector<Piece> pieces_of(const RightsOfWay& ways, const EdgeOwners& owners);

}  // namespace citykiln::parcels

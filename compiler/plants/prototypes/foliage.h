// Foliage: a plant's leaves as rectangular cards.
//
//         across
//      +---------->      a card shows the picture of a spray, or is an opaque blade;
//      |   \|/           its front faces out of the crown
//      |  --|--  along
//      v    |
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/materials/material.h"
#include "lsystems/lsystem.h"
#include "lsystems/skeleton.h"

namespace citykiln::plants {

/// A rectangle with sides `across` and `along` at `corner`; its front is cross(along, across).
struct Card {
  Vec3 corner, across, along;
  Vec3 normal;             ///< Unit, for shading: between the card's normal and the direction out of the crown.
  materials::Tint tint{};  ///< Multiplies the picture's colour.
  std::uint8_t spray = 0;  ///< Into Foliage::sprays.
  bool is_clump = false;   ///< Shows several sprays, in place of cards of a larger area.

  Vec3 centre() const { return corner + (across + along) * 0.5; }
};

/// Axis-aligned bounds of the cards' centres.
struct CentreBounds {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};
CentreBounds bounds_of(std::span<const Card> cards);

double area_of(const Card& card);
/// Distance from a place to the rectangle.
double distance(const Card& card, Vec3 place);
std::array<Vec3, 4> corners_of(const Card& card);

/// In the skeleton's units.
struct Foliage {
  std::vector<Card> cards;
  std::vector<std::string> sprays;  ///< Names of instances in the .lsys file (sprays.h); "" for blades.
  Vec3 crown_centre;
};

/// Cards for the instances of a skeleton, and for its polygons cards of the same area, in shades of `tint`. O(n).
Foliage foliage_of(const lsystems::LSystem& system, const lsystems::Skeleton& skeleton, materials::Tint tint);

}  // namespace citykiln::plants

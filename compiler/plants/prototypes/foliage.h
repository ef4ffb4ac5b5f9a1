// Foliage: the leaves of a plant as cards, rectangles with the picture of a spray (a twig with its leaves).
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
#include "lsystems/rewriting/skeleton.h"

namespace citykiln::plants {

inline constexpr std::int32_t kNoOutline = -1;

/// A rectangle with sides `across` and `along` at `corner`, in the skeleton's frame and units, z up. Its front faces
/// cross(along, across).
struct Card {
  Vec3 corner, across, along;
  Vec3 normal;             ///< A unit vector for shading, between the card's normal and the direction out of the crown.
  materials::Tint tint{};  ///< Multiplies the picture's colour.
  std::uint8_t spray = 0;  ///< Index into Foliage::sprays.
  bool is_clump = false;   ///< It shows many small sprays, in place of several cards.
  std::int32_t outline = kNoOutline;  ///< Index into Foliage::outlines.

  Vec3 centre() const { return corner + (across + along) * 0.5; }
};

/// The axis-aligned bounds of the cards' centres.
struct CentreBounds {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};
CentreBounds bounds_of(std::span<const Card> cards);

/// Returns the area of a card.
double area_of(const Card& card);
/// Returns the distance from a position to the rectangle.
double distance(const Card& card, Vec3 place);
/// Returns the corners of a card in the order corner, + along, + along + across, + across. They run counter-clockwise
/// seen from the front.
std::array<Vec3, 4> corners_of(const Card& card);

/// The leaves of a plant, in the skeleton's units.
struct Foliage {
  std::vector<Card> cards;
  std::vector<std::string> sprays;  ///< The names of instances in the .lsys file (sprays.h); "" for blades.
  Vec3 crown_centre;
  std::vector<std::vector<Vec3>> outlines{};  ///< Outlines of the leaves that cards stand for (leaf_outlines.h).
};

/// Returns a card for each leaf instance of a grown skeleton, and cards of equal area for its polygons, in shades of
/// `tint`. O(n).
/// @param system  The L-system that names the instances.
Foliage foliage_of(const lsystems::LSystem& system, const lsystems::Skeleton& skeleton, materials::Tint tint);

}  // namespace citykiln::plants

// A plant's leaves as flat cards, ready to be drawn, thinned and looked at from afar.
//
//         across
//      +---------->      a card: a rectangle with a picture of a spray, or a plain
//      |   \|/           blade; its front looks out of the crown
//      |  --|--  along
//      v    |
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/materials/material.h"
#include "lsystems/lsystem.h"
#include "lsystems/skeleton.h"

namespace citykiln::plants {

/// A rectangle: corner, corner + across, corner + along; seen from cross(along, across).
struct Card {
  Vec3 corner, across, along;
  Vec3 normal;             ///< Unit, for light: between the card's own and away from the crown's heart.
  materials::Tint tint{};  ///< Times what its picture shows.
  std::uint8_t spray = 0;  ///< Into Foliage::sprays.

  Vec3 centre() const { return corner + (across + along) * 0.5; }
};

double area_of(const Card& card);
/// From a place to the rectangle.
double distance(const Card& card, Vec3 place);
std::array<Vec3, 4> corners_of(const Card& card);

/// Lengths are the skeleton's.
struct Foliage {
  std::vector<Card> cards;
  std::vector<std::string> sprays;  ///< What ~ calls them (sprays.h); "" for blades, which fill their cards.
  Vec3 crown_centre;                ///< The middle of the crown.
};

/// The instances of a skeleton and its polygons, these as cards of the same area, in shades of `tint`. O(n).
Foliage foliage_of(const lsystems::LSystem& system, const lsystems::Skeleton& skeleton, materials::Tint tint);

}  // namespace citykiln::plants

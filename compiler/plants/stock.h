// What plants are drawn from: one species, or a mix that altitude, slope and water decide (mixes.inc).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/contract/draw.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/growth.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// Rows of mixes.inc. The order is part of the manifest's format: add at the end.
enum class Mix : std::uint8_t {
#define MIX(mix) mix,
#define PART(mix, species, share, from_m, to_m, shade, wet)
#include "compiler/plants/mixes.inc"
#undef PART
#undef MIX
  kCount
};

/// A species' number, or kFirstMix more than a mix's.
enum class Stock : std::uint8_t {};
inline constexpr std::uint8_t kFirstMix = 128;

constexpr Stock stock_of(Species species) { return Stock{static_cast<std::uint8_t>(species)}; }
constexpr Stock stock_of(Mix mix) { return static_cast<Stock>(kFirstMix + static_cast<std::uint8_t>(mix)); }
constexpr bool is_species(Stock stock) { return static_cast<std::uint8_t>(stock) < kFirstMix; }
constexpr Species species_of(Stock stock) { return static_cast<Species>(stock); }
/// Whether there is such a species or mix.
bool is_stock(std::uint64_t number);

/// "oak", "AnyWood".
std::string name_of(Stock stock);

/// All species that it may be drawn as, sorted.
std::vector<Species> all_of(Stock stock);

/// What tags tell: the species that looks most like the kind, else a mix by the leaves, else `untold`.
Stock stock_for(const map::Growth& growth, Stock untold);

/// A place as plants feel it.
struct Habitat {
  double belt_m = 0;         ///< Altitude of the same climate at 42.5 degrees of latitude.
  double shade = 0;          ///< From -1 on a steep slope that looks at the noon sun to 1 on one that looks away.
  bool is_by_water = false;  ///< Within a few metres of a lake or river.
  Vec2 at;                   ///< Species stand in groups.
};

/// The habitat on ground of a height and a normal.
Habitat habitat_at(double latitude_deg, Vec2 at, double height_m, Vec3 normal, bool is_by_water);

/// The species of one plant: the stock's, or drawn from the mix. Where none of a mix can grow, the one whose belt is
/// nearest. Total.
Species draw_species(Stock stock, const Habitat& habitat, std::uint64_t seed, double chance);

/// How tall trees grow there, as a share of what they do in the valley: less towards the tree line.
double vigour(const Habitat& habitat);

}  // namespace citykiln::plants

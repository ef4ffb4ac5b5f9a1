// The bodies of people: 24 rows of body_models.inc, which all people of a scene share.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/map/countries/country_group.h"
#include "compiler/materials/material.h"
#include "compiler/things/recipe.h"

namespace citykiln::people {

enum class Pose : std::uint8_t { kWalk, kStand, kPhone, kPockets, kSit };
enum class Figure : std::uint8_t { kMan, kWoman, kChild };
enum class LegWear : std::uint8_t { kTrousers, kShorts, kSkirt, kDress };
enum class HairCut : std::uint8_t { kShort, kLong, kBun, kBald };
enum class Bag : std::uint8_t { kNone, kBackpack, kShoulderBag, kCarrierBag };

/// The clothes of a season: thin ones, a jacket, or a coat with a cap.
enum class Season : std::uint8_t { kWarm, kMild, kCold };

/// The things that people do at a spot.
enum class Stance : std::uint8_t { kWalking, kStanding, kSitting };

/// All that decides the mesh of a body. Colours are tints of Material::kPaint.
struct Look {
  Pose pose{};
  Figure figure{};
  double height_m = 1.75;  ///< When standing upright.
  LegWear legs{};
  HairCut hair_cut{};
  Bag bag{};
  Season season{};
  bool has_cap = false;
  materials::Tint top{}, bottom{}, skin{}, hair{}, shoes{}, bag_colour{}, cap{};
};

/// A body in the clothes of a country group and a season.
struct Body {
  std::uint16_t number = 0;  ///< A row of body_models.inc, less than kBodies.
  map::CountryGroup country{};
  Season season{};
};

/// The number of bodies in a scene.
inline constexpr std::uint16_t kBodies = 24;
/// The height of the tallest row of body_models.inc, in metres.
inline constexpr double kTallestPerson_m = 1.90625;

/// Draws a body of a stance by its weights, without children if asked.
/// @param draw  A number in [0, 1).
std::uint16_t drawn_body(Stance stance, bool with_children, double draw);

/// Returns the look of a body: its row, with colours drawn by the weights of country and season.
Look look_of(const Body& body, std::uint64_t seed);

/// Returns the form of a body, of the kind "person". It is no row of the table of things: its mesh is body_mesh().
things::Form form_of(const Body& body);

/// Returns the body of a form made by form_of(); nullopt for forms of other kinds.
std::optional<Body> body_of(const things::Form& form);

/// Returns the clothes of a month.
/// @param month  1 to 12 as the leaves of central Europe have it (climate::equivalent_month()).
Season season_of(std::uint8_t month);

}  // namespace citykiln::people

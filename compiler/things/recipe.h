// Thing recipes: benches, bollards, signs and all else that a row of the table of things describes.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/features.h"

namespace citykiln::things {

/// All that decides the mesh of a thing. Things of one form share a mesh, the prototype. Values that the rule of the
/// kind does not read are empty.
struct Form {
  std::string kind;                               ///< The name of its row of the table.
  double width_m = 1, depth_m = 1, height_m = 1;  ///< Multiples of 2^-10, > 0.
  std::string value{}, material{}, text{};        ///< See map::ThingFeature.
  std::optional<map::Srgb> colour{};
  /// The tagged capacity, 0 if untagged. For signals it is the number of lanes, for contact masts the reach of the arm
  /// in quarters of a metre.
  std::uint16_t capacity = 0;
  map::CountryGroup country{};
  std::uint8_t variant = 0;  ///< Which of the random appearances; less than kVariants.
  auto operator<=>(const Form&) const = default;
};

/// The number of random appearances of a form whose rule draws random numbers.
inline constexpr std::uint8_t kVariants = 4;

/// Directions are counted in this many parts of a turn.
inline constexpr std::uint16_t kDirections = 1024;

/// A thing.
struct Thing {
  ObjectId id{};
  Vec2 at{};                    ///< The middle of its base, plane metres, snapped.
  std::uint16_t direction = 0;  ///< The direction that it faces: parts of a turn, counter-clockwise from east.
  bool is_in_way = false;       ///< True if it may stand in a carriageway, a wall or water, since it is mapped there.
  Form form;
  std::optional<double> foot_m{};  ///< The height of its lower end on a building, snapped. Empty: on the ground.
  bool operator==(const Thing&) const = default;
};

}  // namespace citykiln::things

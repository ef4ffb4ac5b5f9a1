// The light of a street lamp: how much, of which colour, in which directions.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/geometry/placement.h"
#include "compiler/map/lamp_tags.h"

namespace citykiln::props {

enum class LampKind : std::uint8_t {
  kPostTop,  ///< A lantern on a post: paths and quiet streets.
  kArm,      ///< A head on an arm over the road.
  kCount
};

/// The directions in which a luminaire shines.
enum class Beam : std::uint8_t {
  kLantern,  ///< Equally, up to 30° above the horizontal.
  kDown      ///< By the cosine of the angle from straight down, nothing above the horizontal: full cut-off.
};

struct Luminaire {
  float lumen = 0;  ///< Of the whole lamp.
  float temperature_k = 3000;
  Beam beam{};
  bool operator==(const Luminaire&) const = default;
};

/// Returns the light of a lamp: what is tagged, else by its type (map/lamp_types.inc), else by kind and height
/// (luminaires.inc). A lamp on a wall, a wire or a high mast shines down. height_m >= 0.
Luminaire luminaire_of(LampKind kind, double height_m, const map::LampTags& tags = {});

/// The kind that a lamp's mount says, else `otherwise`.
LampKind kind_of(map::LampMount mount, LampKind otherwise);

/// Returns the integral of a beam's shape, whose value on its axis is 1, over all directions: lumen over it are
/// candela. Steradians.
double beam_sr(Beam beam);

/// The sine of the angle above the horizontal up to which a lantern shines.
inline constexpr double kLanternRise = 0.5;

/// Returns the middle of a lamp's glass, plane metres.
Vec3 glass_of(const Placement& lamp, LampKind kind);

/// Returns the colour of a black body, linear Rec. 709 of luminance 1, from 1,000 K up: computed from the Planckian
/// locus (Kim et al., US patent 7024034, 2006, whose cubic splines hold from 1,667 K to 25,000 K; below as at 1,667 K).
/// Components are at least 0.
std::array<float, 3> black_body_colour(double temperature_k);

}  // namespace citykiln::props

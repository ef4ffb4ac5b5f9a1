// The light of a street lamp: luminous flux, colour and directions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/geometry/placement.h"
#include "compiler/map/lamps/lamp_tags.h"

namespace citykiln::props {

enum class LampKind : std::uint8_t {
  kPostTop,  ///< A lantern on a post: paths and quiet streets.
  kArm,      ///< A head on an arm over the road.
  kCount
};

/// The name of a kind in output files.
constexpr std::string_view name_of(LampKind kind) { return kind == LampKind::kArm ? "ArmLamp" : "PostTopLamp"; }

/// Returns the kind of lamps that instances of an output file are; nothing for other instances.
constexpr std::optional<LampKind> lamp_named(std::string_view name) {
  for (const LampKind kind : {LampKind::kPostTop, LampKind::kArm})
    if (name == name_of(kind)) return kind;
  return std::nullopt;
}

/// The directions in which a luminaire shines.
enum class Beam : std::uint8_t {
  kLantern,  ///< Equal intensity in all directions up to 30° above the horizontal.
  kDown      ///< Intensity is the cosine of the angle from straight down; none above the horizontal (full cut-off).
};

struct Luminaire {
  float lumen = 0;  ///< Luminous flux of the lamp, the sum of all its luminaires.
  float temperature_k = 3000;
  Beam beam{};
  bool operator==(const Luminaire&) const = default;
};

/// Returns the light of a lamp. The flux of each luminaire is the tagged one, else that of the lamp's kind and height
/// (luminaires.inc), at most that of its type (map/lamps/lamp_types.inc). The colour temperature is the tagged one,
/// else that of its type, else that of its kind and height. Lamps on an arm, a wall, a wire or a high mast shine down.
/// height_m >= 0, tags.count >= 1.
Luminaire luminaire_of(LampKind kind, double height_m, const map::LampTags& tags = {});

/// Returns the kind of a lamp with a mount, or `otherwise` if the mount does not determine the kind.
LampKind kind_of(map::LampMount mount, LampKind otherwise);

/// Returns the integral over all directions of a beam's relative intensity, which is 1 on its axis, in steradians.
/// Lumen divided by it are the candela on the axis.
double beam_sr(Beam beam);

/// The sine of the highest angle above the horizontal at which a lantern (Beam::kLantern) shines.
inline constexpr double kLanternRise = 0.5;

/// Returns the middle of a lamp's glass, plane metres.
Vec3 glass_of(const Placement& lamp, LampKind kind);

/// Returns the colour of a black body as linear Rec. 709 of luminance 1; components are at least 0. Computed from the
/// Planckian locus (Kim et al., US patent 7024034, 2006), whose cubic splines hold from 1,667 K to 25,000 K;
/// temperatures are clamped to that range.
std::array<float, 3> black_body_colour(double temperature_k);

}  // namespace citykiln::props

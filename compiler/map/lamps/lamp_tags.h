// Tags of a street lamp's light.
#pragma once

#include <cstdint>

namespace citykiln::map {

/// Types of light sources: rows of lamp_types.inc. The order is part of the manifest format: append only.
enum class LampType : std::uint8_t {
#define LAMP_TYPE(name, temperature_k, most_lm) name,
#include "compiler/map/lamps/lamp_types.inc"
#undef LAMP_TYPE
  kCount
};

/// Values of lamp_mount=*. The order is part of the manifest format: append only.
enum class LampMount : std::uint8_t {
  kUnknown,
  kStraightMast,
  kBentMast,
  kHighMast,
  kWall,
  kSuspended,
  kGround,
  kCount
};

/// The largest number of luminaires of a lamp.
inline constexpr std::uint8_t kMostLuminaires = 16;

/// Tagged values; missing ones are derived in props/luminaire.h.
struct LampTags {
  LampType type{};
  LampMount mount{};
  std::uint8_t count = 1;           ///< Number of luminaires: 1 to kMostLuminaires.
  std::uint16_t temperature_k = 0;  ///< Colour temperature, 1,000 to 20,000; 0: not tagged.
  std::uint32_t lumen = 0;          ///< Luminous flux of one luminaire, at most 1,000,000; 0: not tagged.
  bool operator==(const LampTags&) const = default;
};

/// A row of lamp_types.inc.
struct LampTypeValues {
  std::uint16_t temperature_k;  ///< Colour temperature; 0: it depends on the road (props/luminaires.inc).
  std::uint32_t most_lm;        ///< Largest luminous flux of one luminaire.
};

const LampTypeValues& values_of(LampType type);

}  // namespace citykiln::map

// The forms of tufts: grass and flowers that are smaller than a plant with an L-system.
#pragma once

#include <cstdint>

namespace citykiln::plants {

/// The form of a tuft.
enum class TuftForm : std::uint8_t {
  kMown,       ///< Short grass.
  kTall,       ///< Grass with ears.
  kDaisy,      ///< White florets about a yellow disc.
  kDandelion,  ///< A yellow head above a rosette.
  kClover,     ///< White clover: leaves of three leaflets, and a head.
  kButtercup,  ///< Small yellow flowers on high stalks.
  kCount
};

/// The number of variants of a form: tufts that are drawn differently.
inline constexpr std::uint8_t kTuftVariants = 4;

}  // namespace citykiln::plants

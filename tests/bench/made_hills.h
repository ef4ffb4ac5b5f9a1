// Made-up terrain for benchmarks of the ground.
#pragma once

#include <cmath>

#include "compiler/map/plane/heightfield.h"

namespace citykiln {

/// Returns hills of three wavelengths on 8 m squares, 1,024 m wide: 16,641 vertices.
inline map::Heightfield made_hills() {
  map::Heightfield field{{0, 0}, {8, 8}, 129, 129, {}};
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) {
      const double metres = 40 * std::sin(i * 0.05) + 12 * std::cos(j * 0.17) + 3 * std::sin(i * 0.7 + j * 0.5);
      field.heights.push_back(static_cast<std::int32_t>(metres / map::kHeightQuantum_m));
    }
  return field;
}

}  // namespace citykiln

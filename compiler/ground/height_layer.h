// The heights that one place of the carved ground can have: a kerb's face stands between two of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace citykiln::ground {

enum class HeightLayer : std::uint8_t { kLand, kRoad, kCarriageway, kWater, kCount };

/// Metres, one a layer.
using Heights = std::array<double, static_cast<std::size_t>(HeightLayer::kCount)>;

}  // namespace citykiln::ground

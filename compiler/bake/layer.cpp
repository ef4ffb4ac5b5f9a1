#include "compiler/bake/layer.h"

#include <array>
#include <cassert>

namespace citykiln::bake {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Layer::kCount)> kNames = {
    "ground", "roads", "water", "buildings", "structures", "props", "plants"};

}  // namespace

std::string_view name_of(Layer layer) {
  assert(layer < Layer::kCount);
  return kNames[static_cast<std::size_t>(layer)];
}

std::optional<Layer> layer_named(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<Layer>(i);
  return std::nullopt;
}

Layer layer_of(map::LandCoverClass surface) {
  switch (values_of(surface).group) {
    case map::LandCoverGroup::kWater:
      return Layer::kWater;
    case map::LandCoverGroup::kPaved:
    case map::LandCoverGroup::kRoad:
    case map::LandCoverGroup::kPath:
    case map::LandCoverGroup::kRail:
      return Layer::kRoads;
    default:
      return Layer::kGround;
  }
}

}  // namespace citykiln::bake

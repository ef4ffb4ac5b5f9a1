// The part of a scene's recipes that its tiles show: layers, the density of woods, and lights by night. A manifest
// holds all recipes whatever its tiles show.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace citykiln::scene {

/// The layers that tiles may leave out. The first seven are those of a tile (bake/layer.h), in the same order.
enum class SceneLayer : std::uint8_t {
  kGround,      ///< Land. Where roads, water or buildings are left out, it is there too, as land that is not mapped.
  kRoads,       ///< Paved ground, with its markings.
  kWater,       ///< Seas, lakes, rivers.
  kBuildings,   ///< Buildings.
  kStructures,  ///< Bridges with their roads, tunnels, stairs.
  kThings,      ///< Walls, fences, lamps, things, cars, people, wires, tree pits.
  kPlants,      ///< Trees, hedges, grass.
  kYards,       ///< The surfaces, paths, hedges, fences, trees and things of assumed yards.
  kCount        ///< The number of layers.
};

/// A set of layers: the bit of a layer is 1 shifted by its number.
using SceneLayers = std::uint8_t;
inline constexpr SceneLayers kNoLayers = 0, kAllLayers = 0xff;
static_assert(static_cast<int>(SceneLayer::kCount) == 8);

constexpr SceneLayers bit_of(SceneLayer layer) { return static_cast<SceneLayers>(1u << static_cast<unsigned>(layer)); }
constexpr bool has(SceneLayers layers, SceneLayer layer) { return (layers & bit_of(layer)) != 0; }

/// The name of a layer: "ground", "roads", "water", "buildings", "structures", "things", "plants" or "yards".
std::string_view name_of(SceneLayer layer);
/// Returns the layer with a name; nothing for other texts.
std::optional<SceneLayer> scene_layer_named(std::string_view name);

/// When street lamps are lit.
enum class LampLight : std::uint8_t {
  kBySun,  ///< While the sun is low enough (sky::are_lamps_lit()).
  kOn,     ///< At any time.
  kOff     ///< Never; no lamp is a light of tiles either.
};

/// The largest factor on the density of woods, and the step of its values.
inline constexpr double kDensestWoods = 4, kWoodDensityStep = 0x1p-10;
/// The step of Shown::lit_windows.
inline constexpr double kLitWindowsStep = 0x1p-10;

/// The part of the recipes that tiles show.
struct Shown {
  SceneLayers left_out = kNoLayers;
  /// A factor on Wood::trees_per_ha, from 0 to kDensestWoods, a multiple of kWoodDensityStep.
  double wood_density = 1;
  LampLight lamps = LampLight::kBySun;
  /// The share of flats, offices and shops with light in their windows while it is dark, from 0 to 1, a multiple of
  /// kLitWindowsStep. Empty: by use and hour (buildings/lit_windows.h).
  std::optional<double> lit_windows{};
  bool operator==(const Shown&) const = default;
};

/// A request to show something else; empty members keep what a scene shows.
struct ShownRequest {
  std::optional<SceneLayers> left_out{};
  std::optional<double> wood_density{};
  std::optional<LampLight> lamps{};
  /// Empty inside: by use and hour.
  std::optional<std::optional<double>> lit_windows{};
  bool operator==(const ShownRequest&) const = default;
};

/// Returns `shown` with what is requested.
Shown with_request(Shown shown, const ShownRequest& request);

}  // namespace citykiln::scene

// Layers: kinds of objects in a tile, for programs that show, hide or treat them differently.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/map/land_cover_class.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/scene/shown.h"

namespace citykiln::bake {

/// The layers, in the order of a tile's primitives and of its nodes in a .glb.
enum class Layer : std::uint8_t {
  kGround,      ///< Land, sports grounds, the ground below buildings.
  kRoads,       ///< Paved ground: roads, paths, rails, squares, pavements.
  kWater,       ///< Seas, lakes, rivers.
  kBuildings,   ///< Buildings.
  kStructures,  ///< Bridges with their roads, tunnels, stairs.
  kProps,       ///< Walls, fences, street lamps, things, wires, tree pits; at coarse tolerances hedges, as bands along
                ///< their lines.
  kPlants,      ///< Trees, grass, canopies of woods; at fine tolerances hedges, as single plants.
  kCount        ///< The number of layers.
};

/// The name of a layer: "ground", "roads", "water", "buildings", "structures", "props" or "plants".
std::string_view name_of(Layer layer);
/// Returns the layer with a name; nothing for other texts.
std::optional<Layer> layer_named(std::string_view name);

/// The layer of a face of the ground with a class of land cover.
Layer layer_of(map::LandCoverClass surface);

/// The layer of a scene that has the meshes of a layer of tiles.
constexpr scene::SceneLayer scene_layer_of(Layer layer) { return static_cast<scene::SceneLayer>(layer); }
static_assert(scene_layer_of(Layer::kGround) == scene::SceneLayer::kGround &&
              scene_layer_of(Layer::kRoads) == scene::SceneLayer::kRoads &&
              scene_layer_of(Layer::kWater) == scene::SceneLayer::kWater &&
              scene_layer_of(Layer::kBuildings) == scene::SceneLayer::kBuildings &&
              scene_layer_of(Layer::kStructures) == scene::SceneLayer::kStructures &&
              scene_layer_of(Layer::kProps) == scene::SceneLayer::kThings &&
              scene_layer_of(Layer::kPlants) == scene::SceneLayer::kPlants);

/// True if tiles show the meshes of a layer.
constexpr bool is_shown(const scene::Shown& shown, Layer layer) { return !has(shown.left_out, scene_layer_of(layer)); }

/// A mesh and the layer it belongs to.
struct LayeredMesh {
  materials::MaterialMesh mesh;
  Layer layer{};
};

}  // namespace citykiln::bake

// Small baked tiles that use every field of a tile, for tests of writers and readers.
#pragma once

#include <random>

#include "compiler/bake/image_uvs.h"
#include "compiler/materials/texture_cache.h"

namespace citykiln::exporters {

/// Returns triangles on the 2^-10 m grid, with the given number of corners.
inline bake::Primitive made_primitive(std::mt19937& dice, materials::Material material, std::uint32_t corners,
                                      std::uint32_t features, bake::Layer layer = bake::Layer::kGround) {
  const auto number = [&](int most) {
    return static_cast<float>(static_cast<int>(dice() % 2000) - 1000) * most * 0x1p-10f;
  };
  bake::Primitive p;
  p.material = material, p.layer = layer;
  for (std::uint32_t i = 0; i < corners; ++i) {
    p.positions.push_back({number(500), number(500), number(20)});
    p.normals.push_back(i % 2 == 0 ? bake::Float3{0, 0, 1} : bake::Float3{0.6f, 0, 0.8f});
    p.colours.push_back({static_cast<std::uint8_t>(dice()), 7, 255, 255});
    if (features > 0) p.features.push_back(static_cast<std::uint32_t>(dice()) % features);
  }
  for (std::uint32_t i = 0; i + 2 < corners; i += 3) p.triangles.push_back({i, i + 1, i + 2});
  return p;
}

/// Returns a mesh with placements, each with its own size.
inline bake::InstancedMesh made_instances(std::mt19937& dice, const char* name, int places, std::uint32_t features) {
  bake::InstancedMesh all{
      name, {made_primitive(dice, materials::Material::kGrass, 6, 0, bake::Layer::kPlants)}, {}, {}, {}, {}};
  for (int i = 0; i < places; ++i) {
    all.translations.push_back({static_cast<float>(i) + 0.25f, 0.0f, -3.5f});
    all.rotations.push_back(i % 2 == 0 ? bake::Float4{0, 0, 0, 1} : bake::Float4{0, 0, 0.6f, 0.8f});
    all.scales.push_back(0.7f + 0.1f * static_cast<float>(i));
    all.features.push_back(static_cast<std::uint32_t>(dice()) % features);
  }
  return all;
}

inline bake::BakedTile made_tile(std::uint32_t seed) {
  std::mt19937 dice(seed);
  bake::BakedTile tile;
  tile.tile = {-3, 17}, tile.origin = {-3072 + 512, 123456789, 431}, tile.tolerance_m = 0.1, tile.error_m = 0.0625;
  tile.object_error_m = tile.error_m, tile.plant_error_m = 0.375;
  tile.features = {{}, {OsmType::kNode, 5}, {OsmType::kWay, -12}, {OsmType::kRelation, (std::int64_t{1} << 53) + 1}};
  tile.attributes = {
      {}, {"oak", "", 12.3f}, {"Apartments", "Château «Ω»", 31, {{"building", "yes"}}}, {"Park", "Parc", 0}};
  tile.primitives = {made_primitive(dice, materials::Material::kGrass, 9, 4),
                     made_primitive(dice, materials::Material::kAsphalt, 30, 4, bake::Layer::kRoads)};
  tile.instanced = {made_instances(dice, "BroadLeaved", 4, 4), made_instances(dice, "NeedleLeaved", 3, 4)};
  return tile;
}

/// An image of few colours, whose texel size is not a binary fraction.
inline materials::TextureImage made_sheet(std::mt19937& dice) {
  materials::TextureImage sheet{0.02 + 0.001 * (dice() % 10), 5 + static_cast<std::uint32_t>(dice()) % 20, 48, {}};
  for (std::uint32_t i = 0; i < sheet.columns * sheet.rows; ++i) {
    const auto grey = static_cast<std::uint8_t>(60 + 60 * (dice() % 4));
    sheet.texels.push_back({grey, grey, 77});
  }
  return sheet;
}

/// Returns made_tile() with a road on the marking atlas, a road with uvs on its material, and an instanced mesh that is
/// partly on the marking atlas.
inline bake::BakedTile made_marked_tile(std::uint32_t seed) {
  std::mt19937 dice(seed + 1000);
  bake::BakedTile tile = made_tile(seed);
  tile.marking_atlas = made_sheet(dice);
  const auto laid_out = [&](materials::Material material, materials::ColourSource colour_source, std::uint32_t features,
                            bake::Layer layer) {
    bake::Primitive p = made_primitive(dice, material, 12, features, layer);
    for (const bake::Float3& at : p.positions) p.uvs.push_back({at[0], 8000 + at[1]});
    p.colour_source = colour_source;
    return p;
  };
  tile.primitives.push_back(
      laid_out(materials::Material::kAsphalt, materials::ColourSource::kByMaterial, 4, bake::Layer::kRoads));
  tile.primitives.push_back(
      laid_out(materials::Material::kAsphalt, materials::ColourSource::kByMarkingAtlas, 4, bake::Layer::kRoads));
  tile.primitives.push_back(
      laid_out(materials::Material::kPaving, materials::ColourSource::kByMarkingAtlas, 4, bake::Layer::kRoads));
  tile.instanced[0].primitives.push_back(
      laid_out(materials::Material::kPaintedMetal, materials::ColourSource::kByMarkingAtlas, 0, bake::Layer::kPlants));
  bake::snap_image_uvs(tile);
  return tile;
}

/// Adds leaves that are cut out of cards to a tree.
inline void make_leafy(std::mt19937& dice, bake::InstancedMesh& tree, bool has_normals) {
  bake::Primitive leaves = made_primitive(dice, materials::Material::kBroadLeaf, 12, 0, bake::Layer::kPlants);
  for (const bake::Float3& at : leaves.positions) leaves.uvs.push_back({at[0], at[2]});
  leaves.colour_source = materials::ColourSource::kByCutout;
  tree.primitives.push_back(leaves);
  impostor::Cutout cutout{made_sheet(dice), {}, {}};
  for (std::size_t i = 0; i < cutout.colour.texels.size(); ++i)
    cutout.opacity.push_back(static_cast<std::uint8_t>(dice()));
  if (has_normals) cutout.normal = made_sheet(dice);
  tree.cutout = std::move(cutout);
}

/// Returns a primitive of buildings whose features ascend.
inline bake::Primitive made_buildings(std::mt19937& dice, materials::Material material) {
  bake::Primitive p = made_primitive(dice, material, 12, 4, bake::Layer::kBuildings);
  for (std::size_t i = 0; i < p.features.size(); ++i) p.features[i] = static_cast<std::uint32_t>(1 + i / 6);
  return p;
}

/// Returns made_marked_tile() with buildings, some on a facade atlas, and leaves on cutouts, two of which are equal.
inline bake::BakedTile made_facade_tile(std::uint32_t seed) {
  std::mt19937 dice(seed + 3000);
  bake::BakedTile tile = made_marked_tile(seed);
  tile.facade_atlas.colour = made_sheet(dice);
  tile.facade_atlas.surface = tile.facade_atlas.colour;
  for (materials::TextureImage::Texel& texel : tile.facade_atlas.surface.texels)
    texel[2] = static_cast<std::uint8_t>(dice());
  if (seed % 2 == 1) tile.facade_atlas.emission = tile.facade_atlas.colour;
  if (seed % 3 == 1) tile.facade_atlas.normal = tile.facade_atlas.surface;
  tile.primitives.push_back(made_buildings(dice, materials::Material::kPaint));
  bake::Primitive facades = made_buildings(dice, materials::Material::kPaint);
  for (const bake::Float3& at : facades.positions) facades.uvs.push_back({at[0], at[2]});
  facades.colour_source = materials::ColourSource::kByAtlas;
  tile.primitives.push_back(facades);
  tile.instanced.push_back(made_instances(dice, "oak_0", 2, 4));
  for (bake::InstancedMesh& tree : tile.instanced) make_leafy(dice, tree, tree.name == "NeedleLeaved");
  tile.instanced.back().cutout = tile.instanced.front().cutout;
  bake::snap_image_uvs(tile);
  return tile;
}

/// Returns the tile without uvs. Uvs of a damaged file need not lie on the grid of their image, and move onto it.
inline bake::BakedTile without_uvs(bake::BakedTile tile) {
  const auto clear = [](std::vector<bake::Primitive>& primitives) {
    for (bake::Primitive& p : primitives) p.uvs.clear();
  };
  clear(tile.primitives);
  for (bake::InstancedMesh& instanced : tile.instanced) clear(instanced.primitives);
  return tile;
}

/// Returns made_marked_tile() with textures: land, water, a wall, a primitive too wide for 16 bits, one of a textured
/// material without uvs, and an instanced mesh with bark.
inline bake::BakedTile made_textured_tile(std::uint32_t seed) {
  std::mt19937 dice(seed + 2000);
  bake::BakedTile tile = made_marked_tile(seed);
  using materials::Material;
  const auto placed = [&](Material material, double step_m, bake::Layer layer = bake::Layer::kGround) {
    bake::Primitive p = made_primitive(dice, material, 12, 4, layer);
    for (std::size_t i = 0; i < p.positions.size(); ++i)
      p.uvs.push_back({static_cast<float>(dice() % 65536 * step_m), static_cast<float>(dice() % 65536 * step_m)});
    return p;
  };
  tile.primitives.clear();
  tile.primitives.push_back(placed(Material::kGrass, materials::kTextureCoordinateStep_m));
  tile.primitives.push_back(placed(Material::kRock, 1.25));
  tile.primitives.push_back(made_primitive(dice, Material::kStone, 12, 4));
  tile.primitives.push_back(placed(Material::kStone, materials::kTextureCoordinateStep_m));
  tile.primitives.push_back(placed(Material::kWater, materials::kTextureCoordinateStep_m, bake::Layer::kWater));
  tile.instanced[0].primitives.push_back(
      placed(Material::kPlatedBark, materials::kTextureCoordinateStep_m, bake::Layer::kPlants));
  tile.instanced[0].primitives.back().features.clear();
  const Material shown[] = {Material::kGrass, Material::kWater, Material::kRock, Material::kStone,
                            Material::kPlatedBark};
  tile.textures = materials::TextureCache(seed).textures_of(shown, 0.05);
  return tile;
}

}  // namespace citykiln::exporters

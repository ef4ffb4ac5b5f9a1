#include "compiler/bake/tiles/join_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "compiler/bake/image_uvs.h"
#include "compiler/bake/tiles/join_facade_atlases.h"
#include "compiler/bake/tiles/join_marking_atlases.h"

namespace citykiln::bake {
namespace {

/// The largest distance that rounding to single precision moves a point, as a share of its largest coordinate.
constexpr double kRounding = 1.7320508075688773 * 0x1p-24;

Vec3 lowest_origin(std::span<const BakedTile> tiles) {
  Vec3 low = tiles.front().origin;
  for (const BakedTile& tile : tiles) {
    low = {std::min(low.x, tile.origin.x), std::min(low.y, tile.origin.y), std::min(low.z, tile.origin.z)};
  }
  return low;
}

/// Exact within kExactReach_m, because tile origins and vertices are on the 2^-10 m grid.
Float3 moved(const Float3& p, Vec3 by, double& reach_m) {
  const Vec3 q{p[0] + by.x, p[1] + by.y, p[2] + by.z};
  reach_m = std::max({reach_m, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
}

Float2 slid(const Float2& uv, double across_m) { return {static_cast<float>(uv[0] + across_m), uv[1]}; }

/// A tile, and how its parts map to the joined tile.
struct SourceTile {
  const BakedTile& tile;
  Vec3 offset;                          ///< From the joined origin to the tile's.
  double marking_offset_m;              ///< Offset of its marking atlas in the joined one, metres along u.
  JoinedFacadeAtlases::Place on_atlas;  ///< Place of its facade atlas in the joined one.
  std::vector<std::uint32_t> features;  ///< The joined tile's feature index for each of its own.
};

SourceTile guest_of(const BakedTile& tile, const BakedTile& joined, double marking_offset_m,
                    const JoinedFacadeAtlases::Place& on_atlas) {
  SourceTile source{tile, tile.origin - joined.origin, marking_offset_m, on_atlas, {}};
  for (const OsmId feature : tile.features) {
    source.features.push_back(
        static_cast<std::uint32_t>(std::ranges::lower_bound(joined.features, feature) - joined.features.begin()));
  }
  return source;
}

Float2 on_joined(const Float2& uv, materials::ColourSource colour_source, const SourceTile& source) {
  if (colour_source == materials::ColourSource::kByMarkingAtlas) return slid(uv, source.marking_offset_m);
  if (colour_source != materials::ColourSource::kByAtlas) return uv;
  const auto& [at_m, scale] = source.on_atlas;
  return {static_cast<float>(at_m.x + scale * uv[0]), static_cast<float>(at_m.y + scale * uv[1])};
}

void add_primitive(Primitive& to, const Primitive& from, const SourceTile& source, double& reach_m) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  for (const Float3& p : from.positions) to.positions.push_back(moved(p, source.offset, reach_m));
  to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
  to.colours.insert(to.colours.end(), from.colours.begin(), from.colours.end());
  for (const std::uint32_t feature : from.features) to.features.push_back(source.features[feature]);
  for (const Float2& uv : from.uvs) to.uvs.push_back(on_joined(uv, from.colour_source, source));
  for (const auto& t : from.triangles) to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

void add_instanced(InstancedMesh& to, const InstancedMesh& from, const SourceTile& source, double& reach_m) {
  for (const Float3& p : from.translations) to.translations.push_back(moved(p, source.offset, reach_m));
  to.rotations.insert(to.rotations.end(), from.rotations.begin(), from.rotations.end());
  to.scales.insert(to.scales.end(), from.scales.begin(), from.scales.end());
  for (const std::uint32_t feature : from.features) to.features.push_back(source.features[feature]);
}

Primitive& primitive_of(BakedTile& joined, const PrimitiveKey& key) {
  const auto place = std::ranges::lower_bound(joined.primitives, key, {}, key_of);
  if (place != joined.primitives.end() && key_of(*place) == key) return *place;
  return *joined.primitives.insert(place,
                                   Primitive{key.material, {}, {}, {}, {}, {}, {}, key.colour_source, key.layer});
}

/// An instanced mesh with texture coordinates of the joined atlases.
std::vector<Primitive> on_joined(std::vector<Primitive> primitives, const SourceTile& source) {
  for (Primitive& primitive : primitives)
    for (Float2& uv : primitive.uvs) uv = on_joined(uv, primitive.colour_source, source);
  return primitives;
}

/// The joined mesh with this name and geometry, added if missing. Tiles may simplify the same prototype differently.
InstancedMesh& instanced_of(BakedTile& joined, const InstancedMesh& like, const SourceTile& source) {
  std::vector<Primitive> primitives = on_joined(like.primitives, source);
  for (InstancedMesh& instanced : joined.instanced) {
    if (instanced.name == like.name && instanced.primitives == primitives && instanced.cutout == like.cutout)
      return instanced;
  }
  return joined.instanced.emplace_back(InstancedMesh{like.name, std::move(primitives), {}, {}, {}, {}, like.cutout});
}

/// The attributes of the joined tile's features. A tile knows few attributes of its neighbours' objects, so attributes
/// with a height and a name are preferred.
std::vector<FeatureAttributes> joined_attributes(const std::vector<OsmId>& features, std::span<const BakedTile> tiles) {
  if (std::ranges::all_of(tiles, [](const auto& tile) { return tile.attributes.empty(); })) return {};
  std::vector<FeatureAttributes> joined(features.size());
  const auto rank = [](const FeatureAttributes& a) { return std::tie(a.height_m, a.name, a.tags, a.kind); };
  for (const BakedTile& tile : tiles)
    for (std::size_t i = 0; i < tile.attributes.size(); ++i) {
      const auto place = std::ranges::lower_bound(features, tile.features[i]) - features.begin();
      FeatureAttributes& known = joined[static_cast<std::size_t>(place)];
      const Assumptions assumed = known.assumed | tile.attributes[i].assumed;
      if (rank(known) < rank(tile.attributes[i])) known = tile.attributes[i];
      known.assumed = assumed;
    }
  return joined;
}

/// Adds one texture for each material: tiles of one tolerance and seed have equal textures.
void add_textures(BakedTile& joined, std::span<const BakedTile> tiles) {
  std::map<materials::Material, materials::SharedTexture> first;
  for (const BakedTile& tile : tiles)
    for (const materials::SharedTexture& texture : tile.textures) first.emplace(texture->material, texture);
  for (const auto& [material, texture] : first) joined.textures.push_back(texture);
}

}  // namespace

Result<BakedTile> join_tiles(std::span<const BakedTile> tiles, JoinPrecision precision) {
  assert(!tiles.empty());
  BakedTile joined{tiles.front().tile, lowest_origin(tiles), tiles.front().tolerance_m, 0, {}, {}, {}};
  std::set<OsmId> features;
  for (const BakedTile& tile : tiles) features.insert(tile.features.begin(), tile.features.end());
  joined.features.assign(features.begin(), features.end());
  joined.attributes = joined_attributes(joined.features, tiles);

  std::vector<const materials::TextureImage*> marking_atlases;
  for (const BakedTile& tile : tiles) marking_atlases.push_back(&tile.marking_atlas);
  Result<JoinedMarkingAtlases> joined_markings = join_marking_atlases(marking_atlases);
  if (!joined_markings) return joined_markings.error();
  joined.marking_atlas = std::move(joined_markings->image);

  std::vector<const impostor::Atlas*> atlases;
  for (const BakedTile& tile : tiles) atlases.push_back(&tile.facade_atlas);
  JoinedFacadeAtlases joined_atlases = join_facade_atlases(atlases);
  joined.facade_atlas = std::move(joined_atlases.atlas);

  add_textures(joined, tiles);

  double reach_m = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const BakedTile& tile = tiles[t];
    const SourceTile source = guest_of(tile, joined, joined_markings->offsets_m[t], joined_atlases.places[t]);
    for (const Primitive& p : tile.primitives) add_primitive(primitive_of(joined, key_of(p)), p, source, reach_m);
    for (const InstancedMesh& i : tile.instanced) add_instanced(instanced_of(joined, i, source), i, source, reach_m);
    joined.tolerance_m = std::min(joined.tolerance_m, tile.tolerance_m);
    joined.error_m = std::max(joined.error_m, tile.error_m);
    joined.object_error_m = std::max(joined.object_error_m, tile.object_error_m);
    joined.plant_error_m = std::max(joined.plant_error_m, tile.plant_error_m);
    if (tile.viewpoint && (!joined.viewpoint || joined.viewpoint->pixel_error < tile.viewpoint->pixel_error))
      joined.viewpoint = tile.viewpoint;
  }
  std::ranges::stable_sort(joined.instanced, {}, [](const InstancedMesh& i) { return layer_of(i); });
  snap_image_uvs(joined);
  if (reach_m > kExactReach_m) joined.error_m += reach_m * kRounding, joined.object_error_m += reach_m * kRounding;
  if (reach_m > kExactReach_m && precision == JoinPrecision::kExact) {
    return Error{"", fmt::format("the tiles extend over {:.0f} km, but one file is exact to 16 km only; bake fewer "
                                 "tiles, or bake to a folder",
                                 reach_m / 1000)};
  }
  return joined;
}

}  // namespace citykiln::bake

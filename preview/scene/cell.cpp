#include "preview/scene/cell.h"

#include <algorithm>
#include <limits>

namespace citykiln::preview {
namespace {

template <typename T>
std::size_t capacity_bytes(const std::vector<T>& all) {
  return all.capacity() * sizeof(T);
}

std::size_t bytes_of(const bake::Primitive& p) {
  return sizeof(p) + capacity_bytes(p.positions) + capacity_bytes(p.normals) + capacity_bytes(p.colours) +
         capacity_bytes(p.features) + capacity_bytes(p.triangles) + capacity_bytes(p.uvs);
}

std::size_t bytes_of(const std::vector<bake::Primitive>& primitives) {
  std::size_t bytes = 0;
  for (const bake::Primitive& primitive : primitives) bytes += bytes_of(primitive);
  return bytes;
}

// The positions are in the mesh part now.
void trim(bake::Primitive& p) {
  p.positions = {};
  p.normals.shrink_to_fit(), p.colours.shrink_to_fit(), p.features.shrink_to_fit();
  p.triangles.shrink_to_fit(), p.uvs.shrink_to_fit();
}

// The transforms are in the instance set now.
void trim(bake::InstancedMesh& instanced) {
  instanced.translations = {}, instanced.rotations = {}, instanced.scales = {};
  instanced.features.shrink_to_fit();
}

}  // namespace

bool SharedByCells::has_texture(const bake::Primitive& primitive, double tolerance_m) {
  using materials::ColourSource;
  const bool is_surface =
      primitive.colour_source == ColourSource::kByMaterial || primitive.colour_source == ColourSource::kByMarkingAtlas;
  return !primitive.uvs.empty() && is_surface && materials::has_texture(primitive.material, tolerance_m);
}

template <typename T, typename Make>
std::shared_ptr<const T> SharedByCells::shared(std::map<const void*, std::weak_ptr<const T>>& all, const void* key,
                                               Make make) {
  const std::lock_guard lock(mutex_);
  std::weak_ptr<const T>& known = all[key];
  if (std::shared_ptr<const T> alive = known.lock()) return alive;
  std::shared_ptr<const T> made = make();
  all[key] = made;
  return made;
}

namespace {

// An object with the bytes that it takes, as a pointer to the object.
template <typename T, typename Use, typename... Args>
std::shared_ptr<const T> counted(Use& in, std::shared_ptr<const void> source, Args&&... args) {
  struct Owner {
    std::shared_ptr<const void> source;
    T object;
    CountedBytes bytes;
    Owner(Use& in, std::shared_ptr<const void> from, Args&&... args)
        : source(std::move(from)), object(std::forward<Args>(args)...), bytes(in, object.bytes()) {}
  };
  const auto owner = std::make_shared<Owner>(in, std::move(source), std::forward<Args>(args)...);
  return {owner, &owner->object};
}

}  // namespace

std::shared_ptr<const MaterialTexture> SharedByCells::material(materials::Material material, double tolerance_m) {
  // the cache keeps it
  const materials::Texture& texture = *source_->prototypes().textures().texture(material, tolerance_m);
  return shared(materials_, &texture, [&] { return counted<MaterialTexture>(use_.textures, nullptr, texture); });
}

std::shared_ptr<const MipTexture> SharedByCells::marking_atlas(const std::shared_ptr<const bake::Markings>& markings) {
  if (!markings || markings->atlas.texels.empty()) return nullptr;
  return shared(atlases_, markings.get(),
                [&] { return counted<MipTexture>(use_.textures, markings, markings->atlas); });
}

std::shared_ptr<const CutoutTexture> SharedByCells::cutout(const impostor::SharedCutout& cutout) {
  if (cutout->colour.texels.empty()) return nullptr;
  return shared(cutouts_, &*cutout, [&] {
    return counted<CutoutTexture>(use_.textures, std::make_shared<impostor::SharedCutout>(cutout), *cutout);
  });
}

std::shared_ptr<const MeshScene> SharedByCells::prototype(const bake::BakedPrototype& prototype, double tolerance_m) {
  return shared(prototypes_, &prototype, [&] {
    auto kept = std::make_shared<std::vector<std::shared_ptr<const MaterialTexture>>>();
    std::vector<const MaterialTexture*> materials;
    for (const bake::Primitive& primitive : prototype.primitives) {
      if (has_texture(primitive, tolerance_m)) kept->push_back(material(primitive.material, tolerance_m));
      materials.push_back(has_texture(primitive, tolerance_m) ? kept->back().get() : nullptr);
    }
    return counted<MeshScene>(use_.geometry, kept, device_, prototype.primitives, nullptr, std::move(materials),
                              cutout(prototype.cutout));
  });
}

Cell::Cell(RTCDevice device, bake::BakedCell&& baked, Vec3 origin, SharedByCells& shared, MemoryUse& use)
    : device_(device), shared_(shared), baked_(std::move(baked)), geometry_(device) {
  for (bake::BakedCellPart& part : baked_.parts) add_part(part, baked_, origin);
  geometry_.commit();
  rtcGetSceneBounds(geometry_.scene(), &bounds_);
  bytes_ += geometry_.bytes();
  counted_.push_back(std::make_unique<CountedBytes>(use.geometry, bytes_));
  counted_.push_back(std::make_unique<CountedBytes>(use.textures, facade_bytes_));
  bytes_ += facade_bytes_;
}

void Cell::add_part(bake::BakedCellPart& part, const bake::BakedCell& baked, Vec3 origin) {
  const Vec3 offset = part.tile.origin - origin;
  add_primitives(part.tile, baked, offset);
  add_lamps(part.tile, baked, offset);
  for (bake::PlacedPrototype& placed : part.plants) {
    InstanceSet& set =
        geometry_.add(std::make_unique<InstanceSet>(shared_.prototype(*placed.prototype, baked.texture_m)));
    set.add(placed.instances, part.tile.features, offset);
    trim(placed.instances);
    bytes_ += capacity_bytes(placed.instances.features);
  }
  part.tile.features.shrink_to_fit();
  bytes_ += capacity_bytes(part.tile.features) + bytes_of(part.tile.primitives);
}

void Cell::add_primitives(bake::BakedTile& tile, const bake::BakedCell& baked, Vec3 offset) {
  const FacadeAtlasTexture* facade_atlas = nullptr;
  if (!tile.facade_atlas.colour.texels.empty()) {
    facade_atlas = facade_atlases_.emplace_back(std::make_unique<FacadeAtlasTexture>(tile.facade_atlas)).get();
    facade_bytes_ += facade_atlas->bytes();
  }
  for (bake::Primitive& primitive : tile.primitives) {
    std::shared_ptr<const MipTexture> atlas;
    if (primitive.colour_source == materials::ColourSource::kByMarkingAtlas)
      atlas = shared_.marking_atlas(baked.markings);
    std::shared_ptr<const MaterialTexture> material;
    if (SharedByCells::has_texture(primitive, baked.texture_m))
      material = shared_.material(primitive.material, baked.texture_m);
    MeshPart part = mesh_part_of(primitive, offset, atlas.get(), material.get(), facade_atlas);
    part.features = &tile.features;
    geometry_.add(std::move(part));
    trim(primitive);
    for (const std::shared_ptr<const void>& used :
         {std::shared_ptr<const void>(atlas), std::shared_ptr<const void>(material)})
      if (used) kept_.push_back(used);
  }
}

void Cell::add_lamps(bake::BakedTile& tile, const bake::BakedCell& baked, Vec3 offset) {
  for (bake::InstancedMesh& instanced : tile.instanced) {
    std::vector<const MaterialTexture*> materials;
    for (const bake::Primitive& primitive : instanced.primitives) {
      const bool has_texture = SharedByCells::has_texture(primitive, baked.texture_m);
      std::shared_ptr<const MaterialTexture> texture;
      if (has_texture) kept_.push_back(texture = shared_.material(primitive.material, baked.texture_m));
      materials.push_back(texture.get());
    }
    InstanceSet& set = geometry_.add(std::make_unique<InstanceSet>(std::make_shared<MeshScene>(
        device_, instanced.primitives, nullptr, std::move(materials), shared_.cutout(instanced.cutout))));
    set.add(instanced, tile.features, offset);
    trim(instanced);
    bytes_ += bytes_of(instanced.primitives) + capacity_bytes(instanced.features) + set.mesh().bytes();
  }
}

}  // namespace citykiln::preview

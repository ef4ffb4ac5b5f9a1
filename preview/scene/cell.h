// A cell: the meshes of all objects on one piece of the ground, generated on demand, with Embree's hierarchy. A
// prototype is a mesh that instances share, such as a tree.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "preview/scene/cell_source.h"
#include "preview/scene/scene_geometry.h"

namespace citykiln::preview {

/// The bytes that all cells use.
struct MemoryUse {
  std::atomic<std::int64_t> geometry = 0;  ///< Meshes and instances of cells and prototypes.
  std::atomic<std::int64_t> hierarchies = 0;
  std::atomic<std::int64_t> textures = 0;
};

/// Adds bytes to a counter for the lifetime of this object.
class CountedBytes {
 public:
  CountedBytes(std::atomic<std::int64_t>& in, std::size_t bytes) : in_(in), bytes_(static_cast<std::int64_t>(bytes)) {
    in_ += bytes_;
  }
  ~CountedBytes() { in_ -= bytes_; }
  CountedBytes(const CountedBytes&) = delete;
  CountedBytes& operator=(const CountedBytes&) = delete;

 private:
  std::atomic<std::int64_t>& in_;
  std::int64_t bytes_;
};

/// Meshes of prototypes, and textures, that several cells use at once. Each is found by the address of the object that
/// it is made from. Thread-safe.
class SharedByCells {
 public:
  SharedByCells(RTCDevice device, const CellSource& source, MemoryUse& use)
      : device_(device), source_(&source), use_(use) {}

  /// True if a primitive shows a texture of its material at a tolerance.
  static bool has_texture(const bake::Primitive& primitive, double tolerance_m);
  /// Returns the texture of a material, and makes it if no cell uses it yet.
  std::shared_ptr<const MaterialTexture> material(materials::Material material, double tolerance_m);
  /// Returns the marking atlas of a tile, and makes it if no cell uses it yet.
  std::shared_ptr<const MipTexture> marking_atlas(const std::shared_ptr<const bake::Markings>& markings);
  /// Returns the textures of a cutout, and makes them if no cell uses them yet.
  std::shared_ptr<const CutoutTexture> cutout(const impostor::SharedCutout& cutout);
  /// Returns the mesh of a prototype, with textures for a tolerance.
  std::shared_ptr<const MeshScene> prototype(const bake::BakedPrototype& prototype, double tolerance_m);

 private:
  template <typename T, typename Make>
  std::shared_ptr<const T> shared(std::map<const void*, std::weak_ptr<const T>>& all, const void* key, Make make);

  RTCDevice device_;
  const CellSource* source_;
  MemoryUse& use_;
  std::recursive_mutex mutex_;  // a prototype asks for its textures
  std::map<const void*, std::weak_ptr<const MaterialTexture>> materials_;
  std::map<const void*, std::weak_ptr<const MipTexture>> atlases_;
  std::map<const void*, std::weak_ptr<const CutoutTexture>> cutouts_;
  std::map<const void*, std::weak_ptr<const MeshScene>> prototypes_;
};

/// A generated cell. Immutable.
class Cell : public std::enable_shared_from_this<Cell> {
 public:
  /// @param origin  The world's origin in plane metres.
  Cell(RTCDevice device, bake::BakedCell&& baked, Vec3 origin, SharedByCells& shared, MemoryUse& use);

  const SceneGeometry& geometry() const { return geometry_; }
  /// Returns the bounds of the cell's meshes and instances, relative to the world's origin.
  const RTCBounds& bounds() const { return bounds_; }
  /// Returns the bytes of meshes, instances and facade textures that no other cell shares.
  std::size_t bytes() const { return bytes_; }

 private:
  void add_part(bake::BakedCellPart& part, const bake::BakedCell& baked, Vec3 origin);
  void add_primitives(bake::BakedTile& tile, const bake::BakedCell& baked, Vec3 offset);
  void add_lamps(bake::BakedTile& tile, const bake::BakedCell& baked, Vec3 offset);

  RTCDevice device_;
  SharedByCells& shared_;
  bake::BakedCell baked_;
  std::vector<std::unique_ptr<FacadeAtlasTexture>> facade_atlases_;
  std::vector<std::shared_ptr<const void>> kept_;  // shared textures
  SceneGeometry geometry_;
  RTCBounds bounds_{};
  std::size_t bytes_ = 0, facade_bytes_ = 0;
  std::vector<std::unique_ptr<CountedBytes>> counted_;
};

}  // namespace citykiln::preview

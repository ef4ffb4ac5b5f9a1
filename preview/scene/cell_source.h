// The cells of a scene of recipes, which are baked on request. A cell has the meshes of all objects on one piece of the
// ground; a tile consists of cells, and has one chunk of the scene's recipes.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "compiler/bake/cells/bake_cell.h"
#include "compiler/scene/scene.h"

namespace citykiln::preview {

/// The cells of a scene, baked for a view. Thread-safe. A cell depends on scene and view alone. The data that all cells
/// of a tile share are prepared when the first cell of the tile is baked, and kept until drop_tile() frees them.
class CellSource {
 public:
  /// @param textures  Textures that replace those of citykiln.
  CellSource(scene::Scene scene, const bake::View& view, std::vector<materials::Texture> textures = {});

  const scene::Scene& scene() const { return scene_; }
  const bake::ViewLevels& levels() const { return levels_; }
  std::size_t size() const { return cells_.size(); }
  /// Returns bounds of all that bake() returns for a cell, plane metres.
  const bake::Bounds& bounds(std::size_t cell) const { return cells_[cell].bounds; }
  const bake::PrototypeCache& prototypes() const { return *prototypes_; }
  /// Returns the meshes of a cell.
  /// @param cell  0 … size() - 1.
  bake::BakedCell bake(std::size_t cell) const;

  /// Returns the bytes of the prepared tiles; a bake in progress may prepare one more.
  std::size_t tile_bytes() const { return tile_bytes_; }
  /// Returns the time spent on preparing tiles, summed over threads.
  double preparing_s() const { return static_cast<double>(preparing_us_) * 1e-6; }
  /// Returns the number of times that a tile was prepared.
  std::size_t tiles_prepared() const { return prepared_; }
  /// Drops the prepared tile that was used least recently. Returns false if no tile but the one of the last bake is
  /// prepared, or if another thread prepares that tile now.
  bool drop_tile() const;

 private:
  struct Cell {
    std::size_t chunk, number;  // `number` is an index into the chunk's cells
    bake::Bounds bounds;
  };
  struct Tile {
    std::mutex preparing;
    std::shared_ptr<const bake::CellTile> prepared;
    std::size_t bytes = 0;
    std::atomic<std::uint64_t> used = 0;
  };

  std::shared_ptr<const bake::CellTile> prepared(std::size_t chunk) const;

  scene::Scene scene_;
  bake::ViewLevels levels_;
  std::shared_ptr<const bake::PrototypeCache> prototypes_;
  std::vector<Cell> cells_;
  mutable std::vector<Tile> tiles_;
  mutable std::atomic<std::size_t> tile_bytes_ = 0, prepared_ = 0;
  mutable std::atomic<std::uint64_t> clock_ = 0, preparing_us_ = 0;
};

}  // namespace citykiln::preview

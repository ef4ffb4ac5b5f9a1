// The ground cells of a scene of recipes, which are baked on request.
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

/// The ground cells of a scene, baked for a view. Thread-safe. A cell depends on scene and view alone. A tile is
/// prepared when the first of its cells is baked, and kept until it is dropped.
class CellSource {
 public:
  CellSource(scene::Scene scene, const bake::View& view);

  const scene::Scene& scene() const { return scene_; }
  const bake::ViewLevels& levels() const { return levels_; }
  std::size_t size() const { return cells_.size(); }
  /// Bounds of all that bake() returns for a cell, plane metres.
  const bake::Bounds& bounds(std::size_t cell) const { return cells_[cell].bounds; }
  const bake::PrototypeCache& prototypes() const { return *prototypes_; }
  bake::BakedCell bake(std::size_t cell) const;

  /// Bytes of the prepared tiles; a bake in progress may prepare one more.
  std::size_t tile_bytes() const { return tile_bytes_; }
  /// The time spent on preparing tiles, summed over threads.
  double preparing_s() const { return static_cast<double>(preparing_us_) * 1e-6; }
  /// The number of times that a tile was prepared.
  std::size_t tiles_prepared() const { return prepared_; }
  /// Drops the prepared tile that was used least recently. False if there is none but that of the last bake.
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

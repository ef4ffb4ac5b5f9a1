#include "preview/scene/cell_source.h"

#include <algorithm>
#include <chrono>

#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::preview {

CellSource::CellSource(scene::Scene scene, const bake::View& view, std::vector<materials::Texture> textures)
    : scene_(std::move(scene)),
      levels_(bake::levels_for(scene_, view)),
      prototypes_(
          std::make_shared<const bake::PrototypeCache>(scene_.header, bake::KeptPlants::kRecent, std::move(textures))),
      tiles_(scene_.chunks.size()) {
  const auto bounds = for_each_slot<std::vector<bake::Bounds>>(scene_.chunks.size(), 0, [&](std::size_t chunk) {
    return bake::cell_bounds(scene_.header, scene_.chunks[chunk], levels_);
  });
  for (std::size_t chunk = 0; chunk < bounds.size(); ++chunk)
    for (std::size_t number = 0; number < bounds[chunk].size(); ++number)
      cells_.push_back({chunk, number, bounds[chunk][number]});
}

std::shared_ptr<const bake::CellTile> CellSource::prepared(std::size_t chunk) const {
  Tile& tile = tiles_[chunk];
  const std::lock_guard lock(tile.preparing);
  tile.used = ++clock_;
  if (tile.prepared) return tile.prepared;
  const auto begin = std::chrono::steady_clock::now();
  tile.prepared = bake::prepare_cells(scene_.header, scene_.chunks[chunk], levels_, prototypes_);
  tile.bytes = bake::bytes_of(*tile.prepared);
  tile_bytes_ += tile.bytes, ++prepared_;
  const auto spent = std::chrono::steady_clock::now() - begin;
  preparing_us_ += static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(spent).count());
  return tile.prepared;
}

bake::BakedCell CellSource::bake(std::size_t cell) const {
  return bake::bake_cell(*prepared(cells_[cell].chunk), cells_[cell].number);
}

bool CellSource::drop_tile() const {
  Tile* oldest = nullptr;
  for (Tile& tile : tiles_)
    if (tile.used != 0 && tile.used != clock_ && (!oldest || tile.used < oldest->used)) oldest = &tile;
  if (!oldest) return false;
  std::shared_ptr<const bake::CellTile> dropped;
  // a tile that is in preparation stays
  const std::unique_lock lock(oldest->preparing, std::try_to_lock);
  if (!lock || !oldest->prepared) return false;
  dropped = std::move(oldest->prepared);
  tile_bytes_ -= oldest->bytes;
  oldest->used = 0;
  return true;
}

}  // namespace citykiln::preview

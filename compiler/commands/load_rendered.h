// Loads what preview renders: baked tiles, or the cells of a manifest, with cameras, sky and lamps.
#pragma once

#include <memory>
#include <vector>

#include "compiler/commands/camera_options.h"
#include "compiler/commands/load_cells.h"
#include "compiler/commands/load_tiles.h"
#include "preview/scene/cell_source.h"
#include "preview/scene/lamps.h"
#include "preview/scene/world.h"

namespace citykiln::commands {

/// What is asked for.
struct RenderedRequest {
  LoadRequest load;
  CellRequest cells;
  CameraRequest camera;
  int height_px = 0;  ///< Of the picture: cells are as fine as its pixels need.
};

/// What is rendered: tiles, or cells.
struct Rendered {
  Loaded loaded;  ///< Without tiles for cells.
  std::vector<preview::Camera> cameras{};
  sky::Sky sky{};
  std::shared_ptr<const preview::CellSource> cells{};  ///< Null for tiles. As the first camera needs them.
  std::vector<preview::StreetLamp> lamps{};            ///< By night.

  std::size_t tiles() const { return cells ? cells->scene().chunks.size() : loaded.tiles.size(); }
};

Result<Rendered> load_rendered(const RenderedRequest& request, const Console& console);

/// The scene for rays. Refers to `rendered`, which must outlive it.
preview::World world_of(const Rendered& rendered, const CellRequest& request);

}  // namespace citykiln::commands

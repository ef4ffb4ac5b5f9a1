// Loads a manifest for rendering straight from its recipes, cell by cell.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "compiler/commands/load_tiles.h"
#include "compiler/commands/verb.h"
#include "preview/camera/camera.h"
#include "preview/scene/cell_cache.h"

namespace citykiln::commands {

/// How much memory cells may take, and how fine they are.
struct CellRequest {
  std::size_t budget_bytes = 0;  ///< 0: default_budget_bytes().
  double pixel_error = 0.5;      ///< Largest error in the picture, pixels.
  double unseen_deg = 0;         ///< Largest angle of errors that only scattered light and reflections show.
  double finest_m = 0.02;        ///< The smallest tolerance, however near the eye. > 0.
};

/// Pictures of a scene.
struct Viewing {
  std::span<const preview::Camera> cameras;
  int width_px = 0, height_px = 0;  ///< Of each picture. > 0.
};

/// The eyes of all pictures, those at the end of a motion too.
Viewers viewers_of(const Viewing& viewing, double pixel_error);

/// 2 GB, or half of the machine's memory where that is less.
std::size_t default_budget_bytes();
/// What is asked for, or the default.
std::size_t budget_bytes_of(const CellRequest& request);

/// Stores a size of memory: "200MB", "4GB", "1.5GiB"; at least 1 MB.
Take store_bytes(std::size_t& bytes);

/// Whether a request asks for cells: a manifest without a tolerance.
bool asks_for_cells(const LoadRequest& request);

/// Reads the manifest, with the sky of the time that is asked for.
Result<scene::Scene> read_scene(const LoadRequest& request);

/// Coarse tiles of a scene, from which named views are chosen. Freed before rendering.
std::vector<bake::BakedTile> coarse_tiles(const scene::Scene& scene, int threads);

/// The cells of a scene as all of the pictures need them. What a single picture of a camera at rest does not show, nor
/// a shadow of the sun in it, may have errors up to the larger angle.
std::shared_ptr<const preview::CellSource> cells_for(scene::Scene scene, const Viewing& viewing,
                                                     const CellRequest& request);

/// One line: what the cells took.
std::string text_of(const preview::CellCounters& counters, std::size_t budget_bytes);
/// The counts behind that line, and more, as a JSON object.
nlohmann::ordered_json json_of(const preview::CellCounters& counters, std::size_t budget_bytes);

}  // namespace citykiln::commands

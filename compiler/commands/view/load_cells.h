// Loads a manifest (a compiled scene) for rendering from its recipes. A cell is a 128 m square of ground with the
// objects on it; it is generated when the first ray meets it.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "compiler/commands/verb.h"
#include "compiler/commands/view/load_tiles.h"
#include "preview/camera/camera.h"
#include "preview/scene/cell_cache.h"

namespace citykiln::commands {

/// The memory limit and the fineness of cells.
struct CellRequest {
  std::size_t budget_bytes = 0;  ///< 0: default_budget_bytes().
  double pixel_error = 0.5;      ///< The largest error of visible surfaces, in pixels.
  /// The largest error of cells that are neither in the picture nor cast a shadow into it, as an angle at the eye. 0:
  /// they have pixel_error too.
  double unseen_deg = 0;
  double finest_m = 0.02;                      ///< The smallest tolerance, however near the eye. > 0.
  std::vector<materials::Texture> textures{};  ///< Textures that replace those of citykiln.
};

/// The pictures to render.
struct Viewing {
  std::span<const preview::Camera> cameras;
  int width_px = 0, height_px = 0;  ///< The size of each picture. > 0.
};

/// Returns the viewpoints of all pictures; for a moving camera also the viewpoint at the end of the motion.
/// @param pixel_error  The largest error in a picture, in pixels.
Viewers viewers_of(const Viewing& viewing, double pixel_error);

/// Returns 2 GB, or half of the machine's memory if that is less.
std::size_t default_budget_bytes();
/// Returns the budget of the request, or the default.
std::size_t budget_bytes_of(const CellRequest& request);

/// Returns a function that stores a size of memory, such as "200MB", "4GB" or "1.5GiB", in a variable, which must
/// outlive the result. Its error: no such size, or less than 1 MB.
StoreValue store_bytes(std::size_t& bytes);

/// True if a request is for cells: a manifest without a tolerance.
bool asks_for_cells(const LoadRequest& request);

/// Reads the manifest and replaces its sky by the requested one. Errors: a manifest that cannot be read or has no
/// tiles.
Result<scene::Scene> read_scene(const LoadRequest& request);

/// Returns the cells of a scene, as fine as the pictures need. For a single camera at rest, cells that are neither in
/// the picture nor cast a shadow into it may have errors up to unseen_deg.
std::shared_ptr<const preview::CellSource> cells_for(scene::Scene scene, const Viewing& viewing,
                                                     const CellRequest& request);

/// Returns one line of text about the cells: their number, time and memory.
std::string text_of(const preview::CellCounters& counters, std::size_t budget_bytes);
/// Returns the counters as a JSON object, without preparing_s and prototype_bytes.
nlohmann::ordered_json json_of(const preview::CellCounters& counters, std::size_t budget_bytes);

}  // namespace citykiln::commands

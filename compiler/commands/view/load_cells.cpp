#include "compiler/commands/view/load_cells.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "compiler/commands/run_paths.h"
#include "compiler/commands/view/requested_sky.h"
#include "exporters/kiln/manifest.h"
#include "preview/camera/cell_view.h"

namespace citykiln::commands {
namespace {

struct Unit {
  std::string_view name;
  double bytes;
};
constexpr Unit kUnits[] = {{"kB", 1e3},  {"KB", 1e3},      {"MB", 1e6},     {"GB", 1e9},
                           {"TB", 1e12}, {"MiB", 1 << 20}, {"GiB", 1 << 30}};
constexpr double kLeast_bytes = 1e6, kMost_bytes = 1e15;

double megabytes(std::int64_t bytes) { return static_cast<double>(bytes) * 1e-6; }

std::int64_t total(const preview::CellCounters& c) { return c.geometry_bytes + c.hierarchy_bytes + c.texture_bytes; }

}  // namespace

std::size_t default_budget_bytes() {
  constexpr std::size_t kMost = 2'000'000'000;
  const long pages = sysconf(_SC_PHYS_PAGES), page_bytes = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page_bytes <= 0) return kMost;
  return std::min(kMost, static_cast<std::size_t>(pages) * static_cast<std::size_t>(page_bytes) / 2);
}

std::size_t budget_bytes_of(const CellRequest& request) {
  return request.budget_bytes > 0 ? request.budget_bytes : default_budget_bytes();
}

StoreValue store_bytes(std::size_t& bytes) {
  return [&bytes](const std::string& text) -> Result<Done> {
    const Error wrong{"", fmt::format("expected a size of at least 1 MB, such as 200MB or 4GB, found \"{}\"", text)};
    double number = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
    const auto known = std::ranges::find(kUnits, unit, &Unit::name);
    if (failed != std::errc() || known == std::end(kUnits)) return wrong;
    const double wanted = number * known->bytes;
    if (!(wanted >= kLeast_bytes && wanted <= kMost_bytes)) return wrong;
    bytes = static_cast<std::size_t>(wanted);
    return Done{};
  };
}

bool asks_for_cells(const LoadRequest& request) {
  return request.paths.size() == 1 && request.paths.front().ends_with(".kiln") && !request.tolerance_m;
}

Result<scene::Scene> read_scene(const LoadRequest& request) {
  const Result<std::string> path = find_committed_manifest(request.paths.front());
  if (!path) return path.error();
  Result<scene::Scene> scene = exporters::read_manifest(*path, request.only);
  if (!scene) return scene.error();
  if (scene->chunks.empty()) return Error{*path, "contains no tiles"};
  scene->header.sky = sky_of(request, scene->header);
  scene->header.shown = scene::with_request(scene->header.shown, request.shown);
  return scene;
}

Viewers viewers_of(const Viewing& viewing, double pixel_error) {
  Viewers viewers{.eyes = preview::eyes_of(viewing.cameras), .pixel_error = pixel_error};
  for (const preview::Camera& camera : viewing.cameras)
    viewers.focal_px = std::max(viewers.focal_px, bake::focal_length_px(viewing.height_px, camera.vertical_fov_deg));
  return viewers;
}

std::shared_ptr<const preview::CellSource> cells_for(scene::Scene scene, const Viewing& viewing,
                                                     const CellRequest& request) {
  const bake::View view = preview::cell_view(scene, viewing.cameras,
                                             {.width_px = viewing.width_px,
                                              .height_px = viewing.height_px,
                                              .pixel_error = request.pixel_error,
                                              .unseen_deg = request.unseen_deg,
                                              .finest_m = request.finest_m});
  return std::make_shared<preview::CellSource>(std::move(scene), view, request.textures);
}

std::string text_of(const preview::CellCounters& c, std::size_t budget_bytes) {
  std::string text = fmt::format(
      "cells: {} of {} generated in {:.1f} s, {} again; {:.0f} MB of {:.0f} MB (meshes {:.0f}, hierarchies {:.0f}, "
      "textures {:.0f}); beside it tiles {:.0f} MB in {:.1f} s, prototypes {:.0f} MB",
      c.generated - c.regenerated, c.cells, c.generating_s, c.regenerated, megabytes(total(c)),
      static_cast<double>(budget_bytes) * 1e-6, megabytes(c.geometry_bytes), megabytes(c.hierarchy_bytes),
      megabytes(c.texture_bytes), megabytes(c.tile_bytes), c.preparing_s, megabytes(c.prototype_bytes));
  if (c.over_bytes > 0)
    text += fmt::format("; the budget was exceeded by {:.1f} MB, which single cells needed", megabytes(c.over_bytes));
  if (c.outside_m > 0) text += fmt::format("; a cell was {:.3f} m larger than its bounds", c.outside_m);
  return text;
}

nlohmann::ordered_json json_of(const preview::CellCounters& c, std::size_t budget_bytes) {
  return {{"cells", c.cells},
          {"cells_generated", c.generated},
          {"cells_regenerated", c.regenerated},
          {"cells_evicted", c.evicted},
          {"tiles_prepared", c.tiles_prepared},
          {"generating_s", c.generating_s},
          {"budget_bytes", budget_bytes},
          {"peak_bytes", c.peak_bytes},
          {"over_bytes", c.over_bytes},
          {"geometry_bytes", c.geometry_bytes},
          {"hierarchy_bytes", c.hierarchy_bytes},
          {"texture_bytes", c.texture_bytes},
          {"tile_bytes", c.tile_bytes},
          {"outside_m", c.outside_m}};
}

}  // namespace citykiln::commands

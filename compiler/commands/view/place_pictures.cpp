#include "compiler/commands/view/place_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/commands/view/load_cells.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/sky/generate.h"
#include "exporters/gltf/glb.h"
#include "preview/picture/denoise.h"
#include "preview/picture/exposure.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

constexpr int kWidth_px = 480, kHeight_px = 270, kSamples = 3, kBounces = 1;
// Many places lie in boxes of eyes, in which no distance makes cells coarser: as fine as two pixels of the nearest
// place.
const CellRequest kFineness{.pixel_error = 2, .finest_m = 0.15};
constexpr double kFov_deg = 45;
constexpr double kNearest_m = 45, kFarthest_m = 150;
// Surfaces are looked for from this far above the terrain, each this far below the one before.
constexpr double kAbove_m = 1000, kThickness_m = 0.3;
constexpr std::size_t kMostSurfaces = 12;

// Angles above the horizon at which cameras are tried, in this order.
constexpr double kElevations_deg[] = {14, 25, 40, 60};
constexpr double kSteep_deg = 82;
constexpr int kAzimuths = 16;

double terrain_m_at(const scene::Scene& scene, Vec2 p) {
  const auto holds = [&](const scene::Chunk& chunk) { return scene::is_anchored(scene.header, chunk.tile, p); };
  const auto chunk = std::ranges::find_if(scene.chunks, holds);
  return chunk == scene.chunks.end() ? 0 : height_m_at(chunk->heights, p);
}

// The heights of all surfaces at a place, the highest first; the terrain's where there is none.
std::vector<double> surface_heights_m(const preview::World& world, const scene::Scene& scene, Vec2 p) {
  std::vector<double> heights_m;
  const double terrain_m = terrain_m_at(scene, p);
  double from_m = terrain_m + kAbove_m;
  while (heights_m.size() < kMostSurfaces) {
    const auto hit = world.first_hit(at_height(p, from_m) - world.origin(), {0, 0, -1});
    if (!hit) break;
    heights_m.push_back(from_m - hit->distance_m);
    from_m = heights_m.back() - kThickness_m;
  }
  if (heights_m.empty()) heights_m.push_back(terrain_m);
  return heights_m;
}

// The direction from a place to a camera; azimuth 0 is south, others follow on both sides.
Vec3 towards_camera(int azimuth, double elevation_deg) {
  const int step = azimuth % 2 == 0 ? azimuth / 2 : -(azimuth + 1) / 2;
  const double turn = 2 * std::numbers::pi * step / kAzimuths, up = elevation_deg * std::numbers::pi / 180;
  return {std::sin(turn) * std::cos(up), -std::cos(turn) * std::cos(up), std::sin(up)};
}

// True if a camera in a direction is in the open and sees the target.
bool is_free(const preview::World& world, Vec3 target, Vec3 direction, double far_m) {
  if (world.is_blocked(target + direction * far_m - world.origin(), {0, 0, 1})) return false;
  for (const double above_m : {0.5, 3.0})
    if (world.is_blocked(target + Vec3{0, 0, above_m} - world.origin(), direction, far_m)) return false;
  return true;
}

// The first camera that sees a target; none where everything hides it.
std::optional<preview::Camera> free_camera(const preview::World& world, Vec3 target, double far_m) {
  for (const double elevation_deg : kElevations_deg)
    for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
      const Vec3 direction = towards_camera(azimuth, elevation_deg);
      if (is_free(world, target, direction, far_m))
        return preview::Camera{target + direction * far_m, target, kFov_deg};
    }
  return std::nullopt;
}

preview::Camera camera_for(const preview::World& world, const scene::Scene& scene, const PlaceToShow& place) {
  const double far_m = std::clamp(2 * place.extent_m, kNearest_m, kFarthest_m);
  std::vector<double> heights_m = surface_heights_m(world, scene, place.at);
  if (place.on_roofs) heights_m.resize(1);
  for (auto height_m = heights_m.rbegin(); height_m != heights_m.rend(); ++height_m)
    if (const auto camera = free_camera(world, at_height(place.at, *height_m), far_m)) return *camera;
  const Vec3 target = at_height(place.at, heights_m.front());
  return {target + towards_camera(0, kSteep_deg) * far_m, target, kFov_deg};
}

// Cameras about as far from the places as the later ones: they decide how fine the cells are.
std::vector<preview::Camera> cameras_above(const scene::Scene& scene, std::span<const PlaceToShow> places) {
  std::vector<preview::Camera> cameras;
  for (const PlaceToShow& place : places) {
    const Vec3 target = at_height(place.at, terrain_m_at(scene, place.at));
    cameras.push_back({target + Vec3{0, 0, kNearest_m}, target, kFov_deg});
  }
  return cameras;
}

// The places in stripes, each from south to north: cells are generated once even where few fit into the budget.
std::vector<const PlaceToShow*> neighbours_together(std::span<const PlaceToShow> places) {
  std::vector<const PlaceToShow*> order;
  for (const PlaceToShow& place : places) order.push_back(&place);
  std::ranges::stable_sort(order, {}, [](const PlaceToShow* place) {
    return std::pair(std::floor(place->at.x / kFarthest_m), place->at.y);
  });
  return order;
}

struct Studio {
  const scene::Scene& scene;
  const preview::Lights& lights;
  preview::Options options;
};

Result<Done> write_picture(const Studio& studio, const preview::World& world, const PlaceToShow& place) {
  const preview::Camera camera = camera_for(world, studio.scene, place);
  preview::Image image =
      preview::denoise(preview::render(world, studio.lights, camera, studio.options), studio.options.threads);
  preview::expose(image, preview::metered_exposure(image));
  return preview::write_image(image, place.picture);
}

Result<Done> write_picture_of_tile(const Studio& studio, const PlaceToShow& place) {
  const Result<bake::BakedTile> tile = exporters::read_glb(place.tile);
  if (!tile) return tile.error();
  const preview::World world(std::span(&*tile, 1), at_height(place.at, 0));
  return write_picture(studio, world, place);
}

}  // namespace

Result<Done> write_place_pictures(const scene::Scene& scene, std::span<const PlaceToShow> places, int threads,
                                  const OnProgress& on_progress) {
  if (places.empty()) return Done{};
  const std::vector<preview::Camera> above = cameras_above(scene, places);
  const preview::World world(cells_for(scene, {above, kWidth_px, kHeight_px}, kFineness), above.front().eye,
                             default_budget_bytes());
  const preview::Lights lights(sky::generate(scene.header.sky, above.front().eye.z));
  Studio studio{scene, lights, {}};
  studio.options.width = kWidth_px, studio.options.height = kHeight_px, studio.options.samples = kSamples;
  studio.options.bounces = kBounces, studio.options.threads = threads, studio.options.has_guides = true;
  for (std::size_t done = 0; const PlaceToShow* place : neighbours_together(places)) {
    on_progress("pictures", static_cast<double>(done++) / static_cast<double>(places.size()));
    const Result<Done> written =
        place->tile.empty() ? write_picture(studio, world, *place) : write_picture_of_tile(studio, *place);
    if (!written) return written;
  }
  return Done{};
}

}  // namespace citykiln::commands

#include "compiler/commands/survey_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/kiln/manifest.h"

namespace citykiln::commands {
namespace {

/// The part of a survey within the halo of a region.
scene::Chunk chunk_of(const Survey& survey, const regions::RegionGrid& grid, regions::RegionKey region) {
  const Box2 near = regions::box_of(grid, region).widened(grid.halo_m);
  scene::Chunk chunk;
  chunk.tile = regions::tiles_of(grid, region).front();
  chunk.heights = map::window_of(survey.heights, near);
  std::ranges::copy_if(survey.waters, std::back_inserter(chunk.surfaces),
                       [&](const ground::LandCoverPolygon& water) { return ground::box_of(water).touches(near); });
  std::ranges::copy_if(survey.streams, std::back_inserter(chunk.watercourses),
                       [&](const roads::Strip& stream) { return box_of(stream.axis).touches(near); });
  return chunk;
}

}  // namespace

Result<Done> write_survey(const Survey& survey, const regions::RegionGrid& grid, const std::string& path, int threads) {
  scene::Scene scene{.header = survey.header, .chunks = {}};
  for (const regions::RegionKey region : regions::regions_of(grid))
    scene.chunks.push_back(chunk_of(survey, grid, region));
  std::ranges::sort(scene.chunks, {}, &scene::Chunk::tile);
  const std::vector<std::byte> bytes = exporters::encode_manifest(scene, threads);
  const Result<std::vector<std::byte>> before = exporters::read_file(path);
  return before && *before == bytes ? Done{} : exporters::write_file(path, bytes);
}

Result<RegionSurvey> read_survey(const std::string& path, const Plan& plan, regions::RegionKey region) {
  const scene::TileKey tile = regions::tiles_of(plan.grid, region).front();
  Result<scene::Scene> scene = exporters::read_manifest(path, std::span(&tile, 1));
  if (!scene) return scene.error();
  scene::Chunk& chunk = scene->chunks.front();
  const std::uint64_t hash =
      exporters::content_hash(fmt::format("{} {}", exporters::hash_of(scene->header), exporters::hash_of(chunk)));
  return RegionSurvey{{plan.extent, std::move(scene->header), std::move(chunk.heights), std::move(chunk.surfaces),
                       std::move(chunk.watercourses)},
                      hash};
}

}  // namespace citykiln::commands

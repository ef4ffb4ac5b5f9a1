#include "compiler/commands/plan/survey_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/kiln/manifest.h"

namespace citykiln::commands {
namespace {

std::string survey_path(const std::string& plan_folder, regions::RegionKey region) {
  return plan_folder + "/survey/" + to_string(region) + ".kiln";
}

/// The boxes of a survey's waters, found once for all regions.
struct WaterBoxes {
  std::vector<Box2> waters, streams;
};

WaterBoxes boxes_of(const Survey& survey) {
  WaterBoxes boxes;
  for (const ground::LandCoverPolygon& water : survey.waters) boxes.waters.push_back(ground::box_of(water));
  for (const roads::Strip& stream : survey.streams) boxes.streams.push_back(box_of(stream.axis));
  return boxes;
}

template <typename Water>
std::vector<Water> waters_near(const Box2& near, const std::vector<Water>& waters, const std::vector<Box2>& boxes) {
  std::vector<Water> found;
  for (std::size_t i = 0; i < waters.size(); ++i)
    if (boxes[i].touches(near)) found.push_back(waters[i]);
  return found;
}

/// The part of a survey within the halo of a region.
scene::Chunk surveyed_chunk(const Survey& survey, const WaterBoxes& boxes, const regions::RegionGrid& grid,
                            regions::RegionKey region) {
  const Box2 near = regions::box_of(grid, region).widened(grid.halo_m);
  scene::Chunk chunk;
  chunk.tile = regions::tiles_of(grid, region).front();
  chunk.heights = map::window_of(survey.heights, near);
  chunk.surfaces = waters_near(near, survey.waters, boxes.waters);
  chunk.watercourses = waters_near(near, survey.streams, boxes.streams);
  return chunk;
}

}  // namespace

Result<Done> write_survey(const Survey& survey, const regions::RegionGrid& grid, const std::string& plan_folder,
                          int threads) {
  std::error_code problem;
  std::filesystem::create_directories(plan_folder + "/survey", problem);
  if (problem) return Error{plan_folder + "/survey", "cannot be created: " + problem.message()};
  const WaterBoxes boxes = boxes_of(survey);
  for (const regions::RegionKey region : regions::regions_of(grid)) {
    if (regions::tiles_of(grid, region).empty()) continue;
    const scene::Scene scene{.header = survey.header, .chunks = {surveyed_chunk(survey, boxes, grid, region)}};
    const std::vector<std::byte> bytes = exporters::encode_manifest(scene, threads);
    const std::string path = survey_path(plan_folder, region);
    if (Result<Done> done = exporters::check_header(bytes, path); !done) return done;
    const Result<std::vector<std::byte>> before = exporters::read_file(path);
    if (before && *before == bytes) continue;
    if (Result<Done> done = exporters::write_file(path, bytes); !done) return done;
  }
  return Done{};
}

Result<RegionSurvey> read_survey(const std::string& plan_folder, const Plan& plan, regions::RegionKey region) {
  const scene::TileKey tile = regions::tiles_of(plan.grid, region).front();
  Result<scene::Scene> scene = exporters::read_manifest(survey_path(plan_folder, region), std::span(&tile, 1));
  if (!scene) return scene.error();
  scene::Chunk& chunk = scene->chunks.front();
  const std::uint64_t hash = exporters::content_hash(
      fmt::format("{} {}", exporters::hash_of(scene->header), exporters::hash_of(chunk, scene->header.seed)));
  return RegionSurvey{{plan.extent,
                       std::move(scene->header),
                       std::move(chunk.heights),
                       std::move(chunk.surfaces),
                       std::move(chunk.watercourses),
                       {}},
                      hash};
}

}  // namespace citykiln::commands

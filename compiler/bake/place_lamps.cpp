#include "compiler/bake/place_lamps.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "compiler/props/generate.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {

Lamps place_lamps(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, const Box2& box) {
  Lamps lamps{props::mapped_lamps(chunk.lamps, chunk.roads), chunk.lamps.size()};
  const std::vector<props::StreetLamp> derived = props::lamps_of_streets(chunk.roads, chunk.lamps, land_cover, box);
  lamps.standing.insert(lamps.standing.end(), derived.begin(), derived.end());
  return lamps;
}

std::vector<PlacedLamp> lamps_of(const scene::Header& header, const scene::Chunk& chunk) {
  if (!shows(header, scene::SceneLayer::kThings)) return {};
  constexpr double kFinest_m = 0.01;  // with kerbs
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(chunk);
  const Lamps lamps = place_lamps(chunk, ground::index_land_cover(surfaces, box.widened(scene::kHalo_m)), box);
  std::vector<PlacedLamp> placed;
  if (lamps.standing.empty()) return placed;
  const ground::GradedTerrain graded = scene::graded_terrain_of(header, chunk, kFinest_m);
  const scene::ClipTest clip(header.clip, box.widened(scene::kHalo_m));
  for (const props::StreetLamp& lamp : lamps.standing)
    if (clip.is_inside(lamp.at)) placed.push_back({props::place(lamp, graded), lamp.kind, lamp.light});
  return placed;
}

std::vector<PlacedLamp> brightest(std::vector<PlacedLamp> lamps, std::size_t most) {
  if (lamps.size() <= most) return lamps;
  std::vector<std::size_t> order(lamps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return lamps[i].light.lumen; });
  order.resize(most);
  std::ranges::sort(order);
  std::vector<PlacedLamp> chosen;
  for (const std::size_t i : order) chosen.push_back(lamps[i]);
  return chosen;
}

}  // namespace citykiln::bake

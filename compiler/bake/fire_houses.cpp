#include "compiler/bake/fire_houses.h"

#include <functional>
#include <utility>

#include "compiler/contract/for_each_slot.h"

namespace citykiln::bake {
namespace {

// Houses at several tolerances, with a report each. Rules are read once; houses are worked on side by side and told in
// order. What `holds` denies is left empty.
std::vector<Houses> expand_houses(const scene::Header& header, const scene::Chunk& chunk,
                                  std::span<const double> tolerances_m, int threads, std::span<Report> reports,
                                  const std::function<bool(const buildings::Building&)>& holds) {
  const std::vector<buildings::Building>& all = chunk.buildings;
  const buildings::Setting setting{header.seed, sky::is_night(header.sky)};
  const buildings::Rulebook rulebook = buildings::rulebook_of(buildings::styles_of(all), header.rules);
  std::vector<std::vector<Report>> told(all.size(), std::vector<Report>(tolerances_m.size()));
  std::vector<Houses> by_house = for_each_slot<Houses>(all.size(), threads, [&](std::size_t i) {
    if (!holds(all[i])) return Houses(tolerances_m.size());
    return buildings::expand(all[i], rulebook, setting, tolerances_m, told[i]);
  });
  std::vector<Houses> by_level(tolerances_m.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t l = 0; l < tolerances_m.size(); ++l) {
      by_level[l].push_back(std::move(by_house[i][l]));
      reports[l].append(told[i][l]);
    }
  return by_level;
}

// Pictures of facades go onto the tile's atlas, and the faces that show them to the house's other meshes.
void put_on_atlas(Firing& firing, Houses& houses) {
  std::vector<imprint::Picture> pictures;
  for (buildings::Expanded& house : houses)
    for (buildings::ImprintedMesh& face : house.imprinted) pictures.push_back(std::move(face.picture));
  imprint::AtlasLayout layout = imprint::lay_out(pictures, firing.tolerance_m);
  std::size_t picture = 0;
  for (buildings::Expanded& house : houses)
    for (buildings::ImprintedMesh& face : house.imprinted) {
      for (Vec2& uv : face.mesh.uvs) uv = uv + layout.at_m[picture];
      house.meshes.push_back(std::move(face.mesh));
      ++picture;
    }
  firing.tile.imprints = std::move(layout.atlas);
}

}  // namespace

void expand_imprinted(const scene::Header& header, const scene::Chunk& chunk, std::span<Level> levels, int threads) {
  std::vector<Level*> imprinted;
  std::vector<double> tolerances_m;
  for (Level& level : levels)
    if (level.tolerance_m >= buildings::kImprinted_m)
      imprinted.push_back(&level), tolerances_m.push_back(level.tolerance_m);
  if (imprinted.empty()) return;
  std::vector<Report> reports(imprinted.size());
  std::vector<Houses> houses =
      expand_houses(header, chunk, tolerances_m, threads, reports, [](const auto&) { return true; });
  for (std::size_t i = 0; i < imprinted.size(); ++i)
    imprinted[i]->houses = std::move(houses[i]), imprinted[i]->of_houses = std::move(reports[i]);
}

void fire_houses(Firing& firing, Level& level, int threads, Report& report) {
  const std::vector<buildings::Building>& all = firing.chunk.buildings;
  if (!level.houses)
    level.houses = std::move(expand_houses(firing.header, firing.chunk, std::span(&firing.tolerance_m, 1), threads,
                                           std::span(&level.of_houses, 1),
                                           [&](const auto& b) { return firing.holds(bounds_of(b)); })
                                 .front());
  report.append(level.of_houses);
  put_on_atlas(firing, *level.houses);
  fire_each(
      firing, all, "building", report, [](const auto& b) { return bounds_of(b); },
      [&](const auto& b) { return std::move((*level.houses)[static_cast<std::size_t>(&b - all.data())]); });
}

}  // namespace citykiln::bake

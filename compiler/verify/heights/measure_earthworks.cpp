#include "compiler/verify/heights/measure_earthworks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "compiler/ground/landforms/landform_index.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;

// Ways are sampled at this distance.
constexpr double kApart_m = 8;
// Smaller depths are not listed.
constexpr double kLeast_m = 0.5;

struct Row {
  std::string_view name;
  LandCoverClass surface;
  double least_width_m, limit_m;
};
constexpr Row kRows[] = {
#define LINE(name, surface, least_width_m, limit_m) {name, LandCoverClass::surface, least_width_m, limit_m},
#include "compiler/verify/heights/earthwork_limits.inc"
#undef LINE
};

std::string_view line_kind_of(LandCoverClass surface, double width_m) {
  const auto fits = [&](const Row& row) {
    return (row.surface == surface || row.surface == LandCoverClass::kCount) && width_m >= row.least_width_m;
  };
  return std::ranges::find_if(kRows, fits)->name;
}

// A line with a profile.
struct ProfiledLine {
  OsmId id;
  std::string_view name;
  const Polyline& axis;
  const Profile& profile;
  double start_along_m;
};

void add_if_deep(std::vector<Earthwork>& found, const Earthwork& deepest) {
  if (std::abs(deepest.depth_m) > kLeast_m) found.push_back(deepest);
}

// The terrain with landforms, before roads and water cut into it.
struct NaturalLand {
  const map::Heightfield& terrain;
  ground::LandformIndex landforms;

  double height_m(Vec2 p) const { return with_landforms_m(landforms, p, height_m_at(terrain, p)); }
};

// The deepest cut and the highest fill of a line in the box.
void measure_line(const ProfiledLine& line, const Box2& box, const NaturalLand& land, std::vector<Earthwork>& found) {
  if (line.profile.empty()) return;
  const std::vector<double> along = roads::distances_along(line.axis, line.start_along_m);
  Earthwork cut{line.id, line.name, 0, {}}, fill = cut;
  const auto sample = [&](Vec2 p, double at_m) {
    if (!box.contains_half_open(p)) return;
    const double depth_m = land.height_m(p) - knot_at(line.profile, at_m).z_m;
    if (depth_m > cut.depth_m) cut.depth_m = depth_m, cut.at = p;
    if (depth_m < fill.depth_m) fill.depth_m = depth_m, fill.at = p;
  };
  for (std::size_t i = 0; i + 1 < line.axis.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((along[i + 1] - along[i]) / kApart_m)));
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      sample(line.axis[i] + (line.axis[i + 1] - line.axis[i]) * t, along[i] + (along[i + 1] - along[i]) * t);
    }
  }
  add_if_deep(found, cut), add_if_deep(found, fill);
}

}  // namespace

std::vector<Earthwork> measure_earthworks(const scene::Header& header, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(header, chunk.tile);
  const NaturalLand land{chunk.heights, ground::index_landforms(chunk.landforms)};
  std::vector<Earthwork> found;
  for (const roads::Road& road : chunk.roads)
    measure_line(
        {road.id.osm, line_kind_of(road.surface, roads::width_m(road)), road.axis, road.profile, road.start_along_m},
        box, land, found);
  for (const roads::Strip& water : chunk.watercourses)
    measure_line({water.id.osm, line_kind_of(water.surface, water.left_m + water.right_m), water.axis, water.profile,
                  water.start_along_m},
                 box, land, found);
  return found;
}

std::vector<Earthwork> combined(std::vector<Earthwork> all) {
  const auto size_m = [](const Earthwork& e) { return std::abs(e.depth_m); };
  std::ranges::stable_sort(all, std::ranges::greater{}, size_m);
  std::map<std::pair<OsmId, bool>, bool> is_known;
  std::erase_if(all, [&](const Earthwork& e) { return !is_known.try_emplace({e.id, e.depth_m > 0}).second; });
  return all;
}

std::vector<Earthwork> measure_earthworks(const scene::Scene& scene) {
  std::vector<Earthwork> all;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const Earthwork& e : measure_earthworks(scene.header, chunk)) all.push_back(e);
  return combined(std::move(all));
}

std::vector<Earthwork> over_their_limits(std::span<const Earthwork> earthworks) {
  std::vector<Earthwork> over;
  for (const Earthwork& e : earthworks)
    if (std::abs(e.depth_m) > earthwork_limit_m(e.line)) over.push_back(e);
  return over;
}

double earthwork_limit_m(std::string_view line) {
  const auto row = std::ranges::find(kRows, line, &Row::name);
  return row == std::end(kRows) ? 0 : row->limit_m;
}

}  // namespace citykiln::verify

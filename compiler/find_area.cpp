#include "compiler/find_area.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/source/read_osm.h"

namespace citykiln {
namespace {

using source::OsmData;

bool is_administrative(const OsmData& osm, const source::Relation& relation) {
  return osm.value_of(relation.tags, "boundary") == "administrative";
}

bool has_name(const OsmData& osm, const source::Relation& relation, std::string_view name) {
  return osm.value_of(relation.tags, "name") == name || osm.value_of(relation.tags, "name:en") == name ||
         to_string(OsmId{OsmType::kRelation, relation.id}) == name;
}

const source::Area* area_of(const OsmData& osm, const source::Relation& relation) {
  const OsmId id{OsmType::kRelation, relation.id};
  const auto found = std::ranges::find(osm.areas, id, &source::Area::from);
  return found == osm.areas.end() ? nullptr : &*found;
}

// "Vaduz (r1155955, level 8)".
std::string area_text(const OsmData& osm, const source::Relation& relation) {
  const std::string_view level = osm.value_of(relation.tags, "admin_level");
  return fmt::format("{} ({}{}{})", osm.value_of(relation.tags, "name"),
                     to_string(OsmId{OsmType::kRelation, relation.id}), level.empty() ? "" : ", level ", level);
}

// The first areas of a list, as a text.
std::string listed(const OsmData& osm, const std::vector<const source::Relation*>& areas) {
  constexpr std::size_t kMost = 16;
  std::vector<std::string> texts;
  for (const source::Relation* area : areas) texts.push_back(area_text(osm, *area));
  std::ranges::sort(texts);
  const std::size_t more = texts.size() > kMost ? texts.size() - kMost : 0;
  texts.resize(texts.size() - more);
  return fmt::format("{}{}", fmt::join(texts, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

source::LonLatRing ring_of(const OsmData& osm, const source::AreaRing& ring) {
  source::LonLatRing points;
  for (const source::Location& at : osm.points_of(ring)) points.push_back({at.lon_deg(), at.lat_deg()});
  return points;
}

source::Outline outline_of(const OsmData& osm, const source::Area& area, std::string where) {
  source::Outline outline{std::move(where), {}};
  for (const source::AreaRing& ring : osm.rings_of(area)) {
    if (ring.is_outer)
      outline.polygons.push_back({ring_of(osm, ring), {}});
    else if (!outline.polygons.empty())
      outline.polygons.back().holes.push_back(ring_of(osm, ring));
  }
  return outline;
}

}  // namespace

Result<source::Outline> find_area(const OsmData& osm, const std::string& map_path, const std::string& name) {
  const std::string where = fmt::format("--area {}", name);
  std::vector<const source::Relation*> all, named;
  for (const source::Relation& relation : osm.relations) {
    if (!is_administrative(osm, relation)) continue;
    if (has_name(osm, relation, name)) named.push_back(&relation);
    if (area_of(osm, relation) != nullptr) all.push_back(&relation);
  }
  const std::string others = all.empty() ? "it has no complete administrative area" : "it has " + listed(osm, all);
  if (named.empty()) return Error{where, fmt::format("is no administrative area of {}; {}", map_path, others)};
  if (named.size() > 1)
    return Error{where, fmt::format("is the name of {} areas of {}; give one by its id: {}", named.size(), map_path,
                                    listed(osm, named))};
  const source::Area* area = area_of(osm, *named.front());
  if (area == nullptr)
    return Error{where, fmt::format("{} has a boundary that is not complete in {}; {}", area_text(osm, *named.front()),
                                    map_path, others)};
  return outline_of(osm, *area, where);
}

Result<source::Outline> find_area(const std::string& map_path, const std::string& name, int threads) {
  Report repeated;
  const Result<OsmData> osm = source::read_osm(map_path, threads, repeated);
  if (!osm) return osm.error();
  return find_area(*osm, map_path, name);
}

Result<Done> resolve_area(CompileSpec& spec) {
  if (spec.area.empty()) return Done{};
  if (spec.clip) return Error{"--area " + spec.area, "cannot be given with --clip; give one of them"};
  Result<source::Outline> outline = find_area(spec.map_path, spec.area, spec.threads);
  if (!outline) return outline.error();
  clip_to(std::move(*outline), spec);
  return Done{};
}

}  // namespace citykiln

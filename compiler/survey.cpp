#include "compiler/survey.h"

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/assume/curves/curves.h"
#include "compiler/contract/system/give_back_memory.h"
#include "compiler/edits/with_edits.h"
#include "compiler/ground/plan.h"
#include "compiler/make_header.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "compiler/whole_map.h"

namespace citykiln {
namespace {

/// The waters of an extract in the plane, and the places of its elements.
struct LocatedWaters {
  map::Features features;
  map::Places places;
};

/// Reads an extract and locates its elements, and frees the extract. Diagnoses are discarded: the regions make them.
Result<LocatedWaters> locate_waters(const CompileSpec& spec, const std::string& extract, const map::Plane& plane,
                                    const source::LonLatBox& extent) {
  Report repeated;
  Result<source::OsmData> osm = source::read_osm(extract, spec.threads, repeated);
  if (!osm) return osm.error();
  if (spec.edits) osm = edits::with_edits(std::move(*osm), *spec.edits, repeated).map;
  give_back_memory();
  return LocatedWaters{map::locate(*osm, plane, extent, spec.map, repeated), map::places_of_ways_and_areas(*osm)};
}

/// The waters of an extract without heights, and the places of its elements.
struct DryWaters {
  Box2 extent;
  ground::Waters waters;
  std::vector<Polyline> covered;  ///< Waterways in culverts and on aqueducts.
  std::vector<Polyline> coasts;
  map::Places places;
};

/// Reads waters in stages, each of which frees its memory before the next: together they hold several times the result.
Result<DryWaters> read_dry_waters(const CompileSpec& spec, const std::string& extract, const map::Plane& plane,
                                  const source::LonLatBox& extent) {
  Result<LocatedWaters> located = locate_waters(spec, extract, plane, extent);
  if (!located) return located.error();
  give_back_memory();
  Report repeated;
  map::FeatureView features = located->features;
  const bool is_curved = has(spec.assume, Assumption::kCurves);
  const std::vector<map::Waterway> curved =
      is_curved ? assume::curved_waterways(features.waterways) : std::vector<map::Waterway>{};
  if (is_curved) features.waterways = curved;
  return DryWaters{features.extent, plan_dry_waters(features, repeated), ground::covered_waterways(features),
                   std::move(located->features.coasts), std::move(located->places)};
}

/// Returns only the places of elements that are diagnosed.
map::Places of_diagnosed(map::Places places, const Report& report) {
  std::set<OsmId> named;
  for (const Diagnosis& diagnosis : report.diagnoses()) named.insert(diagnosis.object);
  std::erase_if(places, [&](const auto& place) { return !named.contains(place.first); });
  return places;
}

/// Replaces each object by the one in `known` with the same id. Both are sorted by id.
template <typename Object>
void replace_known(std::vector<Object>& objects, const std::vector<Object>& known) {
  for (Object& object : objects) {
    const auto found = std::ranges::lower_bound(known, object.id, {}, &Object::id);
    if (found != known.end() && found->id == object.id) object = *found;
  }
}

}  // namespace

Result<Survey> survey(const CompileSpec& spec, const std::string& extract, const source::LonLatBox& extent,
                      Report& report, const OnProgress& on_progress) {
  StageTimer timer(on_progress);
  timer.enter("survey");
  const map::Plane plane(spec.map.origin.value_or(map::default_origin(extent)));
  Result<DryWaters> dry = read_dry_waters(spec, extract, plane, extent);
  if (!dry) return dry.error();
  give_back_memory();
  Result<map::Heightfield> heights = read_heights(spec, plane, dry->extent, report);
  if (!heights) return heights.error();
  ground::Waters waters = ground::plan_water_heights(std::move(dry->waters.surfaces), std::move(dry->waters.streams),
                                                     dry->covered, *heights, report);
  Result<scene::Header> header =
      make_header(spec, plane, dry->extent, {.heights = *heights, .surfaces = waters.surfaces, .coasts = dry->coasts});
  if (!header) return header.error();
  timer.finish();
  return Survey{extent,
                std::move(*header),
                std::move(*heights),
                std::move(waters.surfaces),
                std::move(waters.streams),
                of_diagnosed(std::move(dry->places), report)};
}

ground::Waters surveyed_waters(const map::FeatureView& features, const Survey& survey, Report& report) {
  ground::Waters waters = plan_dry_waters(features, report);
  std::ranges::stable_sort(waters.streams, {}, &roads::Strip::id);
  // the survey has no land on which a pond could lie
  std::vector<std::uint8_t> raised;
  for (const ground::LandCoverPolygon& surface : waters.surfaces) raised.push_back(surface.raised_priority);
  replace_known(waters.surfaces, survey.waters);
  for (std::size_t i = 0; i < raised.size(); ++i) waters.surfaces[i].raised_priority = raised[i];
  replace_known(waters.streams, survey.streams);
  return waters;
}

}  // namespace citykiln

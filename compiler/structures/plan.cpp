#include "compiler/structures/plan.h"

#include <algorithm>
#include <cassert>

#include "compiler/roads/roads_on_ground.h"
#include "compiler/structures/plan_parapet_gaps.h"
#include "compiler/structures/plan_piers.h"
#include "compiler/structures/plates.h"
#include "compiler/structures/span_ends.h"
#include "compiler/structures/tunnel.h"
#include "compiler/structures/within_extent.h"

namespace citykiln::structures {
namespace {

Span span_of(const map::Track& track, const Profile& profile, const SpanEnds& ends) {
  Span span{roads::road_of(track), ends.from, ends.to};
  span.profile = profile;
  span.layer = track.layer;
  // crossings and signals are tagged for roads on the ground
  span.points.clear();
  return span;
}

void count_spans(Report& report, const char* kind, std::span<const Span> spans) {
  Account& account = report.account("structures", kind);
  for (const Span& span : spans) account.in += report.counts(span.id.osm), account.out += report.counts(span.id.osm);
}

// Diagnoses areas that are bridges and became no plate.
void diagnose_missing_plates(const map::FeatureView& features, std::span<const Span> bridges, Report& report) {
  for (const map::BridgeArea& area : features.bridge_areas) {
    const auto is_plate_of_area = [&](const Plate& plate) { return plate.id == area.id.osm; };
    if (std::ranges::none_of(bridges, [&](const Span& b) { return std::ranges::any_of(b.plates, is_plate_of_area); }))
      report.add(Code::kBridgeAreaWithoutDeck, area.id.osm);
  }
}

}  // namespace

Structures plan(const map::FeatureView& features, std::span<const Profile> off_ground, const map::Heightfield& heights,
                Report& report) {
  Structures structures;
  const std::vector<SpanEnds> ends = find_ends(features);
  std::size_t next = 0;
  for (const map::Track& track : features.tracks) {
    if (track.passage == map::Passage::kGround) continue;
    assert(next < off_ground.size());
    Span span = span_of(track, off_ground[next], ends[next]);
    ++next;
    const bool is_bridge = track.passage == map::Passage::kBridge;
    span.is_bored = !is_bridge && is_underground(span, heights);
    if (!is_bridge && !span.is_bored) report.add(Code::kTunnelNotMeshed, track.id.osm);
    (is_bridge ? structures.bridges : structures.tunnels).push_back(std::move(span));
  }
  std::ranges::sort(structures.bridges, {}, &Span::id);
  std::ranges::sort(structures.tunnels, {}, &Span::id);
  structures.bridges = with_plates(std::move(structures.bridges), features);
  diagnose_missing_plates(features, structures.bridges, report);
  count_spans(report, "bridge", structures.bridges);
  count_spans(report, "tunnel", structures.tunnels);
  structures.bridges = find_parapet_gaps(std::move(structures.bridges));
  return structures;
}

Structures with_piers(const Structures& spans, const ground::GradedTerrain& graded,
                      std::span<const ground::LandCoverPolygon> obstacles, const Box2& extent, Report& report) {
  return within_extent({place_piers(spans.bridges, graded, obstacles, report), spans.tunnels}, extent, report);
}

}  // namespace citykiln::structures

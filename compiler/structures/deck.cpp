#include "compiler/structures/deck.h"

#include <algorithm>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/pieces/lane_strips.h"

namespace citykiln::structures {
namespace {

using materials::MaterialMesh;
using roads::LaneStrip;

// Slabs have their full thickness within this share of the half width.
constexpr double kFullThicknessShare = 0.65;
// In a parapet gap the edge stays below the road of the other deck.
constexpr double kGapRise_m = -0.03125;

bool is_open(const std::vector<ParapetGap>& openings, double at_m) {
  return std::ranges::any_of(openings, [&](const ParapetGap& o) { return o.from_m < at_m && at_m < o.to_m; });
}

bool is_raised(const LaneStrip& strip) {
  return strip.lanes.empty() ? strip.surface == map::LandCoverClass::kKerb : strip.lanes.front().is_raised;
}

// The rise of each strip above the road's edges: carriageways are a kerb lower than raised strips.
std::vector<double> rises_of(const Span& bridge, const std::vector<LaneStrip>& strips, bool has_kerbs) {
  const bool is_low = has_kerbs && (roads::raised_left_m(bridge) > 0 || roads::raised_right_m(bridge) > 0);
  std::vector<double> rises;
  for (const LaneStrip& strip : strips) rises.push_back(is_low && !is_raised(strip) ? -ground::kKerbRise_m : 0);
  return rises;
}

roads::MarkingLayout marking_layout_of(const Span& bridge, const LaneStrip& strip) {
  roads::MarkingLayout layout{strip.surface,         strip.lanes, roads::StretchKind::kAlong,
                              roads::Control::kNone, bridge.side, roads::practice_of(bridge.country)};
  layout.has_kerb_left = strip.has_kerb_left, layout.has_kerb_right = strip.has_kerb_right;
  return layout;
}

// u runs across from the strip's left edge, v along the axis.
std::vector<Vec2> uvs_of(std::span<const Rib> ribs, double width_m) {
  std::vector<Vec2> uvs;
  for (const Rib& rib : ribs) uvs.insert(uvs.end(), {Vec2{0, rib.along_m}, Vec2{width_m, rib.along_m}});
  return uvs;
}

void add_strip(const Span& bridge, std::span<const Rib> ribs, const LaneStrip& strip, double rise_m, bool may_be_marked,
               GeneratedStructure& generated) {
  MaterialMesh dressed{{}, values_of(strip.surface).material, materials::kNoTint, bridge.id.osm};
  add_band(ribs, {strip.left_m, rise_m}, {strip.right_m, rise_m}, dressed.mesh);
  if (may_be_marked && !strip.lanes.empty()) {
    roads::MarkingLayout layout = marking_layout_of(bridge, strip);
    if (roads::needs_column(layout)) {
      dressed.uvs = uvs_of(ribs, strip.left_m - strip.right_m);
      generated.marked.push_back({std::move(dressed), std::move(layout)});
      return;
    }
  }
  generated.meshes.push_back(std::move(dressed));
}

// The top of the road from left to right, two corners per strip.
Section top_of(const std::vector<LaneStrip>& strips, const std::vector<double>& rises) {
  Section top;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    top.push_back({strips[i].left_m, rises[i]});
    top.push_back({strips[i].right_m, rises[i]});
  }
  return top;
}

// The section of the slab without its top, from the road's right end to its left end.
Section below_of(const DeckDimensions& shape, double left_top, double right_top) {
  const double out_left = shape.left_m + kParapet_m, out_right = -shape.right_m - kParapet_m;
  Section below = {{-shape.right_m, right_top}, {out_right, right_top}, {out_right, -shape.edge_m}};
  if (shape.thickness_m > shape.edge_m) {
    below.push_back({-shape.right_m * kFullThicknessShare, -shape.thickness_m});
    below.push_back({shape.left_m * kFullThicknessShare, -shape.thickness_m});
  }
  for (const Corner c : {Corner{out_left, -shape.edge_m}, Corner{out_left, left_top}, Corner{shape.left_m, left_top}})
    below.push_back(c);
  return below;
}

Mesh slab_of(std::span<const Rib> ribs, const Section& top, const Section& below) {
  Mesh mesh;
  add_kerb_faces(ribs, top, mesh);
  Section round = below;
  round.insert(round.begin(), top.back());
  round.push_back(top.front());
  for (std::size_t i = 0; i + 1 < round.size(); ++i)
    if (round[i] != round[i + 1]) add_band(ribs, round[i], round[i + 1], mesh);

  const Section whole = closed_section(top, below);
  add_cap(ribs.front(), whole, true, mesh);
  add_cap(ribs.back(), whole, false, mesh);
  return mesh;
}

}  // namespace

Section add_road(const Span& span, std::span<const Rib> ribs, bool has_kerbs, double lane_tolerance_m,
                 GeneratedStructure& generated) {
  const std::vector<LaneStrip> strips = roads::lane_strips_of(span, lane_tolerance_m);
  const std::vector<double> rises = rises_of(span, strips, has_kerbs);
  for (std::size_t i = 0; i < strips.size(); ++i) add_strip(span, ribs, strips[i], rises[i], has_kerbs, generated);
  return top_of(strips, rises);
}

void add_kerb_faces(std::span<const Rib> ribs, const Section& road, Mesh& mesh) {
  for (std::size_t i = 1; i + 1 < road.size(); i += 2)
    if (road[i] != road[i + 1]) add_band(ribs, road[i], road[i + 1], mesh);
}

std::vector<Rib> with_gap_ribs(const Span& bridge, std::span<const Rib> ribs) {
  std::vector<Rib> all(ribs.begin(), ribs.end());
  for (const auto* side : {&bridge.left_gaps, &bridge.right_gaps})
    for (const ParapetGap& o : *side)
      for (const double at_m : {o.from_m, o.to_m})
        if (ribs.front().along_m < at_m && at_m < ribs.back().along_m) all.push_back(rib_at(ribs, at_m));
  std::ranges::stable_sort(all, {}, &Rib::along_m);
  erase_repeated(all, &Rib::along_m);
  return all;
}

std::vector<EdgeRun> edge_runs(const Span& bridge, std::span<const Rib> ribs) {
  std::vector<EdgeRun> runs;
  for (std::size_t i = 0; i + 1 < ribs.size(); ++i) {
    const double middle_m = (ribs[i].along_m + ribs[i + 1].along_m) / 2;
    const bool left = is_open(bridge.left_gaps, middle_m), right = is_open(bridge.right_gaps, middle_m);
    if (runs.empty() || runs.back().is_left_open != left || runs.back().is_right_open != right)
      runs.push_back({{ribs[i]}, left, right});
    runs.back().ribs.push_back(ribs[i + 1]);
  }
  return runs;
}

Section closed_section(const Section& road, const Section& round) {
  Section outline = road;
  outline.insert(outline.end(), round.begin(), round.end());
  outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  if (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  return outline;
}

void add_deck(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& shape, const DeckDetail& detail,
              double lane_tolerance_m, GeneratedStructure& generated) {
  const Section top = add_road(bridge, ribs, detail.has_kerbs, lane_tolerance_m, generated);
  if (!detail.has_slab) return;
  for (const EdgeRun& run : edge_runs(bridge, ribs)) {
    const auto edge = [&](bool is_open) { return !detail.has_parapets ? 0 : is_open ? kGapRise_m : shape.parapet_m; };
    const Section below = below_of(shape, edge(run.is_left_open), edge(run.is_right_open));
    generated.meshes.push_back(
        {slab_of(run.ribs, top, below), materials::Material::kConcrete, materials::kNoTint, bridge.id.osm});
  }
}

}  // namespace citykiln::structures

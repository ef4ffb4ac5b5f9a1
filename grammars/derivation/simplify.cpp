#include "grammars/derivation/simplify.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "grammars/derivation/sizes.h"

namespace citykiln::grammars {
namespace {

double area_m2_of(const Terminal& terminal) {
  double sum_m2 = 0;
  for (const Face& face : terminal.faces) sum_m2 += area_m2(face);
  return sum_m2;
}

/// The detail that a simplification would replace.
struct Replaced {
  AppearanceAreas areas_m2;      ///< The areas of all detail, including that of simplified terminals.
  std::uint32_t appearance = 0;  ///< The appearance of most of the area.
  /// The texture of the largest terminal with that appearance; index into Tables::textures.
  std::uint32_t texture = 0;
};

std::size_t vertices_from(const Run& run, std::size_t first) {
  constexpr std::size_t kAsset = 1000;  // an asset is always worth replacing
  std::size_t count = 0;
  for (std::size_t i = first; i < run.out.terminals.size(); ++i) {
    const Terminal& terminal = run.out.terminals[i];
    count += terminal.asset.empty() ? vertex_count(terminal.faces) : kAsset;
  }
  return count;
}

void add_areas(const Run& run, std::size_t i, AppearanceAreas& areas_m2) {
  const Terminal& terminal = run.out.terminals[i];
  if (run.origins[i].replaced_areas == 0) {
    areas_m2[terminal.appearance] += area_m2_of(terminal);
  } else {
    for (const auto& [appearance, m2] : run.tables.appearance_areas[run.origins[i].replaced_areas])
      areas_m2[appearance] += m2;
  }
}

// Areas that are equal but for rounding are not larger, so that the first one is chosen on every machine.
bool is_larger(double a_m2, double b_m2) { return a_m2 > b_m2 + 1e-6 * std::abs(b_m2); }

std::uint32_t most_common_appearance(const AppearanceAreas& areas_m2) {
  double most_m2 = -1;
  std::uint32_t appearance = 0;
  for (const auto& [each, m2] : areas_m2)
    if (is_larger(m2, most_m2)) most_m2 = m2, appearance = each;
  return appearance;
}

Replaced replaced_from(const Run& run, std::size_t first) {
  Replaced replaced;
  for (std::size_t i = first; i < run.out.terminals.size(); ++i) add_areas(run, i, replaced.areas_m2);
  replaced.appearance = most_common_appearance(replaced.areas_m2);
  double largest_m2 = -1;
  for (std::size_t i = first; i < run.out.terminals.size(); ++i) {
    const Terminal& terminal = run.out.terminals[i];
    if (terminal.appearance != replaced.appearance) continue;
    const double m2 = area_m2_of(terminal);
    if (!is_larger(m2, largest_m2)) continue;
    largest_m2 = m2;
    replaced.texture = run.origins[i].texture;
  }
  return replaced;
}

double length_around_m(std::span<const Vec3> ring) {
  double sum_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum_m += length(ring[(i + 1) % ring.size()] - ring[i]);
  return sum_m;
}

double extent_m(std::span<const Vec3> ring, Vec3 axis) {
  double low_m = kUnbounded_m, high_m = -kUnbounded_m;
  for (const Vec3 p : ring) low_m = std::min(low_m, dot(axis, p)), high_m = std::max(high_m, dot(axis, p));
  const double size_m = high_m - low_m;
  return size_m < kOnPlane_m ? 0 : size_m;
}

double narrower_side_m(std::span<const Vec3> ring, const std::array<Vec3, 3>& axis) {
  return ring.empty() ? 0 : std::min(extent_m(ring, axis[0]), extent_m(ring, axis[1]));
}

// The shorter side of the bounding box. With holes the face is a frame around them: area over half its border length.
double width_m(const Face& face) {
  if (face.holes.empty()) return narrower_side_m(face.outer, axes_of(face));
  double border_m = length_around_m(face.outer);
  for (const Ring3& hole : face.holes) border_m += length_around_m(hole);
  return border_m > 0 ? 2 * area_m2(face) / border_m : narrower_side_m(face.outer, axes_of(face));
}

bool is_rectangle(std::span<const Vec3> ring) {
  if (ring.size() != 4) return false;
  const Vec3 a = ring[1] - ring[0], b = ring[2] - ring[1];
  return length(ring[3] - ring[2] + a) < kOnPlane_m && std::abs(dot(a, b)) < kOnPlane_m;
}

// A fast test for the usual case. The factor 2 is a margin: the bounding box need not be along the rectangle's sides.
bool is_surely_wider(const Face& face, double than_m) {
  if (!face.holes.empty() || !is_rectangle(face.outer)) return false;
  return std::min(length(face.outer[1] - face.outer[0]), length(face.outer[2] - face.outer[1])) > 2 * than_m;
}

double width_m(const Terminal& terminal) {
  double widest_m = terminal.asset.empty() ? 0 : terminal.scope.diagonal_m();
  for (const Face& face : terminal.faces) widest_m = std::max(widest_m, width_m(face));
  return widest_m;
}

bool may_be_simplified(const Run& run, const NodeTrace& trace, const Shape& start) {
  if (trace.vanished || trace.seen.are_many()) return false;
  if (!has_surface(start.faces) || !start.asset.empty()) return false;
  return trace.moved.largest_m() + start.deviation_m <= run.options.tolerance_m;
}

}  // namespace

VisibleAppearances visible_appearance(const Run& run, const Terminal& terminal) {
  if (!run.measures() || !run.options.keep_appearances) return {};
  const double narrow_m = run.options.tolerance_m + kSliver_m;
  const bool is_wide = !terminal.faces.empty() && is_surely_wider(terminal.faces.front(), narrow_m);
  if (!is_wide && width_m(terminal) <= narrow_m) return {};
  return {VisibleAppearances::Count::kOne, terminal.appearance};
}

void simplify_node(const Execution& execution, const Shape& start, std::size_t first, NodeTrace& trace) {
  assert(first <= execution.run.out.terminals.size());
  Run& run = execution.run;
  std::vector<Terminal>& terminals = run.out.terminals;
  if (!may_be_simplified(run, trace, start)) return;
  if (run.options.keep_start && execution.depth <= 1) return;
  if (vertex_count(start.faces) >= vertices_from(run, first)) return;
  Replaced replaced = replaced_from(run, first);
  if (trace.seen.include_other_than(replaced.appearance)) return;
  remove_terminals_from(run, first);
  terminals.push_back({.id = {},
                       .name = execution.name,
                       .path = execution.path,
                       .appearance = replaced.appearance,
                       .faces = start.faces,
                       .texture = run.tables.texture_at(replaced.texture),
                       .asset = {},
                       .scope = start.scope,
                       .simplified = true,
                       .error_m = trace.moved.largest_m() + start.deviation_m,
                       .detail_distance_m = trace.moved.to_earlier_m});
  run.origins.push_back({start.node, replaced.texture, run.tables.add(std::move(replaced.areas_m2))});
  trace.seen = visible_appearance(run, terminals.back());
}

}  // namespace citykiln::grammars

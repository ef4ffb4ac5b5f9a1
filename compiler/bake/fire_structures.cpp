#include "compiler/bake/fire_structures.h"

#include <utility>

#include "compiler/structures/bore.h"

namespace citykiln::bake {
namespace {

// Those that are part of the chunk's tile. A span of which nothing is left counts as dropped.
template <typename Expand>
void expand_spans(const Firing& firing, const std::vector<structures::Span>& spans, const char* kind, Report& report,
                  std::vector<Built>& all, Expand expand) {
  Account account;
  for (const structures::Span& span : spans) {
    const Bounds bounds = bounds_of(span);
    if (!scene::is_anchored(firing.header, firing.chunk.tile, span.axis.front()) || !firing.holds(bounds)) continue;
    ++account.in;
    structures::Expanded expanded = expand(span, firing.tolerance_m);
    if (expanded.meshes.empty() && expanded.marked.empty()) {
      report.drop(account, Code::kBelowTolerance, span.id.osm, 0);
      continue;
    }
    ++account.out;
    all.push_back({std::move(expanded), bounds});
  }
  report.account("bake", kind) = account;
}

}  // namespace

std::vector<Built> expand_structures(const Firing& firing, Report& report) {
  std::vector<Built> all;
  std::vector<structures::Span> bored = firing.chunk.tunnels;
  std::erase_if(bored, [](const structures::Span& tunnel) { return !tunnel.is_bored; });
  expand_spans(firing, firing.chunk.bridges, "bridge", report, all, structures::expand);
  expand_spans(firing, bored, "tunnel", report, all, structures::expand_bore);
  return all;
}

void fire_structures(Firing& firing, std::vector<Built>& structures, const Markings& markings,
                     std::size_t first_column) {
  for (auto& [built, bounds] : structures) {
    firing.certify(built.error_m, bounds);
    for (structures::MarkedMesh& marked : built.marked) {
      put_on_sheet(markings.columns[first_column++], marked.mesh);
      built.meshes.push_back(std::move(marked.mesh));
    }
    firing.take(std::move(built.meshes));
  }
}

void fire_stairs(Firing& firing, const std::vector<structures::Stairs>& all) {
  for (const structures::Stairs& stairs : all) {
    const Bounds bounds = bounds_of(stairs.mesh);
    if (!firing.holds(bounds)) continue;
    if (stairs.error_m <= firing.tolerance_m)
      firing.certify(stairs.error_m, bounds);
    else
      firing.take({{stairs.mesh, materials::Material::kStone, materials::kNoTint, stairs.feature}});
  }
}

}  // namespace citykiln::bake

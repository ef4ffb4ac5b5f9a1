#include "compiler/bake/parts/bake_structures.h"

#include <utility>

#include "compiler/bake/clip_to_extent.h"
#include "compiler/bake/clip_to_outline.h"
#include "compiler/structures/tunnel.h"

namespace citykiln::bake {
namespace {

bool has_no_triangles(const structures::GeneratedStructure& generated) {
  return generated.meshes.empty() && generated.marked.empty();
}

enum class Body { kSolid, kHollow };

// Removes what lies outside the extent or beyond the clip. At the extent bridges are closed; tunnels are open, so that
// their inside is seen.
void clip_structure(structures::GeneratedStructure& generated, OsmId feature, const scene::Header& header, Body body) {
  const Box2& extent = header.extent;
  std::vector<MaterialMesh*> meshes;
  for (MaterialMesh& mesh : generated.meshes) meshes.push_back(&mesh);
  for (structures::MarkedMesh& marked : generated.marked) meshes.push_back(&marked.mesh);
  Mesh caps;
  if (body == Body::kSolid)
    caps = clip_solid_to_extent(meshes, extent);
  else
    clip_to_extent(meshes, extent);
  clip_to_outline(meshes, header.clip);
  if (!caps.triangles.empty())
    generated.meshes.push_back({std::move(caps), materials::Material::kConcrete, materials::kNoTint, feature});
  std::erase_if(generated.meshes, [](const MaterialMesh& mesh) { return mesh.mesh.triangles.empty(); });
  std::erase_if(generated.marked, [](const auto& marked) { return marked.mesh.mesh.triangles.empty(); });
}

// Generates the spans that the chunk's tile bakes. A span without meshes counts as dropped.
template <typename Generate>
void generate_spans(const Baking& baking, const std::vector<structures::Span>& spans, const char* kind, Body body,
                    Report& report, std::vector<GeneratedSpan>& all, Generate generate) {
  Account account;
  for (const structures::Span& span : spans) {
    const Bounds bounds = bounds_of(span);
    if (!baking.holds(bounds) || scene::baking_tile(baking.header, span) != baking.chunk.tile) continue;
    ++account.in;
    structures::GeneratedStructure generated = generate(span, baking.tolerance_m);
    const bool is_too_small = has_no_triangles(generated);
    clip_structure(generated, span.id.osm, baking.header, body);
    if (has_no_triangles(generated)) {
      report.drop(account, is_too_small ? Code::kBelowTolerance : Code::kOutsideBounds, span.id.osm, 0);
      continue;
    }
    ++account.out;
    all.push_back({std::move(generated), bounds});
  }
  report.account("bake", kind) = account;
}

}  // namespace

std::vector<GeneratedSpan> generate_structures(const Baking& baking, Report& report) {
  std::vector<GeneratedSpan> all;
  std::vector<structures::Span> bored = baking.chunk.tunnels;
  std::erase_if(bored, [](const structures::Span& tunnel) { return !tunnel.is_bored; });
  generate_spans(baking, baking.chunk.bridges, "bridge", Body::kSolid, report, all, structures::generate);
  generate_spans(baking, bored, "tunnel", Body::kHollow, report, all, structures::generate_tunnel);
  return all;
}

std::vector<roads::MarkingLayout> layouts_of(const std::vector<GeneratedSpan>& structures) {
  std::vector<roads::MarkingLayout> layouts;
  for (const GeneratedSpan& built : structures)
    for (const structures::MarkedMesh& marked : built.generated.marked) layouts.push_back(marked.layout);
  return layouts;
}

void bake_structures(Baking& baking, std::vector<GeneratedSpan>& structures, const Markings& markings) {
  for (auto& [built, bounds] : structures) {
    baking.certify(built.error_m, bounds);
    for (structures::MarkedMesh& marked : built.marked) {
      map_to_atlas(column_of(markings, marked.layout), marked.mesh);
      built.meshes.push_back(std::move(marked.mesh));
    }
    baking.take(std::move(built.meshes), Layer::kStructures);
  }
}

void bake_stairs(Baking& baking, const std::vector<structures::Stairs>& all) {
  for (const structures::Stairs& stairs : all) {
    const Bounds bounds = bounds_of(stairs);
    if (!baking.holds(bounds)) continue;
    if (stairs.error_m <= baking.tolerance_m) {
      baking.certify(stairs.error_m, bounds);
      continue;
    }
    using materials::Material;
    baking.take({{{stairs.mesh, Material::kStone, materials::kNoTint, stairs.feature}, Layer::kStructures}});
    if (stairs.rails.triangles.empty()) continue;
    if (structures::kHandrailError_m <= baking.tolerance_m)
      baking.certify(structures::kHandrailError_m, bounds);
    else
      baking.take({{{stairs.rails, Material::kMetalCladding, materials::kNoTint, stairs.feature}, Layer::kStructures}});
  }
}

}  // namespace citykiln::bake

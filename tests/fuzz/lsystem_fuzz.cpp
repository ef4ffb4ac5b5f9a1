// Reads any text, in either notation, as an L-system or one error line. Any L-system derives, twice alike, to a string
// with balanced brackets and a finite skeleton within the limits, and to a finite, closed mesh.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "lsystems/mesh/tubes.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/read_rpforest.h"
#include "lsystems/rewriting/turtle.h"
#include "tests/fuzz/sound_skeleton.h"

namespace {

using namespace citykiln;
using namespace citykiln::lsystems;

void check_string(const LSystem& system, const ModuleString& string) {
  int depth = 0;
  std::size_t values = 0;
  for (const Kind kind : string.kinds) {
    depth += kind == system.push ? 1 : (kind == system.pop ? -1 : 0);
    values += system.kinds.at(kind).arity;
    if (depth < 0) std::abort();
  }
  if (depth != 0 || values != string.values.size()) std::abort();
  for (const double value : string.values)
    if (!std::isfinite(value)) std::abort();
}

void check_part(const PartMesh& mesh) {
  if (mesh.normals.size() != mesh.positions.size() || mesh.uvs.size() != mesh.positions.size()) std::abort();
  for (const Vec3 position : mesh.positions)
    if (!is_finite(position)) std::abort();
  for (const Vec3 normal : mesh.normals)
    if (!(std::abs(length(normal) - 1) < 1e-9)) std::abort();
  for (const Vec2 uv : mesh.uvs)
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) std::abort();
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : t)
      if (corner >= mesh.positions.size()) std::abort();
}

// Aborts unless each edge is used equally often in both directions; equal positions are one vertex.
void check_closed(const PartMesh& mesh) {
  std::map<Vec3, int> places;
  std::map<std::pair<int, int>, int> passes;
  const auto place = [&](std::uint32_t corner) {
    return places.try_emplace(mesh.positions[corner], static_cast<int>(places.size())).first->second;
  };
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const int a = place(t[i]), b = place(t[(i + 1) % 3]);
      if (a != b) passes[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  for (const auto& [edge, sum] : passes)
    if (sum != 0) std::abort();
}

void check_mesh(const Skeleton& skeleton) {
  TubeOptions options;
  // coarse enough for at most about 10,000 triangles
  options.tolerance_m = 0.05;
  const PlantMesh mesh = mesh_plant(skeleton, options);
  check_part(mesh.bark);
  check_part(mesh.leaf);
  if (!std::isfinite(mesh.error_m)) std::abort();
  if (mesh.bark.triangles.size() < 20'000) check_closed(mesh.bark);
}

void check(const Result<LSystem>& system) {
  if (!system) {
    if (to_string(system.error()).find('\n') != std::string::npos) std::abort();
    return;
  }
  DeriveOptions options;
  options.limits = {2'000, 30'000, 12, 1'000'000};
  options.environment.shade = [](Vec3 p) { return 1 / p.z; };
  const Plant plant = grow(*system, options);
  if (plant.derivation.string.kinds.size() > 2'000 || plant.derivation.written > 34'000) std::abort();
  check_string(*system, plant.derivation.string);
  check_skeleton(plant.skeleton);
  if (plant.skeleton.segments.size() < 200) check_mesh(plant.skeleton);
  const Derivation again = derive(*system, options);
  if (again.string.kinds != plant.derivation.string.kinds || again.string.values != plant.derivation.string.values)
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  // the first byte chooses the notation
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 8) {
    case 0:
      check(read_rpforest(text, "fuzz.lsys"));
      break;
    case 1:
      check(read_rpforest(text, "fuzz.honda"));
      break;
    case 2:
      check(read_rpforest(text, "fuzz.family"));
      break;
    default:
      check(read_lsystem(text, "fuzz.lsys", {{"r1", 0.5}}));
  }
  return 0;
}

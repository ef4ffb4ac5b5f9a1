#include "tests/charts/simplified_meshes.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>

#include "compiler/bake/tiles/weld.h"
#include "exporters/gltf/flat_shading.h"

namespace citykiln::charts {
namespace {

using bake::Primitive;
using Face = std::array<std::uint32_t, 3>;

std::size_t triangle_count_of(const std::vector<Primitive>& primitives) {
  std::size_t sum = 0;
  for (const Primitive& p : primitives) sum += p.triangles.size();
  return sum;
}

bool is_any(const Primitive&) { return true; }

// Triangles of a welded mesh, by indices of its positions.
std::vector<Face> by_meshoptimizer(const simplify::LabelledMesh& mesh, std::size_t triangles) {
  std::vector<bake::Float3> positions;
  for (const Vec3 p : mesh.positions)
    positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  std::vector<std::uint32_t> indices, left(mesh.triangles.size() * 3);
  for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
  left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), positions.front().data(), positions.size(),
                               sizeof(bake::Float3), triangles * 3, std::numeric_limits<float>::max(), 0, nullptr));
  std::vector<Face> faces;
  for (std::size_t i = 0; i + 2 < left.size(); i += 3) faces.push_back({left[i], left[i + 1], left[i + 2]});
  return faces;
}

std::vector<Face> by_openmesh(const simplify::LabelledMesh& mesh, std::size_t triangles) {
  return simplify::decimated_to(mesh, triangles).triangles;
}

// Each primitive apart, with its share of the triangles.
template <typename OfOne>
std::vector<Primitive> simplified_one_by_one(const std::vector<Primitive>& primitives, std::size_t triangles,
                                             OfOne of_one) {
  const double share = static_cast<double>(triangles) / static_cast<double>(triangle_count_of(primitives));
  std::vector<Primitive> all;
  for (const Primitive& p : primitives) {
    const bake::WeldedPrimitives source = bake::welded(std::span(&p, 1), is_any);
    if (source.mesh.triangles.empty()) continue;
    simplify::DecimatedMesh made;
    made.triangles = of_one(source.mesh, static_cast<std::size_t>(share * static_cast<double>(p.triangles.size())));
    made.labels.assign(made.triangles.size(), 0);
    all.push_back(bake::decimated_primitive(p, source, 0, made));
  }
  std::erase_if(all, [](const Primitive& p) { return p.triangles.empty(); });
  return all;
}

}  // namespace

std::vector<Primitive> simplified_by_openmesh(const std::vector<Primitive>& primitives, std::size_t triangles) {
  return simplified_one_by_one(primitives, triangles, by_openmesh);
}

std::vector<Primitive> simplified_by_meshoptimizer(const std::vector<Primitive>& primitives, std::size_t triangles) {
  return simplified_one_by_one(primitives, triangles, by_meshoptimizer);
}

std::vector<Primitive> with_flat_normals(std::vector<Primitive>&& primitives) {
  for (Primitive& p : primitives) {
    p.normals.clear();
    p = exporters::with_face_normals(p);
  }
  return std::move(primitives);
}

}  // namespace citykiln::charts

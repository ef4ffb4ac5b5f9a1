#include "compiler/charts/simplified_meshes.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>

#include "compiler/bake/weld.h"

namespace citykiln::charts {
namespace {

using bake::Primitive;
using Face = std::array<std::uint32_t, 3>;

std::size_t triangles_of(const std::vector<Primitive>& primitives) {
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
std::vector<Primitive> simplified(const std::vector<Primitive>& primitives, std::size_t triangles, OfOne of_one) {
  const double share = static_cast<double>(triangles) / static_cast<double>(triangles_of(primitives));
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
  return simplified(primitives, triangles, by_openmesh);
}

std::vector<Primitive> simplified_by_meshoptimizer(const std::vector<Primitive>& primitives, std::size_t triangles) {
  return simplified(primitives, triangles, by_meshoptimizer);
}

std::vector<Primitive> with_flat_normals(const std::vector<Primitive>& primitives) {
  std::vector<Primitive> all;
  for (const Primitive& from : primitives) {
    Primitive to{.material = from.material,
                 .positions = {},
                 .normals = {},
                 .colours = {},
                 .features = {},
                 .triangles = {},
                 .colour_source = from.colour_source,
                 .layer = from.layer};
    for (const Face& t : from.triangles) {
      const auto at = [&](std::size_t i) { return bake::widened(from.positions[t[i]]); };
      const Vec3 n = unit(cross(at(1) - at(0), at(2) - at(0)));
      const auto first = static_cast<std::uint32_t>(to.positions.size());
      for (const std::uint32_t v : t) {
        to.positions.push_back(from.positions[v]), to.colours.push_back(from.colours[v]);
        to.normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
        if (!from.features.empty()) to.features.push_back(from.features[v]);
        if (!from.uvs.empty()) to.uvs.push_back(from.uvs[v]);
      }
      to.triangles.push_back({first, first + 1, first + 2});
    }
    all.push_back(std::move(to));
  }
  return all;
}

}  // namespace citykiln::charts

// Catmull, Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes", 1978; limits after
// Halstead, Kass, DeRose, "Efficient, fair interpolation using Catmull-Clark surfaces", 1993, as OpenSubdiv has them.
#include "lsystems/mesh/joint_stencils.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

namespace citykiln::lsystems {
namespace {

namespace Far = OpenSubdiv::Far;

// A point as a weighted sum of cage points, in the form that OpenSubdiv refines.
struct Row {
  std::array<double, kMostPoints> weights{};
  void Clear(void* = nullptr) { weights.fill(0); }
  void AddWithWeight(const Row& row, double weight) {
    for (int i = 0; i < kMostPoints; ++i) weights[i] += row.weights[i] * weight;
  }
};

struct Face {
  std::array<int, 4> corners{};
  std::array<Vec2, 4> uvs{};
  int stem = 0;  // the stem of the uvs
};

// The cage at level 0: box corners, then four points a ring.
struct Cage {
  std::vector<Face> faces;
  int points = 8;
};

// Adds four quads between a face of the box and a ring.
void add_stem(Cage& cage, const std::array<int, 4>& from, const std::array<int, 4>& to,
              const std::array<Vec2, 5>& from_uv, const std::array<Vec2, 5>& to_uv, int stem = 0) {
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    cage.faces.push_back(
        {{from[k], from[next], to[next], to[k]}, {from_uv[k], from_uv[k + 1], to_uv[k + 1], to_uv[k]}, stem});
  }
}

std::array<Vec2, 5> level_uvs(double v) { return {{{0, v}, {0.25, v}, {0.5, v}, {0.75, v}, {1, v}}}; }

std::array<int, 4> next_ring(Cage& cage) {
  cage.points += 4;
  return {cage.points - 4, cage.points - 3, cage.points - 2, cage.points - 1};
}

void add_side(Cage& cage, int side, bool open) {
  const int next = (side + 1) % 4;
  const std::array<int, 4> corners{side, next, 4 + next, 4 + side};
  const double left = side / 4.0, right = left + 0.25;
  if (!open)
    return cage.faces.push_back({corners, {{{left, kBoxLow}, {right, kBoxLow}, {right, kBoxHigh}, {left, kBoxHigh}}}});
  const std::array<int, 4> ring = next_ring(cage);
  add_stem(cage, corners, ring, level_uvs(0), level_uvs(1), (ring[0] - 8) / 4);
}

Cage make_cage(unsigned open) {
  Cage cage;
  const std::array<int, 4> low{0, 1, 2, 3}, high{4, 5, 6, 7};
  const std::array<int, 4> lower_ring = next_ring(cage), upper_ring = next_ring(cage);
  add_stem(cage, lower_ring, low, level_uvs(0), level_uvs(kBoxLow));
  add_stem(cage, high, upper_ring, level_uvs(kBoxHigh), level_uvs(1));
  for (int side = 0; side < 4; ++side) add_side(cage, side, (open >> side & 1) != 0);
  return cage;
}

std::unique_ptr<Far::TopologyRefiner> refined(const Cage& cage, int level) {
  std::vector<int> counts(cage.faces.size(), 4), corners;
  for (const Face& face : cage.faces) corners.insert(corners.end(), face.corners.begin(), face.corners.end());
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = cage.points;
  descriptor.numFaces = static_cast<int>(cage.faces.size());
  descriptor.numVertsPerFace = counts.data();
  descriptor.vertIndicesPerFace = corners.data();
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  OpenSubdiv::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
  Far::TopologyRefiner::UniformOptions uniform(level);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  return refiner;
}

// A vertex's ring (-1: none) and position on it.
struct OnRing {
  int stem = -1;
  std::uint32_t index = 0;
};

std::vector<OnRing> rings_of(const Far::TopologyRefiner& refiner, int level) {
  std::vector<OnRing> rings(refiner.GetLevel(0).GetNumVertices());
  for (std::size_t i = 8; i < rings.size(); ++i)
    rings[i] = {static_cast<int>(i - 8) / 4, static_cast<std::uint32_t>(i % 4)};
  for (int l = 0; l < level; ++l) {
    const Far::TopologyLevel& here = refiner.GetLevel(l);
    std::vector<OnRing> finer(refiner.GetLevel(l + 1).GetNumVertices());
    for (int v = 0; v < here.GetNumVertices(); ++v)
      if (rings[v].stem >= 0) finer[here.GetVertexChildVertex(v)] = {rings[v].stem, rings[v].index * 2};
    for (int e = 0; e < here.GetNumEdges(); ++e) {
      if (!here.IsEdgeBoundary(e)) continue;
      const Far::ConstIndexArray ends = here.GetEdgeVertices(e);
      const auto [low, high] = std::minmax(rings[ends[0]].index, rings[ends[1]].index);
      // the closing edge joins the ring's last and first point
      finer[here.GetEdgeChildVertex(e)] = {rings[ends[0]].stem, high - low == 1 ? 2 * low + 1 : 2 * high + 1};
    }
    rings = std::move(finer);
  }
  return rings;
}

std::vector<Row> cage_rows(const Cage& cage) {
  std::vector<Row> rows(cage.points);
  for (int i = 0; i < 8; ++i) rows[i].weights[i] = 1;
  // a ring's four points follow its eight
  for (int i = 8; i < cage.points; ++i) rows[i].weights[8 + (i - 8) / 4 * kRingPoints + 8 + i % 4] = 1;
  return rows;
}

struct LimitRows {
  std::vector<Row> positions, tangents_1, tangents_2;
};

LimitRows limit_rows_of(const Far::TopologyRefiner& refiner, std::vector<Row> rows) {
  const Far::PrimvarRefinerReal<double> primvars(refiner);
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    std::vector<Row> finer(refiner.GetLevel(level).GetNumVertices());
    primvars.Interpolate(level, rows, finer);
    const std::vector<OnRing> rings = rings_of(refiner, level);
    for (std::size_t i = 0; level == 1 && i < finer.size(); ++i)
      if (rings[i].stem >= 0) {
        finer[i].Clear();
        finer[i].weights[8 + rings[i].stem * kRingPoints + rings[i].index] = 1;
      }
    rows = std::move(finer);
  }
  LimitRows limits;
  for (auto* to : {&limits.positions, &limits.tangents_1, &limits.tangents_2}) to->resize(rows.size());
  primvars.Limit(rows, limits.positions, limits.tangents_1, limits.tangents_2);
  return limits;
}

// Refines faces with their uvs. Corner i of child i is corner i of its parent.
std::vector<Face> faces_at(const Far::TopologyRefiner& refiner, const Cage& cage, int level) {
  std::vector<Face> faces = cage.faces;
  for (int l = 0; l < level; ++l) {
    std::vector<Face> finer(refiner.GetLevel(l + 1).GetNumFaces());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Far::ConstIndexArray children = refiner.GetLevel(l).GetFaceChildFaces(static_cast<int>(f));
      const std::array<Vec2, 4>& uvs = faces[f].uvs;
      for (int i = 0; i < 4; ++i) {
        Face& child = finer[children[i]];
        child.stem = faces[f].stem;
        const Far::ConstIndexArray corners = refiner.GetLevel(l + 1).GetFaceVertices(children[i]);
        for (int c = 0; c < 4; ++c) child.corners[c] = corners[c];
        child.uvs[i] = uvs[i];
        child.uvs[(i + 1) % 4] = (uvs[i] + uvs[(i + 1) % 4]) * 0.5;
        child.uvs[(i + 2) % 4] = ((uvs[0] + uvs[2]) + (uvs[1] + uvs[3])) * 0.25;
        child.uvs[(i + 3) % 4] = (uvs[i] + uvs[(i + 3) % 4]) * 0.5;
      }
    }
    faces = std::move(finer);
  }
  return faces;
}

double rounded(double weight) { return std::floor(weight * 0x1p24 + 0.5) * 0x1p-24; }

void add_row(JointStencils& shape, const Row& position, const Row& tangent_1, const Row& tangent_2) {
  for (int i = 0; i < kMostPoints; ++i) {
    const JointStencils::Weight weight{static_cast<std::uint32_t>(i), position.weights[i],
                                       rounded(tangent_1.weights[i]), rounded(tangent_2.weights[i])};
    if (weight.position != 0 || weight.tangent_1 != 0 || weight.tangent_2 != 0) shape.weights.push_back(weight);
  }
  shape.starts.push_back(static_cast<std::uint32_t>(shape.weights.size()));
}

}  // namespace

JointStencils make_joint_stencils(int sides, unsigned open) {
  assert(4 <= sides && sides <= 64 && std::has_single_bit(static_cast<unsigned>(sides)) && open < 16);
  const int level = std::bit_width(static_cast<unsigned>(sides)) - 3;
  const Cage cage = make_cage(open);
  const std::unique_ptr<Far::TopologyRefiner> refiner = refined(cage, std::max(level, 1));
  const LimitRows limits = limit_rows_of(*refiner, cage_rows(cage));
  const std::vector<OnRing> rings = rings_of(*refiner, level);
  JointStencils shape;
  shape.stems = 2 + std::popcount(open);
  shape.starts.push_back(0);
  std::vector<int> row_of(rings.size(), -1);
  // corners of one position and uv share a vertex
  std::map<std::tuple<int, int, double, double>, std::uint32_t> vertices;
  const auto vertex_of = [&](int corner, Vec2 uv, int stem) {
    const auto [found, is_new] = vertices.try_emplace({corner, stem, rounded(uv.x), rounded(uv.y)},
                                                      static_cast<std::uint32_t>(shape.vertices.size()));
    if (!is_new) return found->second;
    if (rings[corner].stem < 0 && row_of[corner] < 0) {
      row_of[corner] = static_cast<int>(shape.starts.size()) - 1;
      const int at = level > 0 ? corner : refiner->GetLevel(0).GetVertexChildVertex(corner);
      add_row(shape, limits.positions[at], limits.tangents_1[at], limits.tangents_2[at]);
    }
    const bool on_ring = rings[corner].stem >= 0;
    shape.vertices.push_back(
        {rings[corner].stem, on_ring ? rings[corner].index : static_cast<std::uint32_t>(row_of[corner]), uv, stem});
    return found->second;
  };
  for (const Face& face : faces_at(*refiner, cage, level)) {
    std::array<std::uint32_t, 4> v;
    for (int i = 0; i < 4; ++i) v[i] = vertex_of(face.corners[i], face.uvs[i], face.stem);
    shape.triangles.push_back({v[0], v[1], v[2]});
    shape.triangles.push_back({v[0], v[2], v[3]});
  }
  return shape;
}

}  // namespace citykiln::lsystems

#include "compiler/simplify/decimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <optional>

#include "compiler/simplify/distance_bound.h"

namespace citykiln::simplify {
namespace {

// Largest turn of a triangle at once: its cosine.
constexpr double kLeastCosine = 0.5;
// No collapse makes a triangle whose height over its longest edge is less than this, unless it was less before. Thin
// triangles turn steep, and look black under normals that are not.
constexpr double kLeastHeight = 0.05;
// No triangle may be thinner: it would have no normal in single precision.
constexpr double kSlimmest = 0.001;
// Samples may stray by this share of the tolerance.
constexpr double kSampleShare = 0.7;
constexpr int kMostRounds = 12;
// The precision of measured errors, and the distance up to which they are not told apart: shares of the tolerance.
constexpr double kPrecision = 0x1p-4, kLeast = 0.5;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  VertexTraits {
    std::uint32_t source = 0;  // its number in the source
    double border_m = 0;       // bounds how far the borders at this vertex are from the source's
  };
  FaceTraits { std::uint32_t label = 0; };
};
using HalfedgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using VertexHandle = HalfedgeMesh::VertexHandle;
using EdgeHandle = HalfedgeMesh::EdgeHandle;

Vec3 vec(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }

double to_segment_m(Vec3 p, Vec3 a, Vec3 b) { return distance_m(p, {a, b, b}); }

bool is_border(const HalfedgeMesh& mesh, EdgeHandle edge) {
  if (mesh.is_boundary(edge)) return true;
  const auto label = [&](unsigned side) { return mesh.data(mesh.face_handle(mesh.halfedge_handle(edge, side))).label; };
  return label(0) != label(1);
}

using Points = std::array<Vec3, 3>;

// The height of a triangle over its longest edge.
double slimness(const Points& t, Vec3 normal) {
  double longest_m2 = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i];
    longest_m2 = std::max(longest_m2, dot(edge, edge));
  }
  return longest_m2 > 0 ? length(normal) / longest_m2 : 0;
}

// True if a triangle may become another: it stays wide enough and turns little.
bool may_become(const Points& before, const Points& after) {
  const auto normal = [](const Points& t) { return cross(t[1] - t[0], t[2] - t[0]); };
  const Vec3 old = normal(before), now = normal(after);
  const double slim = slimness(after, now);
  if (slim < kSlimmest || slim < std::min(kLeastHeight, slimness(before, old))) return false;
  if (old.z > 0 && now.z <= 0) return false;
  return dot(old, now) >= kLeastCosine * length(old) * length(now);
}

/// Keeps borders of labels: a module of the decimater that allows or denies collapses.
template <class MeshT>
class ModBorders : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModBorders, MeshT, Borders);
  explicit ModBorders(MeshT& mesh) : Base(mesh, true) {}

  void set_tolerance(double tolerance_m) { tolerance_m_ = tolerance_m; }

  float collapse_priority(const CollapseInfo& ci) override {
    const bool is_allowed = moved_border_m(ci).has_value() && turns_little(ci);
    return static_cast<float>(is_allowed ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE);
  }

  // Both ends of the new border edge carry the sum of the bounds.
  void preprocess_collapse(const CollapseInfo& ci) override {
    const Borders at = borders_at(ci.v0);
    const std::optional<double> moved_m = moved_border_m(ci);
    if (at.count != 2 || !moved_m) return;
    for (const VertexHandle v : at.beyond) {
      double& bound_m = Base::mesh().data(v).border_m;
      bound_m = std::max(bound_m, *moved_m);
    }
  }

 private:
  struct Borders {
    int count = 0;
    std::array<VertexHandle, 2> beyond = {VertexHandle(), VertexHandle()};  // the other ends of the first two
  };

  // not const: OpenMesh's modules reach their mesh so
  Borders borders_at(VertexHandle v) {
    Borders at;
    for (auto h = Base::mesh().cvoh_iter(v); h.is_valid(); ++h) {
      if (!is_border(Base::mesh(), Base::mesh().edge_handle(*h))) continue;
      if (at.count < 2) at.beyond[static_cast<std::size_t>(at.count)] = Base::mesh().to_vertex_handle(*h);
      ++at.count;
    }
    return at;
  }

  Vec3 place(VertexHandle v) { return vec(Base::mesh().point(v)); }

  // A bound of how far the border strays after the collapse: 0 inside a label; none where it is not allowed.
  std::optional<double> moved_border_m(const CollapseInfo& ci) {
    const Borders at = borders_at(ci.v0);
    if (at.count == 0) return 0;
    if (at.count != 2 || (at.beyond[0] != ci.v1 && at.beyond[1] != ci.v1)) return std::nullopt;
    const VertexHandle other = at.beyond[0] == ci.v1 ? at.beyond[1] : at.beyond[0];
    const auto closing = Base::mesh().find_halfedge(ci.v1, other);
    // the last three vertices about a label
    if (closing.is_valid() && is_border(Base::mesh(), Base::mesh().edge_handle(closing))) return std::nullopt;
    const double moved_m = Base::mesh().data(ci.v0).border_m + to_segment_m(place(ci.v0), place(ci.v1), place(other));
    return moved_m <= tolerance_m_ ? std::optional(moved_m) : std::nullopt;
  }

  bool turns_little(const CollapseInfo& ci) {
    for (auto f = Base::mesh().cvf_iter(ci.v0); f.is_valid(); ++f) {
      if (*f == ci.fl || *f == ci.fr) continue;
      Points before, after;
      std::size_t i = 0;
      for (auto v = Base::mesh().cfv_iter(*f); v.is_valid(); ++v, ++i)
        before[i] = place(*v), after[i] = *v == ci.v0 ? place(ci.v1) : before[i];
      if (!may_become(before, after)) return false;
    }
    return true;
  }

  double tolerance_m_ = std::numeric_limits<double>::infinity();
};

// Adds a triangle; where the mesh would not be a manifold, with vertices of its own, which are locked.
void add_triangle(HalfedgeMesh& mesh, std::array<VertexHandle, 3> corners, std::uint32_t label) {
  HalfedgeMesh::FaceHandle face = mesh.add_face(corners[0], corners[1], corners[2]);
  if (!face.is_valid()) {
    for (VertexHandle& v : corners) {
      mesh.status(v).set_locked(true);
      const VertexHandle copy = mesh.add_vertex(mesh.point(v));
      mesh.data(copy).source = mesh.data(v).source;
      mesh.status(copy).set_locked(true);
      v = copy;
    }
    face = mesh.add_face(corners[0], corners[1], corners[2]);
  }
  mesh.data(face).label = label;
}

void fill(HalfedgeMesh& mesh, const LabelledMesh& source) {
  // add_face() prints a line for each triangle that it refuses
  static const bool is_quiet = (omerr().disable(), true);
  static_cast<void>(is_quiet);
  mesh.request_vertex_status(), mesh.request_edge_status(), mesh.request_face_status();
  for (std::size_t i = 0; i < source.positions.size(); ++i) {
    const Vec3 p = source.positions[i];
    const VertexHandle v = mesh.add_vertex({p.x, p.y, p.z});
    mesh.data(v).source = static_cast<std::uint32_t>(i);
    if (!source.is_locked.empty()) mesh.status(v).set_locked(source.is_locked[i]);
  }
  for (std::size_t t = 0; t < source.triangles.size(); ++t) {
    std::array<VertexHandle, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.vertex_handle(source.triangles[t][i]);
    add_triangle(mesh, corners, source.labels[t]);
  }
}

DecimatedMesh read_back(const HalfedgeMesh& mesh) {
  DecimatedMesh result;
  for (const auto face : mesh.faces()) {
    if (mesh.status(face).deleted()) continue;
    Triangle t{};
    std::size_t i = 0;
    for (auto v = mesh.cfv_iter(face); v.is_valid(); ++v) t[i++] = mesh.data(*v).source;
    result.triangles.push_back(t);
    result.labels.push_back(mesh.data(face).label);
  }
  return result;
}

using Decimater = OpenMesh::Decimater::DecimaterT<HalfedgeMesh>;

// Adds the modules that every decimation has.
void add_modules(Decimater& decimater, double tolerance_m) {
  ModBorders<HalfedgeMesh>::Handle borders;
  OpenMesh::Decimater::ModQuadricT<HalfedgeMesh>::Handle quadrics;
  decimater.add(borders), decimater.add(quadrics);
  decimater.module(borders).set_tolerance(tolerance_m);
  decimater.module(quadrics).unset_max_err();
}

// Ends at a number of triangles, where it gets so low.
DecimatedMesh decimated_by_samples(const LabelledMesh& source, double tolerance_m, std::size_t triangles) {
  HalfedgeMesh mesh;
  fill(mesh, source);
  Decimater decimater(mesh);
  add_modules(decimater, tolerance_m);
  OpenMesh::Decimater::ModHausdorffT<HalfedgeMesh>::Handle samples;
  decimater.add(samples);
  decimater.module(samples).set_tolerance(tolerance_m);
  decimater.initialize();
  decimater.decimate_to_faces(0, triangles);
  return read_back(mesh);
}

// Triangles of one label, with their numbers.
struct Labelled {
  std::vector<Corners> corners;
  std::vector<std::size_t> numbers;
};
using ByLabel = std::map<std::uint32_t, Labelled>;

ByLabel by_label(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                 std::span<const std::uint32_t> labels) {
  ByLabel all;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    all[labels[t]].corners.push_back({positions[a], positions[b], positions[c]});
    all[labels[t]].numbers.push_back(t);
  }
  return all;
}

// The distance of a result, both ways, and the places of either that are farther away than the tolerance.
struct Measured {
  double error_m = 0;
  std::vector<std::size_t> far;   // triangles of the source
  std::vector<Vec3> far_of_made;  // places of the result
};

// Adds the distance of one label.
void measure_label(const Labelled& before, const Labelled& after, double tolerance_m, const BoundOptions& options,
                   Measured& measured) {
  const TriangleTree source(before.corners), made(after.corners);
  for (std::size_t i = 0; i < before.corners.size(); ++i) {
    const double away_m = distance_bound_m(std::span(&before.corners[i], 1), made, options);
    measured.error_m = std::max(measured.error_m, away_m);
    if (away_m > tolerance_m) measured.far.push_back(before.numbers[i]);
  }
  for (const Corners& t : after.corners) {
    const DistanceBound away = distance_bound(std::span(&t, 1), source, options);
    measured.error_m = std::max(measured.error_m, away.distance_m);
    if (away.distance_m > tolerance_m) measured.far_of_made.push_back(away.at);
  }
}

Measured measured(const LabelledMesh& source, const DecimatedMesh& made, double tolerance_m,
                  const BoundOptions& options) {
  ByLabel after = by_label(source.positions, made.triangles, made.labels);
  Measured all;
  for (const auto& [label, before] : by_label(source.positions, source.triangles, source.labels))
    measure_label(before, after[label], tolerance_m, options, all);
  return all;
}

// Locks the vertices of far triangles, and of those nearest to far places of the result.
void lock_far(LabelledMesh& mesh, const Measured& measured) {
  const auto lock = [&](const Triangle& t) {
    for (const std::uint32_t v : t) mesh.is_locked[v] = true;
  };
  for (const std::size_t t : measured.far) lock(mesh.triangles[t]);
  for (const Vec3 p : measured.far_of_made) {
    const auto away_m = [&](const Triangle& t) {
      return distance_m(p, {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    };
    lock(std::ranges::min(mesh.triangles, {}, away_m));
  }
}

}  // namespace

DecimatedMesh decimated(const LabelledMesh& source, double tolerance_m) {
  assert(tolerance_m > 0 && source.labels.size() == source.triangles.size());
  LabelledMesh mesh = source;
  mesh.is_locked.resize(mesh.positions.size(), false);
  const BoundOptions options{
      .precision_m = kPrecision * tolerance_m, .least_m = kLeast * tolerance_m, .most_m = tolerance_m};
  for (int round = 0; round < kMostRounds; ++round) {
    DecimatedMesh made = decimated_by_samples(mesh, kSampleShare * tolerance_m, 0);
    const Measured found = measured(mesh, made, tolerance_m, options);
    made.error_m = found.error_m;
    if (found.error_m <= tolerance_m) return made;
    lock_far(mesh, found);
  }
  return {source.triangles, source.labels, 0};
}

DecimatedMesh decimated_to(const LabelledMesh& source, std::size_t triangles) {
  constexpr double kFirst_m = 0.02, kStep = 4;
  constexpr int kSteps = 6;
  double tolerance_m = kFirst_m;
  for (int i = 1; i < kSteps; ++i) tolerance_m *= kStep;
  DecimatedMesh best = decimated_by_samples(source, tolerance_m, triangles);
  if (best.triangles.size() > triangles) return best;
  // the smallest tolerance that gets so low
  while (tolerance_m > kFirst_m) {
    tolerance_m /= kStep;
    DecimatedMesh nearer = decimated_by_samples(source, tolerance_m, triangles);
    if (nearer.triangles.size() > triangles) break;
    best = std::move(nearer);
  }
  return best;
}

}  // namespace citykiln::simplify

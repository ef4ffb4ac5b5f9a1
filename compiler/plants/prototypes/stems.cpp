#include "compiler/plants/prototypes/stems.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/geometry/trig.h"
#include "lsystems/mesh/tubes.h"

namespace citykiln::plants {
namespace {

using lsystems::Segment;
using lsystems::Skeleton;

// Radii above this share of the thickest diameter are never left out.
constexpr double kTrunkStays = 0.3;
// Radius in tolerances up to which a stem is a prism.
constexpr double kThin = 2.5;
// Circumradius of a prism whose mean width over all directions is the stem's diameter, in radii of the stem (Cauchy:
// the mean width is girth / π); and the depth of its sides inside the stem.
constexpr double kPrismRadius = 1.2092, kPrismOff = 1 - kPrismRadius / 2;

double segment_radius(const Segment& segment) { return std::max(segment.start_radius, segment.end_radius); }

double thickest_m(const Skeleton& skeleton) {
  double thickest = 0;
  for (const Segment& segment : skeleton.segments) thickest = std::max(thickest, 2 * segment_radius(segment));
  return thickest;
}

// Marks the segments thicker than a radius, and their ancestors.
std::vector<bool> thicker_than(const Skeleton& skeleton, double radius_m) {
  const std::vector<Segment>& all = skeleton.segments;
  std::vector<bool> stays(all.size());
  for (std::size_t i = all.size(); i-- > 0;) {
    if (segment_radius(all[i]) > radius_m) stays[i] = true;
    if (stays[i] && all[i].parent != lsystems::kNoParent) stays[static_cast<std::size_t>(all[i].parent)] = true;
  }
  return stays;
}

// The marked segments; ancestors of a marked segment are marked.
Skeleton only(const Skeleton& skeleton, const std::vector<bool>& stays) {
  Skeleton stems;
  std::vector<std::int32_t> number(stays.size(), lsystems::kNoParent);
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (!stays[i]) continue;
    number[i] = static_cast<std::int32_t>(stems.segments.size());
    Segment& segment = stems.segments.emplace_back(skeleton.segments[i]);
    if (segment.parent != lsystems::kNoParent) segment.parent = number[static_cast<std::size_t>(segment.parent)];
  }
  return stems;
}

using Turns = std::array<Vec2, 3>;

void add_prism(Mesh& mesh, const Segment& segment, const Turns& turns) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const Vec3 end = segment.end().at;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Vec3 out = segment.start.left * turns[i].x + segment.start.up * turns[i].y;
    mesh.positions.push_back(segment.start.at + out * (segment.start_radius * kPrismRadius));
    mesh.positions.push_back(end + out * (segment.end_radius * kPrismRadius));
    mesh.normals.insert(mesh.normals.end(), 2, out);
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % 3);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
}

// A straight stem between two ends of an axis.
Segment straight(const Segment& first, const Segment& last) {
  Segment stem = first;
  const Vec3 from_to = last.end().at - first.start.at;
  stem.length = length(from_to), stem.end_radius = last.end_radius;
  if (!(stem.length > 0)) return first;
  stem.start.heading = from_to * (1 / stem.length);
  const Vec3 left = first.start.left - stem.start.heading * dot(first.start.left, stem.start.heading);
  if (!(length(left) > 0)) return first;
  stem.start.left = unit(left), stem.start.up = cross(stem.start.heading, stem.start.left);
  return stem;
}

// The distance of a stem's end from another stem's axis, and how far their radii differ there.
double off_m(const Segment& stem, const Segment& inner) {
  const double along = std::clamp(dot(inner.end().at - stem.start.at, stem.start.heading), 0.0, stem.length);
  const double radius = std::lerp(stem.start_radius, stem.end_radius, stem.length > 0 ? along / stem.length : 0);
  return length(inner.end().at - stem.start.at - stem.start.heading * along) + std::abs(radius - inner.end_radius);
}

// A run of segments of one axis as one prism.
struct Run {
  Segment stem;
  std::size_t first;
  double error_m;
};

// Joins marked segments that continue each other while all their ends are within the tolerance of a straight stem.
std::vector<Run> straight_runs(const Skeleton& skeleton, const std::vector<bool>& marked, double tolerance_m) {
  const std::vector<Segment>& all = skeleton.segments;
  std::vector<std::size_t> next(all.size(), all.size());
  for (std::size_t i = all.size(); i-- > 0;) {
    if (!marked[i] || all[i].parent == lsystems::kNoParent) continue;
    const auto parent = static_cast<std::size_t>(all[i].parent);
    if (marked[parent] && all[parent].order == all[i].order) next[parent] = i;
  }
  std::vector<bool> taken(all.size());
  std::vector<Run> runs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!marked[i] || taken[i]) continue;
    Run run{all[i], i, 0};
    std::vector<std::size_t> within{i};
    for (std::size_t last = next[i]; last < all.size(); last = next[last]) {
      const Segment longer = straight(all[i], all[last]);
      double worst_m = 0;
      for (const std::size_t inner : within) worst_m = std::max(worst_m, off_m(longer, all[inner]));
      if (worst_m > tolerance_m) break;
      within.push_back(last), taken[last] = true;
      run.stem = longer, run.error_m = worst_m;
    }
    runs.push_back(run);
  }
  return runs;
}

// Distance along the stems from the root to each segment's start.
std::vector<double> along_m(const Skeleton& skeleton) {
  std::vector<double> along;
  for (const Segment& segment : skeleton.segments) {
    const auto parent = static_cast<std::size_t>(segment.parent);
    const bool is_root = segment.parent == lsystems::kNoParent;
    along.push_back(is_root ? 0 : along[parent] + std::abs(skeleton.segments[parent].length));
  }
  return along;
}

// Texture coordinates of a prism: one texture period around it.
void add_prism_uvs(std::vector<Vec2>& uvs, const Segment& segment, double along_m, double bark_m) {
  for (int i = 0; i < 3; ++i) {
    uvs.push_back({i * bark_m / 3, along_m});
    uvs.push_back({i * bark_m / 3, along_m + std::abs(segment.length)});
  }
}

}  // namespace

StemMesh mesh_stems(const Skeleton& skeleton, double tolerance_m, double bark_m) {
  assert(tolerance_m > 0 && bark_m >= 0);
  lsystems::TubeOptions options;
  options.tolerance_m = std::min(tolerance_m, kTrunkStays * thickest_m(skeleton)), options.instances = false;
  options.bark_m = bark_m;
  const std::vector<bool> thick = thicker_than(skeleton, kThin * options.tolerance_m),
                          stays = thicker_than(skeleton, options.tolerance_m);
  lsystems::PlantMesh tubes = lsystems::mesh_plant(only(skeleton, thick), options);
  StemMesh stems{{std::move(tubes.bark.positions), std::move(tubes.bark.normals), std::move(tubes.bark.triangles)},
                 std::move(tubes.bark.uvs),
                 tubes.error_m};
  if (!(bark_m > 0)) stems.uvs.clear();
  const std::vector<double> along = along_m(skeleton);
  const Turns turns = {direction_of(0), direction_of(1 / 3.0), direction_of(2 / 3.0)};
  std::vector<bool> thin(stays.size());
  for (std::size_t i = 0; i < stays.size(); ++i) thin[i] = stays[i] && !thick[i];
  for (const Run& run : straight_runs(skeleton, thin, tolerance_m)) {
    add_prism(stems.mesh, run.stem, turns);
    if (bark_m > 0) add_prism_uvs(stems.uvs, run.stem, along[run.first], bark_m);
    stems.error_m = std::max(stems.error_m, run.error_m + kPrismOff * segment_radius(run.stem));
  }
  return stems;
}

}  // namespace citykiln::plants

// Joints by boxes and Catmull-Clark surfaces as in Felkel, Wonka, Fuhrmann, "Tree skinning", 2004, and Blender's skin
// modifier. Here they end in circles, so that stems are round, and OpenSubdiv's weights are applied in doubles.
#include "lsystems/mesh/tubes.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <memory>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"
#include "lsystems/mesh/joint.h"
#include "lsystems/mesh/joint_bark_uv.h"
#include "lsystems/mesh/joint_stencils.h"
#include "lsystems/mesh/leaves.h"
#include "lsystems/mesh/ring.h"

namespace citykiln::lsystems {
namespace {

constexpr int kLevels = 5;  // 4, 8, … kMostSides
// Bound of the distance from a joint's mesh to its limit surface in Joint::extent_m, by level: 1.5 times the largest of
// 1,500 random joints.
constexpr double kJointBend[kLevels] = {0.26, 0.093, 0.039, 0.014, 0.0055};
constexpr std::uint32_t kNotDrawn = 0xffffffff;
constexpr double kMostPeriods = 64;  // of the bark texture around a stem

// The children of each segment.
struct Branching {
  std::vector<std::uint32_t> starts;    // of segment i, children[starts[i]] … children[starts[i + 1]]
  std::vector<std::uint32_t> children;  // kept ones that begin at the end of their parent
  std::vector<bool> kept, attached;
};

Vec3 direction(const Segment& segment) { return segment.start.heading * (segment.length < 0 ? -1.0 : 1.0); }
double slope(const Segment& segment) {
  const double length = std::abs(segment.length);
  return length > 0 ? std::clamp((segment.start_radius - segment.end_radius) / length, -8.0, 8.0) : 0;
}
double thickest(const Segment& segment) { return std::max(segment.start_radius, segment.end_radius); }

// Segments thicker than the tolerance, and their ancestors.
std::vector<bool> kept_of(const Skeleton& skeleton, double tolerance_m) {
  std::vector<bool> kept(skeleton.segments.size());
  for (std::size_t i = kept.size(); i-- > 0;) {
    const Segment& segment = skeleton.segments[i];
    if (2 * thickest(segment) > tolerance_m) kept[i] = true;
    if (kept[i] && segment.parent != kNoParent) kept[segment.parent] = true;
  }
  return kept;
}

bool begins_at_end(const Segment& child, const Segment& parent) {
  const double nearly = 1e-9 * (1e-3 + length(child.start.at) + std::abs(parent.length));
  return length(child.start.at - parent.end().at) <= nearly;
}

Branching branching_of(const Skeleton& skeleton, double tolerance_m) {
  const std::vector<Segment>& segments = skeleton.segments;
  Branching branching;
  branching.kept = kept_of(skeleton, tolerance_m);
  branching.attached.resize(segments.size());
  branching.starts.assign(segments.size() + 1, 0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::int32_t parent = segments[i].parent;
    if (!branching.kept[i] || parent == kNoParent || !begins_at_end(segments[i], segments[parent])) continue;
    branching.attached[i] = true;
    ++branching.starts[parent + 1];
  }
  for (std::size_t i = 0; i < segments.size(); ++i) branching.starts[i + 1] += branching.starts[i];
  std::vector<std::uint32_t> next(branching.starts.begin(), branching.starts.end() - 1);
  branching.children.resize(branching.starts.back());
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (branching.attached[i]) branching.children[next[segments[i].parent]++] = static_cast<std::uint32_t>(i);
  return branching;
}

// A ring, and its first of sides + 1 vertices in the mesh.
struct DrawnRing {
  Ring ring;
  std::uint32_t first = kNotDrawn;
  double turn = 0;  // of the ring's first point relative to the first vertex
  BarkWrap wrap{};  // of the stem
};

// Two sums at once; SSE2 is part of x86-64.
using Pair = double __attribute__((vector_size(16)));
struct Spread {
  Pair xx, yy, zz, xy;
  double z;
};

Ring ring_on(const Segment& segment, double radius, double tolerance_m) {
  Ring ring;
  ring.at = segment.start.at;
  ring.axis = direction(segment);
  ring.x = perpendicular_to(ring.axis, segment.start.left);
  ring.radius = radius;
  ring.slope = slope(segment);
  ring.sides = sides_of(radius, tolerance_m);
  return ring;
}

// Height of the flared foot.
double foot_height(const Segment& root) { return std::min(3 * root.start_radius, 0.3 * std::abs(root.length)); }

bool has_foot(const Segment& root, double flare) {
  return flare > 0 && root.parent == kNoParent && std::abs(root.start.at.z) <= root.start_radius &&
         direction(root).z > 0.7 && foot_height(root) > 0;
}

// Shares of a segment's length that joints at its start and end may use; together less than 1. Stems overlap more at
// their start.
constexpr double kRoomAtStart = 0.62, kRoomAtEnd = 0.3;

Stem stem_of(const Segment& segment, double radius, double room, std::uint32_t id) {
  return {.direction = direction(segment),
          .radius = radius,
          .slope = slope(segment),
          .room_m = room * std::abs(segment.length),
          .id = static_cast<std::int32_t>(id)};
}

// Sorts the continuing stem first, then the others by thickness.
std::vector<Stem>& sort_stems(std::vector<Stem>& stems, Vec3 arriving) {
  const auto score = [&](const Stem& s) { return s.radius * (1.5 + dot(s.direction, arriving)); };
  const auto best =
      std::max_element(stems.begin(), stems.end(), [&](const Stem& a, const Stem& b) { return score(a) < score(b); });
  std::iter_swap(stems.begin(), best);
  const std::size_t joined = std::min(stems.size(), kMostSideStems + 1);
  std::partial_sort(
      stems.begin() + 1, stems.begin() + static_cast<std::ptrdiff_t>(joined), stems.end(),
      [](const Stem& a, const Stem& b) { return a.radius != b.radius ? a.radius > b.radius : a.id < b.id; });
  return stems;
}

// @param radius  Largest radius of the joint's stems along their segments.
int joint_sides(const Joint& joint, double radius, double tolerance_m) {
  int level = 0;
  while (level + 1 < kLevels && kJointBend[level] * joint.extent_m + kRoundness * radius > tolerance_m) ++level;
  return std::max(4 << level, sides_of(radius, tolerance_m));
}

struct Mesher {
  Mesher(const Skeleton& of, const TubeOptions& with) : skeleton(of), options(with) {}

  const Skeleton& skeleton;
  const TubeOptions& options;
  const Circle circle = make_circle();
  const double unit_m = options.bark_m > 0 ? options.bark_m : 1;  // of u
  Branching branching;
  std::vector<DrawnRing> begins;  // the ring at which each segment begins
  std::unique_ptr<JointStencils> shapes[kLevels][16];
  std::array<Spread, kMostPoints> points;  // of one joint's cage
  std::vector<Vec3> positions, normals;    // of its rows
  PlantMesh out;

  const Segment& segment(std::size_t i) const { return skeleton.segments[i]; }
  std::span<const std::uint32_t> children_of(std::size_t i) const {
    return {branching.children.data() + branching.starts[i], branching.children.data() + branching.starts[i + 1]};
  }
  void bound(double error_m) { out.error_m = std::max(out.error_m, error_m); }

  // Adds a ring's vertices from point `shift` on, which lies at `turn`.
  std::uint32_t draw_ring(const Ring& ring, const BarkWrap& wrap, int shift = 0, double turn = 0) {
    const auto first = static_cast<std::uint32_t>(out.bark.positions.size());
    const Vec3 y = cross(ring.axis, ring.x);
    const int stride = kMostSides / ring.sides;
    const double scale = 1 / std::sqrt(1 + ring.slope * ring.slope), step = 1.0 / ring.sides;
    const Vec3 lean = ring.axis * (ring.slope * scale);
    for (int i = 0; i <= ring.sides; ++i) {
      const Vec3 out_of = outward(ring, y, circle[(i + shift) % ring.sides * stride]);
      out.bark.positions.push_back(point_on(ring, out_of));
      out.bark.normals.push_back(out_of * scale + lean);
      out.bark.uvs.push_back({wrap.u(turn + i * step) * unit_m, ring.along_m});
    }
    return first;
  }

  // Adds the triangles between two rings, by merging their angles; the upper ring begins at `turn`.
  void weld(const DrawnRing& lower, const Ring& upper, std::uint32_t upper_first, double turn) {
    const int m = lower.ring.sides, n = upper.sides;
    const double step_a = 1.0 / m, step_b = 1.0 / n;
    std::uint32_t a = lower.first, b = upper_first;
    for (int i = 0, j = 0; i < m || j < n;) {
      const bool on_lower = j == n || (i < m && (i + 0.5) * step_a <= turn + (j + 0.5) * step_b);
      if (on_lower) {
        out.bark.triangles.push_back({a, a + 1, b});
        ++a, ++i;
      } else {
        out.bark.triangles.push_back({a, b + 1, b});
        ++b, ++j;
      }
    }
  }

  // Chords lie inside circles by the sagitta. Between tilted circles, a point of a triangle is off the line of its
  // angle by up to half a side times the angle between the circles' tangents.
  void bound_strip(const Ring& lower, const Ring& upper) {
    const double radius = std::max(lower.radius, upper.radius);
    const int sides = std::min(lower.sides, upper.sides);
    const Vec3 tilt = upper.axis - lower.axis;
    bound(radius * (sagitta(sides) + 2 * kPi / sides / 4 * dot(tilt, tilt)));
  }

  // @param turned  Whether the upper ring keeps its own first point; else the lower one's is transported.
  DrawnRing draw_tube(const DrawnRing& lower, Ring upper, bool turned) {
    const Vec3 x = parallel_transported(lower.ring.x, lower.ring.axis, upper.axis);
    upper.along_m = lower.ring.along_m + length(upper.at - lower.ring.at);
    int shift = 0;
    double from = 0, turn = 0;
    if (turned) {
      // the upper point nearest to the lower ring's first point
      turn = arctangent2_deg(dot(upper.x, cross(upper.axis, x)), dot(upper.x, x)) / 360;
      const double places = std::floor(-turn * upper.sides + 0.5);
      shift = (static_cast<int>(places) + upper.sides) % upper.sides;
      from = turn + places / upper.sides;
    } else {
      upper.x = x;
    }
    const std::uint32_t first = draw_ring(upper, lower.wrap, shift, from);
    weld(lower, upper, first, from);
    bound_strip(lower.ring, upper);
    return {upper, first, turn, lower.wrap};
  }

  void cap(const Ring& ring, Vec3 normal) {
    const std::uint32_t first = draw_ring(ring, {});
    for (int i = 0; i <= ring.sides; ++i) out.bark.normals[first + i] = normal;
    const bool is_upper = dot(normal, ring.axis) > 0;
    for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(ring.sides); ++i)
      out.bark.triangles.push_back({first, first + (is_upper ? i : i + 1), first + (is_upper ? i + 1 : i)});
  }

  // A flared foot: a parabola from the ground to the trunk, in pieces.
  DrawnRing draw_foot(const Segment& root, const BarkWrap& wrap) {
    const double height = foot_height(root), radius = root.start_radius;
    const double more = options.flare * height / 3;
    const double error_m = options.tolerance_m / 4;
    const int pieces = error_m > 0 ? std::clamp(static_cast<int>(std::sqrt(more / (4 * error_m))) + 1, 1, 64) : 64;
    DrawnRing foot{{}, kNotDrawn, 0, wrap};
    for (int i = 0; i <= pieces; ++i) {
      const double up = static_cast<double>(i) / pieces, rest = 1 - up;
      Ring ring = ring_on(root, radius + more * rest * rest - slope(root) * height * up, options.tolerance_m * 0.75);
      ring.at = ring.at + ring.axis * (height * up);
      ring.slope += 2 * more * rest / height;
      if (i == 0) cap(ring, ring.axis * -1.0);
      foot = i == 0 ? DrawnRing{ring, draw_ring(ring, wrap), 0, wrap} : draw_tube(foot, ring, false);
    }
    bound(foot.ring.radius * sagitta(foot.ring.sides) + more / (4.0 * pieces * pieces));
    bound((radius + more) * sagitta(sides_of(radius + more, options.tolerance_m * 0.75)) +
          more / (4.0 * pieces * pieces));
    return foot;
  }

  DrawnRing begin_with_cap(std::size_t i) {
    ++out.separate_stems;
    const BarkWrap wrap{periods_around(i), kFirstU};
    if (has_foot(segment(i), options.flare)) return draw_foot(segment(i), wrap);
    Ring ring = ring_on(segment(i), segment(i).start_radius, options.tolerance_m);
    ring.sides = sides_of(thickest(segment(i)), options.tolerance_m);
    cap(ring, ring.axis * -1.0);
    return {ring, draw_ring(ring, wrap), 0, wrap};
  }

  void end_in_cap(std::size_t i, const DrawnRing& begin) {
    Ring ring = ring_on(segment(i), segment(i).end_radius, options.tolerance_m);
    ring.at = segment(i).end().at;
    ring.sides = sides_of(thickest(segment(i)), options.tolerance_m);
    cap(draw_tube(begin, ring, false).ring, ring.axis);
  }

  // The ring lies in the plane that bisects the bend.
  void end_in_bend(std::size_t i, const DrawnRing& begin) {
    const std::uint32_t child = children_of(i)[0];
    Ring ring = ring_on(segment(i), segment(i).end_radius, 0);
    ring.at = segment(i).end().at;
    const Vec3 to = direction(segment(child)), both = ring.axis + to, bend = to - ring.axis;
    if (length(both) > 1e-3) ring.axis = unit(both);
    ring.sides = 4;
    const double bent = 2 * kPi / 4 * dot(bend, bend);
    const double radius = std::max(thickest(segment(i)), thickest(segment(child)));
    while (ring.sides < kMostSides && radius * (sagitta(ring.sides) + bent / ring.sides) > options.tolerance_m)
      ring.sides *= 2;
    begins[child] = draw_tube(begin, ring, false);
  }

  // The cage's points, with each coordinate twice, for pairs of weights.
  void spread_points(const Joint& joint) {
    const auto put = [&](std::size_t i, Vec3 p) {
      points[i] = Spread{Pair{p.x, p.x}, Pair{p.y, p.y}, Pair{p.z, p.z}, Pair{p.x, p.y}, p.z};
    };
    for (std::size_t i = 0; i < joint.box.size(); ++i) put(i, joint.box[i]);
    for (std::size_t s = 0; s < joint.stems; ++s) {
      const Ring& ring = joint.rings[s];
      const Vec3 y = cross(ring.axis, ring.x);
      const std::size_t first = 8 + s * kRingPoints;
      for (std::size_t k = 0; k < 8; ++k) {
        const Vec3 out_of = outward(ring, y, circle[k * (kMostSides / 8)]) * ring.radius;
        put(first + k, ring.at + out_of * kRingScale);
        if (k % 2 == 0) put(first + 8 + k / 2, ring.at + out_of * kCornerScale);
      }
    }
  }

  // Applies the stencils to the cage's points.
  void evaluate(const JointStencils& shape, const Joint& joint) {
    spread_points(joint);
    const std::size_t rows = shape.starts.size() - 1;
    positions.resize(rows);
    normals.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      Pair x{}, y{}, z{}, second_xy{};
      double second_z = 0;
      for (std::uint32_t w = shape.starts[row]; w < shape.starts[row + 1]; ++w) {
        const JointStencils::Weight& weight = shape.weights[w];
        const Spread& p = points[weight.point];
        const Pair first{weight.position, weight.tangent_1}, second{weight.tangent_2, weight.tangent_2};
        x += first * p.xx;
        y += first * p.yy;
        z += first * p.zz;
        second_xy += second * p.xy;
        second_z += weight.tangent_2 * p.z;
      }
      const Vec3 normal = unit(cross({x[1], y[1], z[1]}, {second_xy[0], second_xy[1], second_z}));
      positions[row] = {x[0], y[0], z[0]};
      normals[row] = dot(normal, normal) > 0.5 ? normal : joint.rings[0].axis;
    }
  }

  // Texture periods around the stem that begins with segment i and extends to its next branching.
  double periods_around(std::size_t i) const {
    if (!(options.bark_m > 0)) return 1;
    const double first = thickest(segment(i));
    while (children_of(i).size() == 1) i = children_of(i)[0];
    const double mean = (first + segment(i).end_radius) / 2;
    return std::clamp(std::floor(2 * kPi * mean / options.bark_m + 0.5), 1.0, kMostPeriods);
  }

  // Sets the wraps of the stems that leave a joint.
  void set_wraps(const Joint& joint, const DrawnRing& end) {
    begins[joint.ids[1]].wrap = continue_wrap(end.wrap, end.turn, periods_around(joint.ids[1]));
    for (std::size_t s = 2; s < joint.stems; ++s) begins[joint.ids[s]].wrap = {periods_around(joint.ids[s]), kFirstU};
  }

  JointBarkUv bark_of(const Joint& joint, const BarkWrap& arriving) const {
    std::array<BarkWrap, 2 + kMostSideStems> wrap{arriving};
    for (std::size_t s = 1; s < joint.stems; ++s) wrap[s] = begins[joint.ids[s]].wrap;
    return joint_bark_uv(joint, wrap);
  }

  void draw_joint(const Joint& joint, const BarkWrap& arriving) {
    const int level = std::bit_width(static_cast<unsigned>(joint.rings[0].sides)) - 3;
    std::unique_ptr<JointStencils>& made = shapes[level][joint.open];
    if (!made) made = std::make_unique<JointStencils>(make_joint_stencils(joint.rings[0].sides, joint.open));
    const JointStencils& shape = *made;
    evaluate(shape, joint);
    const auto first = static_cast<std::uint32_t>(out.bark.positions.size());
    const int stride = kMostSides / joint.rings[0].sides;
    std::array<Vec3, 2 + kMostSideStems> y;
    for (int s = 0; s < shape.stems; ++s) y[s] = cross(joint.rings[s].axis, joint.rings[s].x);
    const JointBarkUv bark = bark_of(joint, arriving);
    for (const JointStencils::Vertex& vertex : shape.vertices) {
      const Vec2 at = bark.at(vertex);
      out.bark.uvs.push_back({at.x * unit_m, at.y});
      if (vertex.stem < 0) {
        out.bark.positions.push_back(positions[vertex.index]);
        out.bark.normals.push_back(normals[vertex.index]);
        continue;
      }
      const Ring& ring = joint.rings[vertex.stem];
      const Vec3 out_of = outward(ring, y[vertex.stem], circle[vertex.index * stride]);
      out.bark.positions.push_back(point_on(ring, out_of));
      out.bark.normals.push_back(normal_on(ring, out_of));
    }
    for (const Triangle& t : shape.triangles) out.bark.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }

  void end_in_joint(std::size_t i, const DrawnRing& begin) {
    std::vector<Stem> stems;
    for (const std::uint32_t child : children_of(i))
      stems.push_back(stem_of(segment(child), segment(child).start_radius, kRoomAtStart, child));
    const Stem parent = stem_of(segment(i), segment(i).end_radius, kRoomAtEnd, static_cast<std::uint32_t>(i));
    sort_stems(stems, parent.direction);
    const std::size_t joined = std::min(stems.size(), kMostSideStems + 1);
    Joint joint = place_joint(segment(i).end().at, parent, stems[0], std::span(stems).subspan(1, joined - 1));
    double radius = thickest(segment(i));
    for (std::size_t s = 1; s < joint.stems; ++s) radius = std::max(radius, thickest(segment(joint.ids[s])));
    const int sides = joint_sides(joint, radius, options.tolerance_m);
    for (Ring& ring : joint.rings) ring.sides = sides;
    const DrawnRing end = draw_tube(begin, joint.rings[0], true);
    const double low_m = end.ring.along_m;
    joint.rings[0].along_m = low_m;
    for (std::size_t s = 1; s < joint.stems; ++s)
      joint.rings[s].along_m = low_m + length(joint.rings[s].at - joint.rings[0].at);
    set_wraps(joint, end);
    draw_joint(joint, {end.wrap.per_turn, end.wrap.u(end.turn)});
    for (std::size_t s = 1; s < joint.stems; ++s) begins[joint.ids[s]].ring = joint.rings[s];
    for (std::size_t s = joined; s < stems.size(); ++s) branching.attached[stems[s].id] = false;
    const int level = std::bit_width(static_cast<unsigned>(sides)) - 3;
    bound(kJointBend[level] * joint.extent_m + kRoundness * radius);
    ++out.joints;
  }

  // Reserves an upper estimate; pages that are not written cost nothing.
  void reserve() {
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
      if (!branching.kept[i]) continue;
      const auto sides = static_cast<std::size_t>(sides_of(thickest(segment(i)), options.tolerance_m));
      vertices += 3 * (sides + 1) + (children_of(i).size() > 1 ? 2 * sides * sides + 30 : 0);
    }
    out.bark.positions.reserve(vertices);
    out.bark.normals.reserve(vertices);
    out.bark.uvs.reserve(vertices);
    out.bark.triangles.reserve(vertices * 3 / 2);
  }

  void draw_bark() {
    branching = branching_of(skeleton, options.tolerance_m);
    reserve();
    begins.resize(skeleton.segments.size());
    for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
      if (!branching.kept[i]) {
        ++out.left_out;
        continue;
      }
      DrawnRing begin = branching.attached[i] ? begins[i] : begin_with_cap(i);
      if (begin.first == kNotDrawn) begin.first = draw_ring(begin.ring, begin.wrap);
      const std::size_t children = children_of(i).size();
      if (children == 0) end_in_cap(i, begin);
      if (children == 1) end_in_bend(i, begin);
      if (children >= 2) end_in_joint(i, begin);
    }
  }
};

// Keeps the memory.
void clear(PlantMesh& mesh) {
  for (PartMesh* part : {&mesh.bark, &mesh.leaf}) {
    part->positions.clear();
    part->normals.clear();
    part->uvs.clear();
    part->triangles.clear();
  }
  mesh.error_m = 0;
  mesh.joints = mesh.separate_stems = mesh.left_out = 0;
}

}  // namespace

void mesh_plant(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& mesh) {
  assert(options.tolerance_m >= 0 && options.bark_m >= 0);
  Mesher mesher(skeleton, options);
  clear(mesh);
  mesher.out = std::move(mesh);
  mesher.draw_bark();
  mesh_leaves(skeleton, options, mesher.out);
  mesh = std::move(mesher.out);
}

PlantMesh mesh_plant(const Skeleton& skeleton, const TubeOptions& options) {
  PlantMesh mesh;
  mesh_plant(skeleton, options, mesh);
  return mesh;
}

}  // namespace citykiln::lsystems

#include "compiler/structures/stairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "compiler/geometry/snap.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/structures/loft.h"

namespace citykiln::structures {
namespace {

// Spacing of cross lines along the way: the least depth of a tread. Steeper ways have higher steps.
constexpr double kSpacing_m = 0.125;
// Lower flights are not stairs.
constexpr double kMinFlight_m = 1.5 * kRiser_m;
// The ground is sampled at this share of the half width: beside the edge there may be a wall.
constexpr double kNearEdge = 0.9;
// How far blocks extend into the ground.
constexpr double kBlockDepth_m = 0.25;

// A line across the way.
struct CrossLine {
  Vec2 left, right;
  double z_m = 0, low_m = 0;  // the highest ground on the way, and the lowest on it or at its edges
  bool is_corner = false;     // at a vertex of the axis
};

struct GroundSampler {
  const roads::Road& steps;
  const ground::LandCoverIndex& land_cover;
  const ground::GradedTerrain& ground;
  const Box2& box;
  double left_m, right_m;

  // The land cover polygon at a point if it is that of the steps, else null.
  const ground::LandCoverPolygon* land_cover_at(Vec2 p) const {
    if (!box.contains(p)) return nullptr;
    const std::uint32_t s = ground::land_cover_at(land_cover, p);
    return s != ground::kNoLandCover && land_cover.surfaces[s].surface == steps.surface ? &land_cover.surfaces[s]
                                                                                        : nullptr;
  }

  CrossLine crossing(Vec2 p, Vec2 left, const ground::LandCoverPolygon& surface) const {
    CrossLine c{snapped(p + left * left_m), snapped(p - left * right_m)};
    const ground::FaceHeight height = ground::face_height_of(surface);
    const auto ground_m = [&](Vec2 at) { return layer_height_m(ground::heights_at(ground, at), height); };
    c.z_m = c.low_m = ground_m(p);
    for (const Vec2 edge : {c.left, c.right}) {
      c.z_m = std::max(c.z_m, ground_m(p + (edge - p) * kNearEdge));
      c.low_m = std::min(c.low_m, ground::land_m(ground, edge));
    }
    return c;
  }
};

// The normal of the axis; at a vertex the bisector of both normals.
Vec2 left_at(const Polyline& axis, std::size_t segment, bool is_begin) {
  const Vec2 own = left_of(unit(axis[segment + 1] - axis[segment]));
  if (!is_begin || segment == 0) return own;
  const Vec2 sum = own + left_of(unit(axis[segment] - axis[segment - 1]));
  return length(sum) > 0.5 ? unit(sum) : own;
}

// True if both ends of a line lie before b.
bool is_before(const CrossLine& a, const CrossLine& b) {
  const Vec2 across = b.left - b.right, along = {across.y, -across.x};
  return dot(b.left - a.left, along) > 0 && dot(b.right - a.right, along) > 0;
}

// Lines near a corner would cross; the one at the corner is kept.
void add_line(const CrossLine& next, std::vector<CrossLine>& run) {
  while (next.is_corner && !run.empty() && !run.back().is_corner && !is_before(run.back(), next)) run.pop_back();
  if (next.is_corner || run.empty() || is_before(run.back(), next)) run.push_back(next);
}

// Runs of cross lines, split where another land cover lies on the way.
std::vector<std::vector<CrossLine>> runs_of(const GroundSampler& sampler) {
  std::vector<std::vector<CrossLine>> runs(1);
  const Polyline& axis = sampler.steps.axis;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const int count = std::max(1, static_cast<int>(distance(axis[i], axis[i + 1]) / kSpacing_m));
    for (int k = 0; k < count; ++k) {
      const Vec2 p = snapped(axis[i] + (axis[i + 1] - axis[i]) * (static_cast<double>(k) / count));
      const ground::LandCoverPolygon* surface = sampler.land_cover_at(p);
      if (surface == nullptr) {
        if (!runs.back().empty()) runs.emplace_back();
        continue;
      }
      CrossLine crossing = sampler.crossing(p, left_at(axis, i, k == 0), *surface);
      crossing.is_corner = k == 0;
      add_line(crossing, runs.back());
    }
  }
  return runs;
}

// The ends of a run, and where it changes between rising and falling by more than kMinFlight_m.
std::vector<std::size_t> turns_of(std::span<const CrossLine> run) {
  std::vector<std::size_t> turns = {0};
  std::size_t highest = 0, lowest = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (run[i].z_m > run[highest].z_m) highest = i;
    if (run[i].z_m < run[lowest].z_m) lowest = i;
    const bool has_risen = run[i].z_m - run[lowest].z_m > kMinFlight_m && lowest > turns.back();
    const bool has_fallen = run[highest].z_m - run[i].z_m > kMinFlight_m && highest > turns.back();
    if (!has_risen && !has_fallen) continue;
    turns.push_back(has_risen ? lowest : highest);
    highest = lowest = i;
  }
  turns.push_back(run.size() - 1);
  return turns;
}

// Not so in bends where the cross lines intersect.
bool is_convex(const std::array<Vec2, 4>& ring) {
  for (std::size_t i = 0; i < 4; ++i)
    if (cross(ring[(i + 1) % 4] - ring[i], ring[(i + 2) % 4] - ring[(i + 1) % 4]) <= 0) return false;
  return true;
}

void add_block(const CrossLine& a, const CrossLine& b, double top_m, Stairs& stairs) {
  const double low_m = std::min(a.low_m, b.low_m);
  stairs.error_m = std::max(stairs.error_m, top_m - low_m);
  // counter-clockwise for flights in both directions
  std::array<Vec2, 4> base = {a.right, b.right, b.left, a.left};
  if (cross(base[2] - base[0], base[3] - base[1]) < 0) std::ranges::reverse(base);
  if (!is_convex(base)) return;
  add_prism(base, low_m - kBlockDepth_m, top_m, stairs.mesh);
}

// A tread from one riser to the next: a block for each straight piece.
void add_tread(std::span<const CrossLine> tread, double top_m, Stairs& stairs) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < tread.size(); ++i) {
    if (!tread[i].is_corner && i + 1 < tread.size()) continue;
    add_block(tread[first], tread[i], top_m, stairs);
    first = i;
  }
}

// Adds the treads of a flight that rises from its first line to its last.
void add_flight(std::span<const CrossLine> flight, double usual_riser_m, Stairs& stairs) {
  const double from_m = flight.front().z_m, rise_m = flight.back().z_m - from_m;
  if (rise_m < kMinFlight_m) return;
  const double riser_m = rise_m / std::max(1.0, std::round(rise_m / usual_riser_m));
  double highest_m = from_m;
  std::size_t begin = 0;
  int risers = 0;  // below the tread that begins there
  for (std::size_t i = 0; i < flight.size(); ++i) {
    highest_m = std::max(highest_m, flight[i].z_m);
    // minus rounding errors, so that the last line needs no further step
    const int needed = static_cast<int>(std::ceil((highest_m - from_m) / riser_m - 0x1p-10));
    if (needed == risers) continue;
    if (risers > 0) add_tread(flight.subspan(begin, i - begin + 1), from_m + risers * riser_m, stairs);
    begin = i, risers = needed;
  }
  if (begin + 1 < flight.size()) add_tread(flight.subspan(begin), from_m + risers * riser_m, stairs);
}

// A bar of a square section between two points, upright or sloping.
void add_bar(Vec3 from, Vec3 to, Vec2 across, Mesh& mesh) {
  constexpr double kHalf_m = 0.03125;
  const Vec2 along = {across.y, -across.x};
  const bool is_post = in_plan(from) == in_plan(to);
  const Vec2 a = across * kHalf_m, b = is_post ? along * kHalf_m : Vec2{};
  const double low_m = is_post ? 0 : -kHalf_m, high_m = is_post ? 0 : kHalf_m;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3 end : {from, to}) {
    const Vec2 p = in_plan(end);
    for (const Vec3 corner : {at_height(p - a - b, end.z + low_m), at_height(p + a - b, end.z + low_m),
                              at_height(p + a + b, end.z + high_m), at_height(p - a + b, end.z + high_m)})
      mesh.positions.push_back(snapped(corner));
  }
  const auto quad = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) {
    add_quad(mesh, first + i, first + j, first + k, first + l);
  };
  quad(3, 2, 1, 0), quad(4, 5, 6, 7), quad(0, 1, 5, 4), quad(1, 2, 6, 5), quad(2, 3, 7, 6), quad(3, 0, 4, 7);
}

// A handrail along a flight. `share` is its place across the way: 0 at the left edge, 1 at the right one.
void add_handrail(std::span<const CrossLine> flight, double share, Stairs& stairs) {
  std::size_t last = 0;
  const auto foot = [&](const CrossLine& line) { return line.left + (line.right - line.left) * share; };
  const auto post = [&](const CrossLine& line) {
    add_bar(at_height(foot(line), line.low_m), at_height(foot(line), line.z_m + kHandrail_m),
            unit(line.right - line.left), stairs.rails);
    stairs.error_m = std::max(stairs.error_m, line.z_m + kHandrail_m + 0.1 - line.low_m);
  };
  post(flight.front());
  for (std::size_t i = 1; i < flight.size(); ++i) {
    const bool is_far = distance(foot(flight[last]), foot(flight[i])) >= kPostSpacing_m;
    if (!is_far && !flight[i].is_corner && i + 1 < flight.size()) continue;
    const CrossLine &a = flight[last], &b = flight[i];
    add_bar(at_height(foot(a), a.z_m + kHandrail_m), at_height(foot(b), b.z_m + kHandrail_m), unit(a.right - a.left),
            stairs.rails);
    post(b);
    last = i;
  }
}

void add_handrails(std::span<const CrossLine> flight, std::uint8_t handrails, Stairs& stairs) {
  if (handrails == 0 || std::abs(flight.back().z_m - flight.front().z_m) < kMinFlight_m) return;
  constexpr double kFromEdge = 0.04;
  if (handrails & map::kHandrailLeft) add_handrail(flight, kFromEdge, stairs);
  if (handrails & map::kHandrailRight) add_handrail(flight, 1 - kFromEdge, stairs);
  if (handrails & map::kHandrailCentre) add_handrail(flight, 0.5, stairs);
}

void add_flights(std::vector<CrossLine>& run, const roads::Road& steps, Stairs& stairs) {
  if (run.size() < 2) return;
  const std::vector<std::size_t> turns = turns_of(run);
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    std::vector<CrossLine> flight(run.begin() + static_cast<std::ptrdiff_t>(turns[i]),
                                  run.begin() + static_cast<std::ptrdiff_t>(turns[i + 1]) + 1);
    add_handrails(flight, steps.handrails, stairs);
    if (flight.back().z_m < flight.front().z_m) std::ranges::reverse(flight);
    add_flight(flight, steps.riser_m > 0 ? steps.riser_m : kRiser_m, stairs);
  }
}

}  // namespace

Stairs stairs_on(const roads::Road& steps, const ground::LandCoverIndex& land_cover,
                 const ground::GradedTerrain& ground, const Box2& box) {
  Stairs stairs{.feature = steps.id.osm, .mesh = {}};
  const GroundSampler sampler{steps, land_cover, ground, box, roads::left_m(steps), roads::right_m(steps)};
  for (std::vector<CrossLine>& run : runs_of(sampler)) add_flights(run, steps, stairs);
  return stairs;
}

}  // namespace citykiln::structures

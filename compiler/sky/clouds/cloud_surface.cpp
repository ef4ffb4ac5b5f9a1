#include "compiler/sky/clouds/cloud_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/mathematics.h"

namespace citykiln::sky {
namespace {

using Index3 = std::array<int, 3>;

// The nodes of a block and around it: cells beside its own, and their nodes.
constexpr int kAround = 2;

// Distances to the union at nodes; negative inside. Farther than `far` they are `far`.
struct Lattice {
  double cell_m;
  Index3 low;   // of the first node
  Index3 size;  // nodes
  std::vector<double> distance;

  std::size_t at(Index3 i) const { return static_cast<std::size_t>((i[2] * size[1] + i[1]) * size[0] + i[0]); }
  Vec3 place(Index3 i) const { return {(low[0] + i[0]) * cell_m, (low[1] + i[1]) * cell_m, (low[2] + i[2]) * cell_m}; }
};

int cell_of(double m, double cell_m) { return static_cast<int>(std::floor(m / cell_m)); }

// A sphere changes the nodes within its radius and two cells.
void add_sphere_to_lattice(Lattice& lattice, const CloudParticle& sphere) {
  const double reach_m = sphere.radius_m + 2 * lattice.cell_m;
  const std::array centre = {sphere.centre.x, sphere.centre.y, sphere.centre.z};
  Index3 first, last;
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = std::max(0, cell_of(centre[a] - reach_m, lattice.cell_m) - lattice.low[a]);
    last[a] = std::min(lattice.size[a] - 1, cell_of(centre[a] + reach_m, lattice.cell_m) + 1 - lattice.low[a]);
  }
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x) {
        double& distance = lattice.distance[lattice.at({x, y, z})];
        distance = std::min(distance, length(lattice.place({x, y, z}) - sphere.centre) - sphere.radius_m);
      }
}

// Clouds end at their base.
void cut_at_base(Lattice& lattice) {
  for (int z = 0; z < lattice.size[2]; ++z) {
    const double below_m = -lattice.place({0, 0, z}).z;
    const auto first = lattice.distance.begin() + static_cast<std::ptrdiff_t>(lattice.at({0, 0, z}));
    std::for_each(first, first + lattice.size[0] * lattice.size[1], [&](double& d) { d = std::max(d, below_m); });
  }
}

Lattice lattice_of(const LayerParticles& particles, const std::vector<std::uint32_t>& spheres,
                   std::pair<int, int> block, double cell_m) {
  double top_m = 0;
  for (const std::uint32_t i : spheres)
    top_m = std::max(top_m, particles.spheres[i].centre.z + particles.spheres[i].radius_m);
  const int wide = kSurfaceBlock + 2 * kAround + 1;
  Lattice lattice{.cell_m = cell_m,
                  .low = {block.first * kSurfaceBlock - kAround, block.second * kSurfaceBlock - kAround, -kAround},
                  .size = {wide, wide, cell_of(top_m, cell_m) + 2 * kAround + 2},
                  .distance = {}};
  lattice.distance.assign(static_cast<std::size_t>(wide) * wide * lattice.size[2], 2 * cell_m);
  for (const std::uint32_t i : spheres) add_sphere_to_lattice(lattice, particles.spheres[i]);
  cut_at_base(lattice);
  return lattice;
}

// The corners of a cell by bits: x, y, z.
Index3 corner(Index3 cell, int bits) {
  return {cell[0] + (bits & 1), cell[1] + (bits >> 1 & 1), cell[2] + (bits >> 2)};
}

// Vertices of the cells that the surface crosses, and the faces between them.
class SurfaceNet {
 public:
  SurfaceNet(const Lattice& lattice, const LayerParticles& particles)
      : lattice_(lattice), particles_(particles), vertices_(lattice.distance.size(), -1) {
    const double step_m = lattice.cell_m * particles.frame.flatten;
    extinction_ = extinction_per_m(particles.layer.kind) * step_m;
    columns_.resize(static_cast<std::size_t>(lattice.size[0]) * lattice.size[1]);
    for (std::size_t i = 0; i < lattice.distance.size(); ++i)
      columns_[i % columns_.size()] += std::clamp(0.5 - lattice.distance[i] / lattice.cell_m, 0.0, 1.0);
  }

  // The faces across all edges between nodes that begin in the block.
  CloudSurface faces() {
    for (int z = 1; z + 1 < lattice_.size[2]; ++z)
      for (int y = kAround; y < kAround + kSurfaceBlock; ++y)
        for (int x = kAround; x < kAround + kSurfaceBlock; ++x)
          for (std::size_t axis = 0; axis < 3; ++axis) add_face({x, y, z}, axis);
    return std::move(surface_);
  }

 private:
  double distance(Index3 i) const { return lattice_.distance[lattice_.at(i)]; }

  void add_face(Index3 node, std::size_t axis) {
    Index3 next = node;
    ++next[axis];
    const bool is_in = distance(node) < 0;
    if (is_in == (distance(next) < 0)) return;
    std::array<std::uint32_t, 4> around;
    constexpr std::array<std::pair<int, int>, 4> kTurn = {{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Index3 cell = node;
      cell[(axis + 1) % 3] -= kTurn[i].first, cell[(axis + 2) % 3] -= kTurn[i].second;
      around[i] = vertex(cell);
    }
    if (!is_in) std::swap(around[1], around[3]);
    const auto across = [&](std::size_t a, std::size_t b) {
      return length(surface_.positions[around[a]] - surface_.positions[around[b]]);
    };
    const std::size_t first = across(0, 2) <= across(1, 3) ? 0 : 1;
    const auto turn = [&](std::size_t i) { return around[(first + i) % 4]; };
    surface_.triangles.push_back({turn(0), turn(1), turn(2)});
    surface_.triangles.push_back({turn(0), turn(2), turn(3)});
  }

  std::uint32_t vertex(Index3 cell) {
    std::int32_t& number = vertices_[lattice_.at(cell)];
    if (number < 0) number = add_vertex(cell);
    return static_cast<std::uint32_t>(number);
  }

  std::int32_t add_vertex(Index3 cell) {
    const Vec3 at = mean_crossing(cell);
    const LayerFrame& frame = particles_.frame;
    surface_.positions.push_back(frame.out_of(lattice_.place(cell) + at * lattice_.cell_m));
    surface_.normals.push_back(outwards(gradient(cell, at)));
    surface_.opacity.push_back(1 - exponential(-extinction_ * column(cell, at)));
    return static_cast<std::int32_t>(surface_.positions.size()) - 1;
  }

  // The mean of the surface's crossings with the cell's edges, in cells from its first node.
  Vec3 mean_crossing(Index3 cell) const {
    Vec3 sum;
    int count = 0;
    for (int from = 0; from < 8; ++from)
      for (int axis = 0; axis < 3; ++axis) {
        const int to = from | 1 << axis;
        if (to == from) continue;
        const double a = distance(corner(cell, from)), b = distance(corner(cell, to));
        if ((a < 0) == (b < 0)) continue;
        Vec3 at{static_cast<double>(from & 1), static_cast<double>(from >> 1 & 1), static_cast<double>(from >> 2)};
        (axis == 0 ? at.x : axis == 1 ? at.y : at.z) += a / (a - b);
        sum = sum + at, ++count;
      }
    assert(count > 0);
    return sum * (1.0 / count);
  }

  // The gradient of the trilinear function between the corners' distances.
  Vec3 gradient(Index3 cell, Vec3 at) const {
    Vec3 sum;
    for (int bits = 0; bits < 8; ++bits) {
      const double d = distance(corner(cell, bits));
      const double x = bits & 1 ? at.x : 1 - at.x, y = bits >> 1 & 1 ? at.y : 1 - at.y, z = bits >> 2 ? at.z : 1 - at.z;
      sum.x += (bits & 1 ? d : -d) * y * z, sum.y += (bits >> 1 & 1 ? d : -d) * x * z;
      sum.z += (bits >> 2 ? d : -d) * x * y;
    }
    return sum;
  }

  // A normal of the frame as one of the plane.
  Vec3 outwards(Vec3 normal) const {
    const LayerFrame& frame = particles_.frame;
    const double u = normal.x / frame.stretch;
    const Vec3 turned = {u * frame.along.x - normal.y * frame.along.y, u * frame.along.y + normal.y * frame.along.x,
                         normal.z / frame.flatten};
    return length(turned) > 0 ? unit(turned) : Vec3{0, 0, 1};
  }

  // The number of cells of cloud in the vertical.
  double column(Index3 cell, Vec3 at) const {
    const auto of = [&](int x, int y) {
      return columns_[static_cast<std::size_t>((cell[1] + y) * lattice_.size[0] + cell[0] + x)];
    };
    return (of(0, 0) * (1 - at.x) + of(1, 0) * at.x) * (1 - at.y) + (of(0, 1) * (1 - at.x) + of(1, 1) * at.x) * at.y;
  }

  const Lattice& lattice_;
  const LayerParticles& particles_;
  std::vector<std::int32_t> vertices_;  // by the cell's first node; negative: none
  std::vector<double> columns_;         // cells of cloud over each node of the ground plan
  double extinction_;                   // of a cell
  CloudSurface surface_;
};

// The spheres that touch each block.
std::map<std::pair<int, int>, std::vector<std::uint32_t>> blocks_of(const LayerParticles& particles, double cell_m) {
  std::map<std::pair<int, int>, std::vector<std::uint32_t>> blocks;
  const double block_m = cell_m * kSurfaceBlock;
  for (std::uint32_t i = 0; i < particles.spheres.size(); ++i) {
    const CloudParticle& sphere = particles.spheres[i];
    const double reach_m = sphere.radius_m + (kAround + 2) * cell_m;
    for (int y = cell_of(sphere.centre.y - reach_m, block_m); y <= cell_of(sphere.centre.y + reach_m, block_m); ++y)
      for (int x = cell_of(sphere.centre.x - reach_m, block_m); x <= cell_of(sphere.centre.x + reach_m, block_m); ++x)
        blocks[{x, y}].push_back(i);
  }
  return blocks;
}

}  // namespace

bool is_thin(const CloudLayer& layer) {
  return extinction_per_m(layer.kind) * (layer.top_m - layer.base_m) < kThinCloud;
}

std::vector<CloudSurface> cloud_surfaces(const LayerParticles& particles, double cell_m, int threads) {
  assert(cell_m > 0);
  const auto blocks = blocks_of(particles, cell_m);
  const std::vector<std::pair<std::pair<int, int>, std::vector<std::uint32_t>>> list(blocks.begin(), blocks.end());
  std::vector<CloudSurface> parts = for_each_slot<CloudSurface>(list.size(), threads, [&](std::size_t i) {
    const Lattice lattice = lattice_of(particles, list[i].second, list[i].first, cell_m);
    return SurfaceNet(lattice, particles).faces();
  });
  std::erase_if(parts, [](const CloudSurface& part) { return part.triangles.empty(); });
  return parts;
}

}  // namespace citykiln::sky

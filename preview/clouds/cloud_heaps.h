// The density of one layer of clouds: heaps with billowed surfaces.
//
//         ○ ○            The heaps of sky::generate_cloud() are spheres. Their surface is smoothed where they meet,
//       ○( ) ○ ○         moved out and in by billows of several sizes, and cut at the base. Density rises from 0 at the
//     ○(   )( )( )○      surface to 1 within some tens of metres: farther near the base, where edges are frayed.
//     ─────────────
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/sky/clouds/generate_cloud.h"
#include "preview/clouds/billow_noise.h"

namespace citykiln::preview {

/// The surface of heaps.
enum class CloudEdges {
  kSharp,    ///< Separate spheres with density 1 inside.
  kSoft,     ///< Spheres joined smoothly. Density rises from their surface to 1 at the depth soft_m().
  kBillowed  ///< kSoft, with billows on the surface.
};

/// A part of a ray, in plane metres along it, in one column of heaps. begin < end.
struct HeapStretch {
  double begin, end;
  std::uint32_t column;
};

/// The heaps of a layer, in columns of the layer's frame (sky::LayerFrame). Thread-safe.
class CloudHeaps {
 public:
  /// Generates the clouds of a layer within kFarthestCloud_m of an eye (plane metres). Cost: O(clouds).
  CloudHeaps(const sky::CloudLayer& layer, Vec3 eye);
  /// Uses these spheres in place of generated clouds. They are copied; places are in the layer's frame.
  CloudHeaps(const sky::CloudLayer& layer, std::span<const sky::CloudParticle> spheres, CloudEdges edges);

  /// Replaces `stretches` by the parts of a ray that may meet clouds, the nearest first: in each column with heaps from
  /// the base up to its highest heap.
  ///
  /// @param from        Plane metres; z above sea level.
  /// @param direction   Unit vector.
  /// @param distance_m  The length of the ray, plane metres; may be infinite.
  void stretches_of(Vec3 from, Vec3 direction, double distance_m, std::vector<HeapStretch>& stretches) const;

  /// A ray in the layer's frame: the place at a distance in plane metres is from + along · distance.
  struct Ray {
    Vec3 from, along;
    double speed;  ///< The length of `along`: metres of the frame per plane metre.
  };
  Ray ray_of(Vec3 from, Vec3 direction) const;

  /// The density at a place, and the distance in which it is 0.
  struct Sample {
    double density = 0;  ///< 0 to 1, deep inside a cloud. Times extinction_per_m() it is the extinction.
    double free_m = 0;   ///< An estimate of the distance to the nearest surface, in metres of the frame; 0 inside.
  };
  /// Returns the density at a place of the layer's frame in a column.
  /// @param finest_m  Billows that are smaller are left out, and edges are not sharper than a third of it, in metres of
  ///                  the frame.
  Sample sample(Vec3 own, std::uint32_t column, double finest_m) const;
  /// Returns the density at a place of the layer's frame.
  double density(Vec3 own, double finest_m) const;

  double extinction_per_m() const { return extinction_per_m_; }
  const sky::LayerFrame& frame() const { return frame_; }
  double base_m() const { return frame_.base_m; }
  /// Returns the depth in which density rises to 1, in metres of the frame.
  double soft_m() const { return soft_m_; }
  std::size_t size() const { return heaps_.size(); }
  std::size_t clouds() const { return clouds_; }

 private:
  struct Heap {
    float x, y, z, radius_m;
  };
  void build(std::span<const sky::CloudParticle> spheres);
  double around_m(const sky::CloudParticle& sphere) const;  // the radius in which it reaches columns
  std::vector<std::vector<Heap>> by_column(std::span<const sky::CloudParticle> spheres) const;
  void keep(const std::vector<std::vector<Heap>>& columns);
  float distance_inside(const Vec3& own, std::uint32_t column) const;
  float billow(const Vec3& own, double finest_m) const;
  std::int64_t column_at(double x, double y) const;

  sky::LayerFrame frame_;
  double extinction_per_m_;
  CloudEdges edges_ = CloudEdges::kBillowed;
  double soft_m_, billow_m_;
  double reach_m_ = 0, deep_m_ = 0;  // how far billows move the surface out, and the depth below which density is 1
  std::size_t clouds_ = 0;
  Vec2 low_{};
  double column_m_ = 1, top_m_ = 0;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;  // by column, and the end
  std::vector<Heap> heaps_;           // by column; a heap is in all columns that it reaches
  std::vector<float> tops_m_;         // by column
  BillowNoise noise_;
};

/// The largest distance from the eye at which clouds are generated. Beyond it, air or the Earth's curve hides them: a
/// cloud base of 1,500 m sets behind the horizon at 140 km, but at 40 km it is two degrees high.
inline constexpr double kFarthestCloud_m = 40000;

}  // namespace citykiln::preview

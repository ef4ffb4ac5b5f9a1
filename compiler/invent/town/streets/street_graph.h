// The graph of streets while it grows: vertices and straight segments that meet at vertices only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

enum class StreetClass : std::uint8_t { kPrimary, kSecondary, kTertiary, kResidential, kLiving, kPedestrian, kService };

inline bool is_main(StreetClass c) { return c <= StreetClass::kTertiary; }

/// A street: what its segments share.
struct Street {
  StreetClass street_class = StreetClass::kResidential;
  std::string name{};
  bool is_roundabout = false;
};

struct StreetVertex {
  Vec2 position;
  std::vector<std::uint32_t> segments{};  ///< In the order in which they were added.
};

struct StreetSegment {
  std::uint32_t a = 0, b = 0;
  std::uint32_t street = 0;
  bool is_bridge = false;
  bool is_removed = false;
};

/// Where a straight line meets a segment.
struct StreetHit {
  std::uint32_t segment = 0;
  double share = 0;  ///< Along the line.
  Vec2 place;
};

inline constexpr std::uint32_t kNoStreetVertex = 0xffffffffu;

/// The steps of coordinates of towns. Larger than those of map files, so that places stay different there.
inline constexpr double kPlaceStep_m = 1.0 / 32;
Vec2 on_place_grid(Vec2 p);

/// Segments lie in square buckets for searches, which visit them in the order of their numbers.
class StreetGraph {
 public:
  explicit StreetGraph(double side_m);

  std::vector<Street> streets;

  const std::vector<StreetVertex>& vertices() const { return vertices_; }
  const std::vector<StreetSegment>& segments() const { return segments_; }
  Vec2 position(std::uint32_t vertex) const { return vertices_[vertex].position; }
  std::size_t degree(std::uint32_t vertex) const { return vertices_[vertex].segments.size(); }
  /// The other end of a segment.
  std::uint32_t other_end(std::uint32_t segment, std::uint32_t vertex) const;
  /// The direction from a vertex along one of its segments, length 1.
  Vec2 direction_from(std::uint32_t vertex, std::uint32_t segment) const;
  const Street& street_of(std::uint32_t segment) const { return streets[segments_[segment].street]; }

  std::uint32_t add_vertex(Vec2 p);
  std::uint32_t add_segment(std::uint32_t a, std::uint32_t b, std::uint32_t street, bool is_bridge = false);
  void make_bridge(std::uint32_t segment) { segments_[segment].is_bridge = true; }
  void remove_segment(std::uint32_t segment);
  /// Puts a vertex on a segment and returns it.
  std::uint32_t split(std::uint32_t segment, Vec2 p);

  bool are_joined(std::uint32_t a, std::uint32_t b) const;
  /// The segments that may touch a box, ascending.
  std::vector<std::uint32_t> near(const Box2& box) const;
  /// The first segment that the line from a vertex meets, except those at the vertex.
  std::optional<StreetHit> first_hit(std::uint32_t from, Vec2 to) const;
  /// True if the line between two vertices touches no segment but those at its ends.
  bool is_clear(std::uint32_t from, std::uint32_t to) const;
  /// The vertex nearest to a place within a distance, kNoStreetVertex if there is none.
  std::uint32_t nearest_vertex(Vec2 p, double within_m) const;

 private:
  void put_in_buckets(std::uint32_t segment);
  int column(double x) const;

  double half_m_;
  int columns_;
  std::vector<StreetVertex> vertices_;
  std::vector<StreetSegment> segments_;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

/// Joins a vertex to a place by a straight street, with vertices where it meets others; returns the vertex there.
/// Vertices within `snap_m` of crossings and of the place are used. A place at which it would have no length is left
/// out.
std::uint32_t lay_street(StreetGraph& graph, std::uint32_t from, Vec2 to, std::uint32_t street, double snap_m,
                         bool is_bridge = false);

}  // namespace citykiln::invent

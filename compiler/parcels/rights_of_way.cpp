#include "compiler/parcels/rights_of_way.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/snap.h"

namespace citykiln::parcels {
namespace {

// The cosine of the largest outward turn at which edges are continued to their crossing, 40°. Beyond it the
// right-of-way is round, so that lots about dead ends have a frontage each.
constexpr double kLeastMitre = 0.766;
// The cosine of the largest turn between two edges of a round right-of-way, 30°.
constexpr double kArcStep = 0.866;

// A segment's end at a node, seen outward.
struct Arm {
  GridPoint node;
  GridPoint outward;  // direction in grid steps
  std::uint32_t line = 0, segment = 0;
  bool is_start = false;
};

struct Edge {
  Vec2 a, b;
};

struct Segment {
  std::uint32_t line = 0, index = 0;
  Vec2 from, to, along;
  std::array<Edge, 2> edges;                                        // left, right; the land is to the left of a → b
  std::array<std::uint32_t, 2> street_edge = {kNoIndex, kNoIndex};  // by side
};

double width_of(const Line& line, Side side) {
  return std::max(side == Side::kLeft ? line.left_m : line.right_m, kLeastRightOfWay_m);
}

Segment segment_of(const Line& line, std::uint32_t number, std::uint32_t index) {
  Segment s{
      .line = number, .index = index, .from = line.axis[index], .to = line.axis[index + 1], .along = {}, .edges = {}};
  s.along = unit(s.to - s.from);
  const Vec2 left = left_of(s.along) * width_of(line, Side::kLeft);
  const Vec2 right = left_of(s.along) * -width_of(line, Side::kRight);
  s.edges = {Edge{snapped(s.from + left), snapped(s.to + left)}, Edge{snapped(s.to + right), snapped(s.from + right)}};
  return s;
}

std::vector<Segment> segments_of(const std::vector<Line>& lines) {
  std::vector<Segment> segments;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (lines[i].kind == LineKind::kNone) continue;
    for (std::uint32_t k = 0; k + 1 < lines[i].axis.size(); ++k)
      if (lines[i].axis[k] != lines[i].axis[k + 1]) segments.push_back(segment_of(lines[i], i, k));
  }
  return segments;
}

RightOfWayPiece quad_of(const Segment& s) {
  const Border left{BorderKind::kLine, Side::kLeft, s.line, s.index},
      right{BorderKind::kLine, Side::kRight, s.line, s.index};
  const auto& [l, r] = s.edges;
  // through the axis points, so that joints share edges with it
  return {{r.b, r.a, s.to, l.b, l.a, s.from}, {right, right, left, left, left, right}};
}

int half_of(GridPoint d) { return d.y > 0 || (d.y == 0 && d.x > 0) ? 0 : 1; }

// Counter-clockwise from east, then by line.
bool is_before(const Arm& p, const Arm& q) {
  if (p.node != q.node) return p.node < q.node;
  const int hp = half_of(p.outward), hq = half_of(q.outward);
  if (hp != hq) return hp < hq;
  const std::int64_t side = p.outward.x * q.outward.y - p.outward.y * q.outward.x;
  if (side != 0) return side > 0;
  return std::tie(p.line, p.segment, p.is_start) < std::tie(q.line, q.segment, q.is_start);
}

std::vector<Arm> arms_of(const std::vector<Segment>& segments) {
  std::vector<Arm> arms;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const GridPoint from = grid_point(segments[i].from), to = grid_point(segments[i].to);
    const GridPoint along{to.x - from.x, to.y - from.y};
    arms.push_back({from, along, segments[i].line, i, true});
    arms.push_back({to, {-along.x, -along.y}, segments[i].line, i, false});
  }
  std::ranges::sort(arms, is_before);
  return arms;
}

// The side of the line that lies to the left or right of an arm, seen outward.
Side outward_left(const Arm& arm) { return arm.is_start ? Side::kLeft : Side::kRight; }
Side outward_right(const Arm& arm) { return arm.is_start ? Side::kRight : Side::kLeft; }

std::optional<Vec2> crossing_of_lines(Vec2 p, Vec2 u, Vec2 q, Vec2 v) {
  const double area = cross(u, v);
  if (std::abs(area) < 1e-9) return std::nullopt;
  return p + u * (cross(q - p, v) / area);
}

// Builds street edges and joints node by node.
class Linker {
 public:
  Linker(const std::vector<Line>& lines, std::vector<Segment>& segments) : lines_(lines), segments_(segments) {
    for (Segment& s : segments_) {
      ways_.pieces.push_back(quad_of(s));
      if (lines_[s.line].kind != LineKind::kStreet) continue;
      for (const Side side : {Side::kLeft, Side::kRight}) s.street_edge[index(side)] = add(s, side, edge(s, side));
    }
  }

  void link_all(const std::vector<Arm>& arms) {
    for (std::size_t first = 0; first < arms.size();) {
      std::size_t last = first;
      while (last < arms.size() && arms[last].node == arms[first].node) ++last;
      for (std::size_t i = first; i < last; ++i) link(arms[i], arms[i == first ? last - 1 : i - 1], last - first == 1);
      first = last;
    }
  }

  RightsOfWay take() { return std::move(ways_); }

 private:
  static std::size_t index(Side side) { return static_cast<std::size_t>(side); }
  static const Edge& edge(const Segment& s, Side side) { return s.edges[index(side)]; }

  std::uint32_t add(const Segment& s, Side side, Edge e) {
    const Line& line = lines_[s.line];
    RightOfWayEdge f{
        .line = s.line, .segment = s.index, .side = side, .a = e.a, .b = e.b, .normal = left_of(unit(e.b - e.a))};
    f.size = side == Side::kLeft ? line.left_size : line.right_size;
    ways_.street_edges.push_back(f);
    return static_cast<std::uint32_t>(ways_.street_edges.size() - 1);
  }

  void connect(std::uint32_t from, std::uint32_t to) {
    if (from == kNoIndex || to == kNoIndex) return;
    ways_.street_edges[from].next = to;
    ways_.street_edges[to].previous = from;
  }

  // The land between two neighbouring arms: one arrives along `in`, with the land to the left, and leaves along `out`.
  void link(const Arm& in, const Arm& out, bool is_end) {
    const Segment &arriving = segments_[in.segment], &leaving = segments_[out.segment];
    const Side in_side = outward_right(in), out_side = outward_left(out);
    const Edge e = edge(arriving, in_side), f = edge(leaving, out_side);
    const std::uint32_t from = arriving.street_edge[index(in_side)], to = leaving.street_edge[index(out_side)];
    const Vec2 u = unit(e.b - e.a), v = unit(f.b - f.a);
    const double turn_left = cross(u, v);
    if (is_end || turn_left < 0)
      turn_outward(plane_point(in.node), {from, to}, {e, f}, arriving, in_side, is_end);
    else if (dot(u, v) > -0.9998)  // else one arm covers the other
      turn_inward({from, to}, {e, f}, turn_left, dot(u, v));
  }

  void turn_inward(std::array<std::uint32_t, 2> ids, std::array<Edge, 2> edges, double turn_left, double ahead) {
    const Vec2 u = unit(edges[0].b - edges[0].a), v = unit(edges[1].b - edges[1].a);
    if (turn_left > 0.02)
      if (const auto x = crossing_of_lines(edges[0].a, u, edges[1].a, v)) {
        if (ids[0] != kNoIndex) cut_end(ways_.street_edges[ids[0]], *x);
        if (ids[1] != kNoIndex) cut_start(ways_.street_edges[ids[1]], *x);
      }
    connect(ids[0], ids[1]);
    if (ids[0] != kNoIndex) ways_.street_edges[ids[0]].is_corner = ahead < 0.766;
  }

  static void cut_end(RightOfWayEdge& f, Vec2 x) {
    const double at = dot(x - f.a, f.b - f.a);
    f.b = at <= 0 ? f.a : at < dot(f.b - f.a, f.b - f.a) ? x : f.b;
  }
  static void cut_start(RightOfWayEdge& f, Vec2 x) {
    const double at = dot(x - f.b, f.a - f.b);
    f.a = at <= 0 ? f.b : at < dot(f.a - f.b, f.a - f.b) ? x : f.a;
  }

  void turn_outward(Vec2 node, std::array<std::uint32_t, 2> ids, const std::array<Edge, 2>& edges,
                    const Segment& arriving, Side side, bool is_end) {
    const Vec2 from = edges[0].b, to = edges[1].a;
    const Vec2 u = unit(edges[0].b - edges[0].a), v = unit(edges[1].b - edges[1].a);
    const Border border{BorderKind::kLine, side, arriving.line, arriving.index};
    if (from == to) return connect_outward(ids[0], ids[1]);
    std::vector<Vec2> points = {from};
    if (is_end || dot(u, v) < kLeastMitre) {
      add_arc(node, from, to, points);
    } else {
      const auto tip = crossing_of_lines(edges[0].a, u, edges[1].a, v);
      if (tip && dot(*tip - from, u) > 0 && dot(*tip - to, v) < 0)
        return add_mitre({node, to, snapped(*tip), from}, ids, border);
      // nearly straight: the gap is a few steps of the grid wide, and its direction means nothing
      ways_.pieces.push_back({{node, to, from}, {border, border, border}});
      return connect_outward(ids[0], ids[1]);
    }
    points.push_back(to);
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i - 1] == points[i]) continue;
      ways_.pieces.push_back({{node, points[i], points[i - 1]}, {border, border, border}});
      if (ids[0] == kNoIndex) continue;
      const std::uint32_t next = add(arriving, side, {points[i - 1], points[i]});
      connect_outward(ids[0], next);
      ids[0] = next;
    }
    connect_outward(ids[0], ids[1]);
  }

  void add_mitre(const Ring& joint, std::array<std::uint32_t, 2> ids, const Border& border) {
    ways_.pieces.push_back({joint, {border, border, border, border}});
    if (ids[0] != kNoIndex) ways_.street_edges[ids[0]].b = joint[2];
    if (ids[1] != kNoIndex) ways_.street_edges[ids[1]].a = joint[2];
    connect_outward(ids[0], ids[1]);
  }

  // Appends the points between two points of a round end, clockwise about the node.
  static void add_arc(Vec2 node, Vec2 from, Vec2 to, std::vector<Vec2>& points) {
    const Vec2 p = unit(from - node), q = unit(to - node), sum = p + q;
    if (dot(p, q) > kArcStep) return;
    // half a turn, and by rounding perhaps a little more
    const bool is_half_turn = dot(sum, sum) < 1e-4 || cross(p, q) > 0;
    const Vec2 middle = is_half_turn ? left_of(p) * -1 : unit(sum);
    const Vec2 at = snapped(node + middle * ((distance(node, from) + distance(node, to)) / 2));
    add_arc(node, from, at, points);
    points.push_back(at);
    add_arc(node, at, to, points);
  }

  void connect_outward(std::uint32_t from, std::uint32_t to) {
    connect(from, to);
    if (from != kNoIndex) ways_.street_edges[from].turns_outward = true;
  }

  const std::vector<Line>& lines_;
  std::vector<Segment>& segments_;
  RightsOfWay ways_;
};

}  // namespace

RightsOfWay rights_of_way_of(const std::vector<Line>& lines) {
  std::vector<Segment> segments = segments_of(lines);
  Linker linker(lines, segments);
  linker.link_all(arms_of(segments));
  return linker.take();
}

}  // namespace citykiln::parcels

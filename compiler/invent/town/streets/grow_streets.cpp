#include "compiler/invent/town/streets/grow_streets.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "compiler/geometry/segment.h"
#include "compiler/invent/town/draws.h"

namespace citykiln::invent {
namespace {

// Dead ends are this long at least, in metres.
constexpr double kLeastDeadEnd_m = 42;
// The least angle between two streets at a junction that growth makes: its cosine (50°).
constexpr double kLeastAngleCosine = 0.643;

constexpr double kGrowStep_m = 11;
/// Streets join what lies this far ahead.
constexpr double kLookAhead_m = 24;
/// Junctions are this far apart at least; a street that would make a nearer one goes to the one that is there.
constexpr double kJunctionGap_m = 22;
/// The cosine of the angle up to which streets count as parallel (40°).
constexpr double kParallelCosine = 0.766;

/// Dead ends up to this length remain as they are.
constexpr double kLongEnd_m = 140;

/// The distance between streets that run in a family's direction, in metres.
double street_spacing_m(const TownPlan& plan, Vec2 p, int family) {
  const double density = plan.density.at(p);
  const double wide = plan.settings.kind == TownKind::kVillage ? 0.9 : 1;
  if (density > 0.58) return family == 0 ? 86 : 124;
  if (density > 0.3) return (family == 0 ? 72 : 150) * wide;
  return (family == 0 ? 78 : 175) * wide;
}

struct Seed {
  std::uint32_t vertex = 0;
  Vec2 direction;
  int family = 0;
};

Box2 box_around(Vec2 p, double by_m) {
  Box2 box;
  box.grow(p);
  return box.widened(by_m);
}

class Growth {
 public:
  Growth(const TownPlan& plan, const StreetField& field, StreetGraph& graph)
      : plan_(plan), field_(field), graph_(graph) {}

  void run() {
    first_vertex_ = static_cast<std::uint32_t>(graph_.vertices().size());
    seed_main_roads();
    grow_all();
    // what is left wide is filled from the streets about it, twice
    for (int pass = 0; pass < 3; ++pass) {
      seed_everywhere(pass);
      grow_all();
    }
    for (std::uint32_t v = first_vertex_; v < graph_.vertices().size(); ++v)
      if (graph_.degree(v) == 1 && is_within(graph_.position(v))) cut_dead_end(v);
  }

 private:
  void grow_all() {
    while (!seeds_.empty()) {
      const Seed seed = seeds_.front();
      seeds_.pop_front();
      if (may_begin(seed)) grow(seed);
    }
  }

  // ---- seeds

  void seed_main_roads() {
    const std::size_t count = graph_.vertices().size();
    double since_m = 0;
    for (std::uint32_t v = 0; v < count; ++v) {
      if (graph_.degree(v) != 2) continue;
      since_m += kGrowStep_m;
      const Vec2 p = graph_.position(v);
      const Vec2 along = graph_.direction_from(v, graph_.vertices()[v].segments[0]);
      const int family = crossing_family(p, along);
      if (since_m < street_spacing_m(plan_, p, family) * 0.45) continue;
      since_m = 0;
      push_both(v, p, along);
    }
  }

  // every third vertex is a seed, another third in each pass
  void seed_everywhere(int pass) {
    const auto count = static_cast<std::uint32_t>(graph_.vertices().size());
    for (auto v = static_cast<std::uint32_t>(pass); v < count; v += 3)
      if (graph_.degree(v) == 2)
        push_both(v, graph_.position(v), graph_.direction_from(v, graph_.vertices()[v].segments[0]));
  }

  // the family that crosses a direction
  int crossing_family(Vec2 p, Vec2 along) const {
    return std::abs(dot(field_.direction(p, 0), along)) < std::abs(dot(field_.direction(p, 1), along)) ? 0 : 1;
  }

  void push_both(std::uint32_t vertex, Vec2 p, Vec2 along) {
    const int family = crossing_family(p, along);
    const Vec2 direction = field_.direction(p, family);
    seeds_.push_back({vertex, direction, family});
    seeds_.push_back({vertex, direction * -1, family});
  }

  void seed_street(const std::vector<std::uint32_t>& line) {
    Draws draws(plan_.settings.seed, "seeds", graph_.streets.size());
    double since_m = draws.between(0.3, 0.8) * 70;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Vec2 p = graph_.position(line[i]), along = unit(graph_.position(line[i + 1]) - p);
      since_m += distance(graph_.position(line[i - 1]), p);
      if (since_m < street_spacing_m(plan_, p, crossing_family(p, along)) * draws.between(0.85, 1.15)) continue;
      since_m = 0;
      push_both(line[i], p, along);
    }
  }

  bool may_begin(const Seed& seed) const {
    const Vec2 p = graph_.position(seed.vertex);
    if (graph_.degree(seed.vertex) != 2 || !is_angle_free(seed.vertex, seed.direction)) return false;
    if (is_no_start(seed.vertex) || !is_buildable(p) || !is_buildable(p + seed.direction * 40)) return false;
    if (has_junction_near(seed.vertex, p)) return false;
    return !is_crowded(p + seed.direction * 30, seed.direction, seed.family, kNoStreetVertex, 0.8);
  }

  // no street begins on a bridge or a roundabout
  bool is_no_start(std::uint32_t vertex) const {
    return std::ranges::any_of(graph_.vertices()[vertex].segments, [&](std::uint32_t s) {
      return graph_.segments()[s].is_bridge || graph_.street_of(s).is_roundabout;
    });
  }

  bool has_junction_near(std::uint32_t vertex, Vec2 p) const {
    for (const std::uint32_t s : graph_.near(box_around(p, kJunctionGap_m)))
      for (const std::uint32_t v : {graph_.segments()[s].a, graph_.segments()[s].b})
        if (v != vertex && graph_.degree(v) != 2 && distance(graph_.position(v), p) < kJunctionGap_m) return true;
    return false;
  }

  // ---- what limits growth

  bool is_buildable(Vec2 p) const {
    return plan_.is_inside(p) && plan_.density.at(p) > kTownEdge && plan_.water.at(p) > 22 && !plan_.is_reserved(p) &&
           !plan_.is_track_land(p) && length(plan_.terrain->gradient(p)) < 0.25;
  }

  // true if a new segment of this direction makes no small angle at a vertex
  bool is_angle_free(std::uint32_t vertex, Vec2 direction) const {
    return std::ranges::all_of(graph_.vertices()[vertex].segments, [&](std::uint32_t s) {
      return dot(graph_.direction_from(vertex, s), direction) < kLeastAngleCosine;
    });
  }

  // true if a street of this direction runs beside a place, or any street is very near
  bool is_crowded(Vec2 p, Vec2 direction, int family, std::uint32_t street, double share) const {
    const double room_m = street_spacing_m(plan_, p, family) * share;
    for (const std::uint32_t s : graph_.near(box_around(p, room_m))) {
      const StreetSegment& segment = graph_.segments()[s];
      if (segment.street == street) continue;
      const Vec2 a = graph_.position(segment.a), b = graph_.position(segment.b), foot = nearest_point(a, b, p);
      const double away_m = distance(foot, p);
      if (away_m >= room_m) continue;
      const bool is_beside = std::abs(dot(foot - p, direction)) < away_m * 0.5;
      if (is_beside && (away_m < 14 || std::abs(dot(unit(b - a), direction)) > kParallelCosine)) return true;
    }
    return false;
  }

  // ---- growth

  // long streets that join others at both ends collect the traffic of a quarter
  void choose_class(double length_m, Draws& draws) {
    const bool is_through = line_.size() == kept_;
    const bool collects =
        plan_.settings.kind != TownKind::kVillage && is_through && length_m > 320 && draws.chance(0.35);
    Street& street = graph_.streets[street_];
    if (collects) street.street_class = StreetClass::kTertiary;
    if (!is_through && length_m < 150 && draws.chance(0.5)) street.street_class = StreetClass::kLiving;
  }

  void grow(const Seed& seed) {
    street_ = static_cast<std::uint32_t>(graph_.streets.size());
    Draws draws(plan_.settings.seed, "street", street_);
    graph_.streets.push_back({StreetClass::kResidential});
    family_ = seed.family;
    line_ = {seed.vertex};
    kept_ = 1;
    Vec2 direction = seed.direction;
    const double most_m = draws.between(250, 900);
    double length_m = 0;
    while (length_m < most_m) {
      const Vec2 p = graph_.position(line_.back());
      direction = next_direction(p, direction);
      const Step step = advance(direction, draws);
      if (step == Step::kEnd) break;
      length_m += distance(p, graph_.position(line_.back()));
    }
    finish(direction, draws);
    choose_class(length_m, draws);
  }

  enum class Step { kOn, kEnd };

  // the field's direction, turned by at most about 17° from the last
  Vec2 next_direction(Vec2 p, Vec2 before) const {
    Vec2 wanted = field_.direction(p, family_);
    if (dot(wanted, before) < 0) wanted = wanted * -1;
    return line_.size() == 1 ? before : unit(before + (wanted - before) * (dot(wanted, before) > 0.95 ? 1.0 : 0.3));
  }

  Step advance(Vec2 direction, Draws& draws) {
    const std::uint32_t from = line_.back();
    const Vec2 p = graph_.position(from), target = p + direction * kGrowStep_m;
    if (const auto hit = graph_.first_hit(from, p + direction * (kGrowStep_m + kLookAhead_m)))
      return join(*hit, direction) && goes_across(direction, draws) ? Step::kOn : Step::kEnd;
    if (!plan_.is_inside(target)) return leave_world(direction);
    if (!is_buildable(target) || is_crowded(target, direction, family_, street_, 0.55)) return Step::kEnd;
    append(graph_.add_vertex(target));
    return Step::kOn;
  }

  void append(std::uint32_t vertex) {
    graph_.add_segment(line_.back(), vertex, street_);
    line_.push_back(vertex);
  }

  // a street that leaves the square ends on its border
  Step leave_world(Vec2 direction) {
    const std::uint32_t from = line_.back();
    const Vec2 p = graph_.position(from);
    const double half = plan_.half_m();
    double run_m = kGrowStep_m;
    if (direction.x != 0) run_m = std::min(run_m, (half - p.x * (direction.x > 0 ? 1 : -1)) / std::abs(direction.x));
    if (direction.y != 0) run_m = std::min(run_m, (half - p.y * (direction.y > 0 ? 1 : -1)) / std::abs(direction.y));
    const Vec2 end = p + direction * run_m;
    if (run_m > 3 && line_.size() > 2 && !graph_.first_hit(from, p + direction * (run_m + 2)))
      append(graph_.add_vertex(end));
    if (line_.size() > 2) kept_ = line_.size();
    return Step::kEnd;
  }

  // joins the street ahead; false if no place on it will do
  bool join(const StreetHit& hit, Vec2 direction) {
    const StreetSegment segment = graph_.segments()[hit.segment];
    if (segment.is_bridge || graph_.streets[segment.street].is_roundabout) return false;
    const std::uint32_t from = line_.back();
    if (crosses_tracks(graph_.position(from), hit.place)) return false;
    const std::uint32_t junction = junction_near(hit);
    if (junction != kNoStreetVertex) return join_vertex(junction, direction);
    for (const std::uint32_t end : {segment.a, segment.b})
      if (distance(graph_.position(end), hit.place) < 6 && graph_.degree(end) == 2 && graph_.is_clear(from, end))
        return join_vertex(end, direction);
    const Vec2 along = unit(graph_.position(segment.b) - graph_.position(segment.a));
    if (std::abs(dot(along, direction)) > kLeastAngleCosine) return false;
    return join_vertex(graph_.split(hit.segment, hit.place), direction);
  }

  bool crosses_tracks(Vec2 from, Vec2 to) const {
    for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0})
      if (plan_.is_track_land(from + (to - from) * share)) return true;
    return false;
  }

  bool join_vertex(std::uint32_t vertex, Vec2) {
    const std::uint32_t from = line_.back();
    const Vec2 back = unit(graph_.position(from) - graph_.position(vertex));
    if (graph_.degree(vertex) > 3 || vertex == from || graph_.are_joined(from, vertex)) return false;
    if (std::ranges::find(line_, vertex) != line_.end()) return false;
    if (!is_angle_free(vertex, back) || !graph_.is_clear(from, vertex)) return false;
    if (!is_angle_free_at_start(from, back * -1)) return false;
    append(vertex);
    kept_ = line_.size();
    return true;
  }

  // at the first vertex of a street the angle to the street that it leaves counts
  bool is_angle_free_at_start(std::uint32_t from, Vec2 direction) const {
    return graph_.degree(from) < 2 || is_angle_free(from, direction);
  }

  // a junction near the place of a hit, the nearest
  std::uint32_t junction_near(const StreetHit& hit) const {
    std::uint32_t nearest = kNoStreetVertex;
    double least_m = kJunctionGap_m;
    for (const std::uint32_t s : graph_.near(box_around(hit.place, kJunctionGap_m)))
      for (const std::uint32_t v : {graph_.segments()[s].a, graph_.segments()[s].b})
        if (const double d = distance(graph_.position(v), hit.place); graph_.degree(v) != 2 && d < least_m) {
          least_m = d;
          nearest = v;
        }
    return nearest;
  }

  // streets end at most streets that they meet, so most junctions have three arms
  bool goes_across(Vec2 direction, Draws& draws) {
    const std::uint32_t at = line_.back();
    const double share = plan_.density.at(graph_.position(at)) > 0.55 ? 0.55 : 0.3;
    if (!draws.chance(share) || graph_.degree(at) > 3) return false;
    const Vec2 p = graph_.position(at);
    if (!is_angle_free(at, direction) || !is_buildable(p + direction * 30)) return false;
    return !is_crowded(p + direction * 30, direction, family_, street_, 0.8);
  }

  // ---- ends

  void finish(Vec2 direction, Draws& draws) {
    if (line_.size() > kept_ && !rescue(direction)) keep_dead_end(draws);
    if (line_.size() > 1) seed_street(line_);
  }

  // joins the end to a street ahead or aside
  bool rescue(Vec2 direction) {
    const std::uint32_t from = line_.back();
    const Vec2 p = graph_.position(from), side = left_of(direction);
    const double far_m = street_spacing_m(plan_, p, family_) * 0.95;
    for (const auto& [ahead, aside] : {std::pair(1.0, 0.0), {0.87, 0.5}, {0.87, -0.5}, {0.3, 0.95}, {0.3, -0.95}}) {
      const Vec2 ray = direction * ahead + side * aside;
      const auto hit = graph_.first_hit(from, p + ray * far_m);
      if (hit && is_open_way(p, hit->place, ray) && join(*hit, ray)) return true;
    }
    return false;
  }

  bool is_open_way(Vec2 from, Vec2 to, Vec2 ray) const {
    const int steps = 1 + static_cast<int>(distance(from, to) / kGrowStep_m);
    for (int i = 1; i < steps; ++i) {
      const Vec2 p = from + (to - from) * (i * 1.0 / steps);
      if (!is_buildable(p) || is_crowded(p, ray, family_, street_, 0.3)) return false;
    }
    return true;
  }

  void keep_dead_end(Draws& draws) {
    double end_m = 0;
    for (std::size_t i = kept_; i < line_.size(); ++i)
      end_m += distance(graph_.position(line_[i - 1]), graph_.position(line_[i]));
    // a long street into open land stays: others will meet it, and what is left over is cut at the end
    if (end_m > kLongEnd_m) return;
    const double share = plan_.settings.kind == TownKind::kVillage               ? 0.7
                         : plan_.density.at(graph_.position(line_.back())) > 0.5 ? 0.1
                                                                                 : 0.4;
    const double most_m = end_m >= kLeastDeadEnd_m && draws.chance(share) ? draws.between(60, 140) : 0;
    while (line_.size() > kept_ && end_m > most_m) {
      end_m -= distance(graph_.position(line_[line_.size() - 2]), graph_.position(line_.back()));
      take_back();
    }
    if (end_m < kLeastDeadEnd_m)
      while (line_.size() > kept_) take_back();
  }

  // true off the border of the square
  bool is_within(Vec2 p) const { return std::max(std::abs(p.x), std::abs(p.y)) < plan_.half_m() - 1; }

  // cuts a dead end to a usual length, from its end on
  void cut_dead_end(std::uint32_t vertex) {
    std::vector<std::uint32_t> chain;
    double whole_m = 0;
    for (std::uint32_t at = vertex; graph_.degree(at) <= 2 && at >= first_vertex_;) {
      const auto& both = graph_.vertices()[at].segments;
      if (graph_.degree(at) == 1 && !chain.empty()) break;
      const std::uint32_t s = chain.empty() || both[0] != chain.back() ? both[0] : both[1];
      whole_m += distance(graph_.position(at), graph_.position(graph_.other_end(s, at)));
      chain.push_back(s);
      at = graph_.other_end(s, at);
    }
    const double most_m = Draws(plan_.settings.seed, "dead end", vertex).between(55, kLongEnd_m);
    for (const std::uint32_t s : chain) {
      if (whole_m <= most_m && whole_m >= kLeastDeadEnd_m) return;
      const StreetSegment segment = graph_.segments()[s];
      whole_m -= distance(graph_.position(segment.a), graph_.position(segment.b));
      graph_.remove_segment(s);
    }
  }

  void take_back() {
    graph_.remove_segment(graph_.vertices()[line_.back()].segments.back());
    line_.pop_back();
  }

  const TownPlan& plan_;
  const StreetField& field_;
  StreetGraph& graph_;
  std::deque<Seed> seeds_;
  std::uint32_t first_vertex_ = 0;  // the first that is not of a main road
  // the street that grows: its vertices, those up to its last junction, its family and number
  std::vector<std::uint32_t> line_;
  std::size_t kept_ = 0;
  int family_ = 0;
  std::uint32_t street_ = 0;
};

}  // namespace

void grow_streets(const TownPlan& plan, const StreetField& field, StreetGraph& graph) {
  Growth(plan, field, graph).run();
}

}  // namespace citykiln::invent

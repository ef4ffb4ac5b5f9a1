#include "compiler/source/areas/close_along_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "compiler/geometry/mathematics.h"

namespace citykiln::source {
namespace {

constexpr double kStepsOfMetre = 1e7 / 111320;  // of latitude
constexpr double kWidestClosed_deg = 20, kNearPole_deg = 85, kNear180_deg = 179.9;
// An end is led on to a side over this distance at least, and this share of the box at most.
constexpr double kLeastReach_m = 30, kMostReach = 0.125;
// The votes of a ring whose role says where the area is, and how often the right part must have those of the other.
constexpr int kRoleVotes = 3;
constexpr std::int64_t kClearly = 3;
constexpr std::size_t kRowsOfBox = 256;

std::int32_t to_step(double value) { return static_cast<std::int32_t>(std::floor(value + 0.5)); }

std::int64_t width_of(const LocationBox& box) { return std::int64_t{box.high.lon_e7} - box.low.lon_e7; }
std::int64_t height_of(const LocationBox& box) { return std::int64_t{box.high.lat_e7} - box.low.lat_e7; }
std::int64_t sides_of(const LocationBox& box) { return 2 * (width_of(box) + height_of(box)); }

// How many steps of latitude a step of longitude is long in the middle of the box.
double shortening(const LocationBox& box) { return cosine((double{1} * box.low.lat_e7 + box.high.lat_e7) / 2 * 1e-7); }

bool is_ring(const AreaLine& line) { return line.points.size() > 3 && line.points.front() == line.points.back(); }

enum class BoxSide { kSouth, kEast, kNorth, kWest };

// The side of a place on the sides. A corner belongs to the side that begins there, counter-clockwise.
BoxSide side_at(const LocationBox& box, Location at) {
  if (at.lat_e7 == box.low.lat_e7 && at.lon_e7 < box.high.lon_e7) return BoxSide::kSouth;
  if (at.lon_e7 == box.high.lon_e7 && at.lat_e7 < box.high.lat_e7) return BoxSide::kEast;
  if (at.lat_e7 == box.high.lat_e7 && at.lon_e7 > box.low.lon_e7) return BoxSide::kNorth;
  return BoxSide::kWest;
}

// The distance along the sides, counter-clockwise from the south-western corner.
std::int64_t along_sides(const LocationBox& box, Location at) {
  const std::int64_t width = width_of(box), height = height_of(box);
  switch (side_at(box, at)) {
    case BoxSide::kSouth:
      return std::int64_t{at.lon_e7} - box.low.lon_e7;
    case BoxSide::kEast:
      return width + at.lat_e7 - box.low.lat_e7;
    case BoxSide::kNorth:
      return width + height + box.high.lon_e7 - at.lon_e7;
    case BoxSide::kWest:
      return 2 * width + height + box.high.lat_e7 - at.lat_e7;
  }
  return 0;
}

Location nearest_on_side(const LocationBox& box, Location at) {
  const double scale = shortening(box);
  const double west = (double{1} * at.lon_e7 - box.low.lon_e7) * scale,
               east = (double{1} * box.high.lon_e7 - at.lon_e7) * scale, south = double{1} * at.lat_e7 - box.low.lat_e7,
               north = double{1} * box.high.lat_e7 - at.lat_e7;
  const double least = std::min({west, east, south, north});
  if (least == west) return {box.low.lon_e7, at.lat_e7};
  if (least == east) return {box.high.lon_e7, at.lat_e7};
  return least == south ? Location{at.lon_e7, box.low.lat_e7} : Location{at.lon_e7, box.high.lat_e7};
}

double steps_between(Location a, Location b, double scale) {
  const double x = (double{1} * a.lon_e7 - b.lon_e7) * scale, y = double{1} * a.lat_e7 - b.lat_e7;
  return std::sqrt(x * x + y * y);
}

// Leads the last point on to the nearest side. False if it ends inside the box.
bool lead_on_to_side(std::vector<Location>& line, const LocationBox& box) {
  if (!is_strictly_inside(box, line.back())) return true;
  const double scale = shortening(box);
  const double shorter = std::min(double(width_of(box)) * scale, double(height_of(box)));
  const double last = line.size() > 1 ? steps_between(line[line.size() - 2], line.back(), scale) : 0;
  const double reach = std::min(std::max(last, kLeastReach_m * kStepsOfMetre), shorter * kMostReach);
  const Location side = nearest_on_side(box, line.back());
  if (steps_between(side, line.back(), scale) > reach) return false;
  line.push_back(side);
  return true;
}

// Cuts the segment at the line of a side (Liang, Barsky 1984).
struct ShareInside {
  double from = 0, to = 1;
  BoxSide at_from = BoxSide::kWest, at_to = BoxSide::kWest;

  bool cut(double step, double room, BoxSide side) {
    if (step == 0) return room > 0;
    const double t = room / step;
    if (step < 0 && t > from) from = t, at_from = side;
    if (step > 0 && t < to) to = t, at_to = side;
    return from < to;
  }
};

Location on_side(const LocationBox& box, Location a, Location b, double t, BoxSide side) {
  const double lon = a.lon_e7 + (double{1} * b.lon_e7 - a.lon_e7) * t,
               lat = a.lat_e7 + (double{1} * b.lat_e7 - a.lat_e7) * t;
  Location at{std::clamp(to_step(lon), box.low.lon_e7, box.high.lon_e7),
              std::clamp(to_step(lat), box.low.lat_e7, box.high.lat_e7)};
  if (side == BoxSide::kWest) at.lon_e7 = box.low.lon_e7;
  if (side == BoxSide::kEast) at.lon_e7 = box.high.lon_e7;
  if (side == BoxSide::kSouth) at.lat_e7 = box.low.lat_e7;
  if (side == BoxSide::kNorth) at.lat_e7 = box.high.lat_e7;
  return at;
}

// The part of a segment inside the box. Computed from its lesser end, so that its direction does not matter.
std::optional<std::array<Location, 2>> part_inside(Location a, Location b, const LocationBox& box) {
  const bool turned = b < a;
  if (turned) std::swap(a, b);
  const double x = double{1} * b.lon_e7 - a.lon_e7, y = double{1} * b.lat_e7 - a.lat_e7;
  ShareInside share;
  if (!share.cut(-x, double{1} * a.lon_e7 - box.low.lon_e7, BoxSide::kWest) ||
      !share.cut(x, double{1} * box.high.lon_e7 - a.lon_e7, BoxSide::kEast) ||
      !share.cut(-y, double{1} * a.lat_e7 - box.low.lat_e7, BoxSide::kSouth) ||
      !share.cut(y, double{1} * box.high.lat_e7 - a.lat_e7, BoxSide::kNorth))
    return std::nullopt;
  std::array part = {share.from > 0 ? on_side(box, a, b, share.from, share.at_from) : a,
                     share.to < 1 ? on_side(box, a, b, share.to, share.at_to) : b};
  if (part[0] == part[1]) return std::nullopt;
  if (turned) std::swap(part[0], part[1]);
  return part;
}

// Cuts an open line into its parts inside the box.
void add_parts_inside(const AreaLine& line, const LocationBox& box, std::vector<AreaLine>& parts) {
  bool continues = false;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    if (line.points[i] == line.points[i + 1]) continue;
    const auto part = part_inside(line.points[i], line.points[i + 1], box);
    if (part && !continues) parts.push_back({{(*part)[0]}, line.is_inner});
    if (part) parts.back().points.push_back((*part)[1]);
    continues = part && is_strictly_inside(box, (*part)[1]);
  }
}

bool is_all_inside(const AreaLine& line, const LocationBox& box) {
  return std::ranges::all_of(line.points, [&](Location at) { return is_strictly_inside(box, at); });
}

// A ring as a line that begins and ends at a point outside the box.
AreaLine opened_outside(const AreaLine& ring, const LocationBox& box) {
  AreaLine line{{ring.points.begin(), ring.points.end() - 1}, ring.is_inner};
  const auto outside = std::ranges::find_if(line.points, [&](Location at) { return !is_strictly_inside(box, at); });
  std::rotate(line.points.begin(), outside, line.points.end());
  line.points.push_back(Location(line.points.front()));
  return line;
}

// True if the line could be cut at the box.
bool add_cut(AreaLine line, const LocationBox& box, CutLines& cut) {
  if (is_ring(line) && is_all_inside(line, box)) {
    cut.rings.push_back(std::move(line));
    return true;
  }
  if (is_ring(line)) {
    add_parts_inside(opened_outside(line, box), box, cut.lines);
    return true;
  }
  if (!lead_on_to_side(line.points, box)) return false;
  std::ranges::reverse(line.points);
  if (!lead_on_to_side(line.points, box)) return false;
  add_parts_inside(line, box, cut.lines);
  return true;
}

// The place on the widened box beyond a place on the sides.
Location beyond_side(const LocationBox& box, Location at) {
  const double out = kClosedBeyond_m * kStepsOfMetre;
  const std::int32_t x = to_step(out / shortening(box)), y = to_step(out);
  const BoxSide side = side_at(box, at);
  if (side == BoxSide::kSouth) return {at.lon_e7, at.lat_e7 - y};
  if (side == BoxSide::kEast) return {at.lon_e7 + x, at.lat_e7};
  if (side == BoxSide::kNorth) return {at.lon_e7, at.lat_e7 + y};
  return {at.lon_e7 - x, at.lat_e7};
}

struct WideCorner {
  std::int64_t along;
  Location at;
};

// The corners of the widened box, counter-clockwise from the south-western one, twice.
std::vector<WideCorner> wide_corners(const LocationBox& box) {
  const std::int64_t width = width_of(box), height = height_of(box), all = sides_of(box);
  const Location south_west{beyond_side(box, {box.low.lon_e7, box.low.lat_e7 + 1}).lon_e7,
                            beyond_side(box, box.low).lat_e7};
  const Location north_east{beyond_side(box, {box.high.lon_e7, box.low.lat_e7}).lon_e7,
                            beyond_side(box, box.high).lat_e7};
  std::vector<WideCorner> corners = {{0, south_west},
                                     {width, {north_east.lon_e7, south_west.lat_e7}},
                                     {width + height, north_east},
                                     {2 * width + height, {south_west.lon_e7, north_east.lat_e7}}};
  for (std::size_t i = 0; i < 4; ++i) corners.push_back({corners[i].along + all, corners[i].at});
  return corners;
}

struct LineEnd {
  std::int64_t along;
  Location at;
  bool is_inner;
  auto operator<=>(const LineEnd&) const = default;
};

std::vector<LineEnd> ends_of(const CutLines& cut) {
  std::vector<LineEnd> ends;
  for (const AreaLine& line : cut.lines)
    for (const Location at : {line.points.front(), line.points.back()})
      ends.push_back({along_sides(cut.box, at), at, line.is_inner});
  std::ranges::sort(ends);
  return ends;
}

// The line along the widened box, counter-clockwise from one end to the next.
AreaLine line_along(const LocationBox& box, const LineEnd& from, const LineEnd& to, bool turns) {
  AreaLine line{{beyond_side(box, from.at)}, false};
  const std::int64_t last = to.along + (turns ? sides_of(box) : 0);
  for (const WideCorner& corner : wide_corners(box))
    if (corner.along > from.along && corner.along <= last) line.points.push_back(corner.at);
  line.points.push_back(beyond_side(box, to.at));
  return line;
}

AreaLine ring_along(const LocationBox& box) {
  AreaLine ring;
  for (const WideCorner& corner : wide_corners(box))
    if (corner.along <= sides_of(box)) ring.points.push_back(corner.at);
  return ring;
}

// The lines along the sides of a part. Ends are sorted, and the part changes at each.
std::vector<AreaLine> openings_of(const CutLines& cut, bool is_odd) {
  const std::vector<LineEnd> ends = ends_of(cut);
  if (ends.empty()) return is_odd ? std::vector<AreaLine>{} : std::vector{ring_along(cut.box)};
  std::vector<AreaLine> openings;
  for (std::size_t i = is_odd ? 0 : 1; i < ends.size(); i += 2) {
    const bool turns = i + 1 == ends.size();
    const LineEnd& to = ends[turns ? 0 : i + 1];
    if (ends[i].at != to.at) openings.push_back(line_along(cut.box, ends[i], to, turns));
  }
  return openings;
}

AreaLine led_out(const LocationBox& box, const AreaLine& line) {
  AreaLine out{{beyond_side(box, line.points.front())}, false};
  out.points.insert(out.points.end(), line.points.begin(), line.points.end());
  out.points.push_back(beyond_side(box, line.points.back()));
  return out;
}

// The part west of a ring's westernmost point.
bool is_odd_around(const AreaLine& ring, const PartsOfBox& parts) {
  return parts.is_odd(*std::ranges::min_element(ring.points));
}

// Votes of an inner line: the area is not where no outer line ends.
void add_inner_line(const std::vector<LineEnd>& ends, std::int64_t low, std::int64_t high, PartVotes& votes) {
  std::size_t between = 0, beyond = 0, begin = ends.size();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].along == low && begin == ends.size()) begin = i;
    if (ends[i].is_inner) continue;
    ++(ends[i].along > low && ends[i].along < high ? between : beyond);
  }
  // from the line's first end on, the part is odd if an even number of ends lies before
  const bool odd_between = begin % 2 == 0;
  if (between == 0 && beyond > 0) add_vote(votes, odd_between, -kRoleVotes);
  if (between > 0 && beyond == 0) add_vote(votes, !odd_between, -kRoleVotes);
}

// The votes of rings inside the box: the part around an inner ring is the area, the part around an outer ring is not.
PartVotes votes_of_rings(const CutLines& cut, const PartsOfBox& parts) {
  PartVotes votes;
  for (const AreaLine& ring : cut.rings)
    add_vote(votes, is_odd_around(ring, parts), ring.is_inner ? kRoleVotes : -kRoleVotes);
  return votes;
}

// The votes of inner lines. If outer lines end on one side only of an inner line, the part beside it on its other side
// is not the area.
PartVotes votes_of_inner_lines(const CutLines& cut) {
  PartVotes votes;
  const std::vector<LineEnd> ends = ends_of(cut);
  for (const AreaLine& line : cut.lines) {
    if (!line.is_inner) continue;
    const auto [low, high] =
        std::minmax({along_sides(cut.box, line.points.front()), along_sides(cut.box, line.points.back())});
    add_inner_line(ends, low, high, votes);
  }
  return votes;
}

bool is_clear(std::int64_t more, std::int64_t less) { return more > 0 && more >= kClearly * less; }

}  // namespace

std::optional<LocationBox> location_box(const LonLatBox& box) {
  const bool is_sound = box.west < box.east && box.south < box.north && box.east - box.west < kWidestClosed_deg &&
                        box.north - box.south < kWidestClosed_deg && box.west > -kNear180_deg &&
                        box.east < kNear180_deg && box.south > -kNearPole_deg && box.north < kNearPole_deg;
  if (!is_sound) return std::nullopt;
  const LocationBox steps{{to_step(box.west * 1e7), to_step(box.south * 1e7)},
                          {to_step(box.east * 1e7), to_step(box.north * 1e7)}};
  if (width_of(steps) < 2 || height_of(steps) < 2) return std::nullopt;
  return steps;
}

bool is_strictly_inside(const LocationBox& box, Location at) {
  return box.low.lon_e7 < at.lon_e7 && at.lon_e7 < box.high.lon_e7 && box.low.lat_e7 < at.lat_e7 &&
         at.lat_e7 < box.high.lat_e7;
}

std::optional<CutLines> cut_at_box(std::vector<AreaLine> lines, const LocationBox& box) {
  lines = joined_lines(std::move(lines));
  const auto is_closed_outer = [](const AreaLine& line) { return is_ring(line) && !line.is_inner; };
  if (std::ranges::all_of(lines, is_ring) && std::ranges::any_of(lines, is_closed_outer)) return std::nullopt;
  CutLines cut{.box = box, .rings = {}, .lines = {}};
  for (AreaLine& line : lines)
    if (line.points.size() > 1 && !add_cut(std::move(line), box, cut)) return std::nullopt;
  if (cut.rings.empty() && cut.lines.empty()) return std::nullopt;
  return cut;
}

PartsOfBox::PartsOfBox(const CutLines& cut) : box_(cut.box), rows_(kRowsOfBox) {
  for (const std::vector<AreaLine>* kind : {&cut.rings, &cut.lines})
    for (const AreaLine& line : *kind) {
      vertices_.insert(vertices_.end(), line.points.begin(), line.points.end());
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        Segment segment{line.points[i - 1], line.points[i]};
        if (segment.b.lat_e7 < segment.a.lat_e7) std::swap(segment.a, segment.b);
        for (std::size_t row = row_of(segment.a.lat_e7); row <= row_of(segment.b.lat_e7); ++row)
          rows_[row].push_back(segment);
      }
    }
  for (const LineEnd& end : ends_of(cut)) ends_.push_back(end.along);
  std::ranges::sort(vertices_);
}

std::size_t PartsOfBox::row_of(std::int32_t lat_e7) const {
  const std::int64_t up = std::int64_t{lat_e7} - box_.low.lat_e7;
  const std::int64_t row = up * static_cast<std::int64_t>(kRowsOfBox) / height_of(box_);
  return static_cast<std::size_t>(std::clamp<std::int64_t>(row, 0, kRowsOfBox - 1));
}

bool PartsOfBox::is_odd(Location at) const {
  // a line to the west, just above the place
  const auto crosses = [&](const Segment& s) {
    if ((s.a.lat_e7 > at.lat_e7) == (s.b.lat_e7 > at.lat_e7)) return false;
    // s runs upwards: the place is to the right of it
    const std::int64_t dx = std::int64_t{s.b.lon_e7} - s.a.lon_e7, dy = std::int64_t{s.b.lat_e7} - s.a.lat_e7;
    const std::int64_t px = std::int64_t{at.lon_e7} - s.a.lon_e7, py = std::int64_t{at.lat_e7} - s.a.lat_e7;
    return dx * py < dy * px;
  };
  const std::int64_t side = along_sides(box_, {box_.low.lon_e7, at.lat_e7});
  const auto before = std::ranges::lower_bound(ends_, side) - ends_.begin();
  const auto crossings = std::ranges::count_if(rows_[row_of(at.lat_e7)], crosses);
  return (before + crossings) % 2 == 1;
}

bool PartsOfBox::is_vertex(Location at) const { return std::ranges::binary_search(vertices_, at); }

void add_vote(PartVotes& votes, bool is_odd, int weight) {
  (is_odd == (weight > 0) ? votes.odd : votes.even) += weight > 0 ? weight : -weight;
}

PartVotes votes_of_river(const CutLines& cut) {
  if (cut.lines.size() < 2) return {};
  const std::vector<LineEnd> ends = ends_of(cut);
  std::int64_t odd = 0;
  for (std::size_t i = 1; i < ends.size(); i += 2) odd += ends[i].along - ends[i - 1].along;
  const std::int64_t quarter = sides_of(cut.box) / 4;
  return {.even = sides_of(cut.box) - odd < quarter, .odd = odd < quarter};
}

std::optional<std::vector<AreaLine>> close_along_box(const CutLines& cut, const PartsOfBox& parts,
                                                     const PartVotes& votes, std::int64_t least) {
  const PartVotes rings = votes_of_rings(cut, parts), lines_say = votes_of_inner_lines(cut);
  const std::int64_t odd = votes.odd + rings.odd + lines_say.odd, even = votes.even + rings.even + lines_say.even;
  const bool is_odd = odd > even;
  if (std::max(odd, even) < least || !is_clear(std::max(odd, even), std::min(odd, even))) return std::nullopt;
  if (is_odd ? rings.odd < kClearly * rings.even : rings.even < kClearly * rings.odd) return std::nullopt;
  std::vector<AreaLine> lines = openings_of(cut, is_odd);
  for (const AreaLine& line : cut.lines) lines.push_back(led_out(cut.box, line));
  lines = joined_lines(std::move(lines));
  if (!std::ranges::all_of(lines, is_ring)) return std::nullopt;
  for (const AreaLine& ring : cut.rings) lines.push_back({ring.points, is_odd_around(ring, parts) == is_odd});
  return lines;
}

}  // namespace citykiln::source

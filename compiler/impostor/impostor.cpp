#include "compiler/impostor/impostor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "compiler/contract/tolerance.h"

namespace citykiln::impostor {
namespace {

using materials::MaterialMesh;

// Steps of the grid on which corners lie, a sample.
constexpr std::int64_t kSteps = 16;
// What lies farther off would overflow products of two edges.
constexpr double kFarthest = static_cast<double>(kSteps * kSamplesPerSide) * (1 << 20);

struct Point {
  std::int64_t x = 0, y = 0;
};

// What a coat shows.
struct Show {
  std::array<std::uint16_t, 3> light{}, emission{};
  std::uint8_t roughness = 0, metalness = 0;
};

Show show_of(const Appearance& appearance) {
  const materials::MaterialValues& values = values_of(appearance.material);
  const auto byte = [](float share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0f, 1.0f) * 255 + 0.5f); };
  const auto word = [](double share) { return static_cast<std::uint16_t>(std::clamp(share, 0.0, 1.0) * 65535 + 0.5); };
  const auto emission = emission_of(appearance.material);
  Show show{{}, {}, byte(values.roughness), byte(values.metallic)};
  for (std::size_t c = 0; c < show.light.size(); ++c) {
    show.light[c] = word(static_cast<double>(values.base_colour[c]) * appearance.tint[c] / 255);
    show.emission[c] = word(static_cast<double>(emission[c]));
  }
  return show;
}

// What is foremost at a sample.
struct Sample {
  static constexpr std::uint32_t kNothing = 0xffffffffu;
  std::int32_t depth = 0;  // quanta behind the rectangle
  std::uint32_t appearance = kNothing;
};

// A view while it is being filled.
struct Canvas {
  const View& view;
  Vec3 out = cross(view.v, view.u);
  std::int64_t columns = std::int64_t{view.columns} * kSamplesPerSide, rows = std::int64_t{view.rows} * kSamplesPerSide;
  std::vector<Sample> samples = std::vector<Sample>(static_cast<std::size_t>(columns * rows));

  double along(Vec3 axis, Vec3 p) const {
    return dot(p - view.corner, axis) * (static_cast<double>(kSteps * kSamplesPerSide) / view.texel_m);
  }
  std::optional<Point> point_of(Vec3 p) const {
    const double x = along(view.u, p), y = along(view.v, p);
    if (!(std::abs(x) <= kFarthest && std::abs(y) <= kFarthest)) return std::nullopt;
    return Point{static_cast<std::int64_t>(std::floor(x + 0.5)), static_cast<std::int64_t>(std::floor(y + 0.5))};
  }
  double behind_m(Vec3 p) const { return dot(view.corner - p, out); }
};

bool meet(const Box3& a, const Box3& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

Vec3 lower(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 higher(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

Box3 about(const Box3& box, Vec3 p) { return {lower(box.low, p), higher(box.high, p)}; }
Box3 about(const Box3& a, const Box3& b) { return about(about(a, b.low), b.high); }

// The box of all that a view can see.
Box3 reach_of(const Canvas& canvas) {
  const View& view = canvas.view;
  Box3 reach{view.corner, view.corner};
  for (const double u : {0.0, view.columns * view.texel_m})
    for (const double v : {0.0, view.rows * view.texel_m})
      for (const double out : {view.before_m, -view.behind_m})
        reach = about(reach, view.corner + view.u * u + view.v * v + canvas.out * out);
  return reach;
}

// Twice the area of a, b, p: positive where p lies to the right of the edge, as rows go down.
std::int64_t edge(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Of an edge that two triangles share, one has it so and one the other way round.
bool owns(Point a, Point b) { return a.y != b.y ? a.y > b.y : a.x < b.x; }

// Corners in the order in which their edges are positive inside.
struct Flat {
  std::array<Point, 3> at;
  std::array<double, 3> behind_m;
};

std::optional<Flat> flat_of(const Canvas& canvas, const ModelTriangle& facet) {
  const auto a = canvas.point_of(facet.a), b = canvas.point_of(facet.b), c = canvas.point_of(facet.c);
  // what goes counter-clockwise in space goes clockwise where v runs down
  if (!a || !b || !c || edge(*a, *c, *b) <= 0) return std::nullopt;
  return Flat{{*a, *c, *b}, {canvas.behind_m(facet.a), canvas.behind_m(facet.c), canvas.behind_m(facet.b)}};
}

// The samples whose middles lie between two places, ends among them.
struct Span {
  std::int64_t first, end;
  std::size_t size() const { return static_cast<std::size_t>(end - first); }
};
Span span_of(std::int64_t low, std::int64_t high, std::int64_t count) {
  constexpr std::int64_t kHalf = kSteps / 2;
  // shifts round down, also what is negative
  const auto steps_down = [](std::int64_t v) { return v >> std::countr_zero(static_cast<std::uint64_t>(kSteps)); };
  const auto clamped = [&](std::int64_t v) { return std::clamp<std::int64_t>(v, 0, count); };
  return {clamped(steps_down(low - kHalf + kSteps - 1)), clamped(steps_down(high - kHalf) + 1)};
}

// The triangle along a row of samples: the three edges' areas, and how far behind the rectangle it is.
struct Scan {
  std::array<std::int64_t, 3> inside{}, along{}, down{};  ///< Not negative inside; and from one sample to the next.
  double behind_m = 0, along_m = 0, down_m = 0;

  bool is_inside() const { return (inside[0] | inside[1] | inside[2]) >= 0; }
  void move(const std::array<std::int64_t, 3>& way) {
    for (std::size_t i = 0; i < 3; ++i) inside[i] += way[i];
  }
};

// At the middle of a sample.
Scan scan_from(const Flat& flat, std::int64_t column, std::int64_t row) {
  const Point p{column * kSteps + kSteps / 2, row * kSteps + kSteps / 2};
  const double area = static_cast<double>(edge(flat.at[0], flat.at[1], flat.at[2]));
  Scan scan;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = flat.at[(i + 1) % 3], b = flat.at[(i + 2) % 3];
    const double share_m = flat.behind_m[i] / area;
    const std::int64_t weight = edge(a, b, p);
    scan.inside[i] = owns(a, b) ? weight : weight - 1;
    scan.along[i] = (a.y - b.y) * kSteps, scan.down[i] = (b.x - a.x) * kSteps;
    scan.behind_m += static_cast<double>(weight) * share_m;
    scan.along_m += static_cast<double>(scan.along[i]) * share_m;
    scan.down_m += static_cast<double>(scan.down[i]) * share_m;
  }
  return scan;
}

void put(const View& view, double behind_m, std::uint32_t appearance, Sample& sample) {
  if (!(behind_m >= -view.before_m && behind_m <= view.behind_m)) return;
  const auto depth = static_cast<std::int32_t>(std::floor(behind_m / kQuantum_m + 0.5));
  const bool is_foremost = sample.appearance == Sample::kNothing || depth < sample.depth ||
                           (depth == sample.depth && appearance < sample.appearance);
  if (is_foremost) sample = {depth, appearance};
}

// What is convex is left once. @param samples  As many as the scan may meet.
void draw_row(const View& view, Scan scan, std::span<Sample> samples, std::uint32_t appearance) {
  bool entered = false;
  for (std::size_t i = 0; i < samples.size(); ++i, scan.move(scan.along)) {
    if (!scan.is_inside() && entered) return;
    if (!scan.is_inside()) continue;
    entered = true;
    put(view, scan.behind_m + static_cast<double>(i) * scan.along_m, appearance, samples[i]);
  }
}

// Beyond the depth that the view shows; not where rounding may decide.
bool is_out_of_depth(const Canvas& canvas, double least_m, double most_m) {
  return most_m < -canvas.view.before_m - kQuantum_m || least_m > canvas.view.behind_m + kQuantum_m;
}

bool is_out_of_depth(const Canvas& canvas, const ModelTriangle& facet) {
  const auto [low, high] = std::minmax({canvas.behind_m(facet.a), canvas.behind_m(facet.b), canvas.behind_m(facet.c)});
  return is_out_of_depth(canvas, low, high);
}

bool is_out_of_depth(const Canvas& canvas, const Box3& box) {
  const double middle_m = canvas.behind_m((box.low + box.high) * 0.5);
  const Vec3 half = (box.high - box.low) * 0.5, out = canvas.out;
  const double reach_m = std::abs(out.x) * half.x + std::abs(out.y) * half.y + std::abs(out.z) * half.z;
  return is_out_of_depth(canvas, middle_m - reach_m, middle_m + reach_m);
}

void draw(Canvas& canvas, const ModelTriangle& facet) {
  if (is_out_of_depth(canvas, facet)) return;
  const std::optional<Flat> flat = flat_of(canvas, facet);
  if (!flat) return;
  const auto& [a, b, c] = flat->at;
  const Span across = span_of(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), canvas.columns);
  const Span down = span_of(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), canvas.rows);
  Scan scan = scan_from(*flat, across.first, down.first);
  const double first_m = scan.behind_m;
  for (std::int64_t row = down.first; row < down.end; ++row, scan.move(scan.down)) {
    scan.behind_m = first_m + static_cast<double>(row - down.first) * scan.down_m;
    const auto at = static_cast<std::size_t>(row * canvas.columns + across.first);
    draw_row(canvas.view, scan, std::span(canvas.samples).subspan(at, across.size()), facet.appearance);
  }
}

// What of a shape a view shows, of coats that `is_asked_for`.
template <typename Asked>
Canvas drawn(const Model& shape, const View& view, Asked is_asked_for) {
  Canvas canvas{view};
  const Box3 reach = reach_of(canvas);
  for (std::size_t block = 0; block < shape.blocks.size(); ++block) {
    if (!meet(reach, shape.blocks[block]) || is_out_of_depth(canvas, shape.blocks[block])) continue;
    const std::size_t first = block * kTrianglesPerBlock,
                      end = std::min(first + kTrianglesPerBlock, shape.facets.size());
    for (std::size_t i = first; i < end; ++i)
      if (is_asked_for(shape.facets[i].appearance) && meet(reach, shape.facets[i].box)) draw(canvas, shape.facets[i]);
  }
  return canvas;
}

// How far the shape comes forward from one sample to the next, in quanta; nothing where either shows nothing.
std::int64_t rise(const Sample& from, const Sample& to) {
  if (from.appearance == Sample::kNothing || to.appearance == Sample::kNothing) return 0;
  return std::int64_t{from.depth} - to.depth;
}

// Twice the rise through a texel along a line of samples. What is on a border lies halfway between two samples, so half
// of what they rise is this texel's. @param first  The texel's first on the line, which has `count`.
template <typename At>
std::int64_t rise_through(std::int64_t first, std::int64_t count, At at) {
  std::int64_t twice = 0;
  for (std::int64_t i = std::max<std::int64_t>(first, 1);
       i <= std::min<std::int64_t>(first + kSamplesPerSide, count - 1); ++i)
    twice += rise(at(i - 1), at(i)) * (i == first || i == first + kSamplesPerSide ? 1 : 2);
  return twice;
}

std::int16_t slope_of(std::int64_t twice_rise, double texel_m) {
  const double slope = static_cast<double>(twice_rise) * (kQuantum_m / (2 * kSamplesPerSide * kSlopeUnit)) / texel_m;
  return static_cast<std::int16_t>(std::clamp(std::floor(std::abs(slope) + 0.5), 0.0, 32767.0) * (slope < 0 ? -1 : 1));
}

// Along rows and down columns.
std::array<std::int16_t, 2> slopes_of(const Canvas& canvas, std::int64_t column, std::int64_t row) {
  const auto at = [&](std::int64_t x, std::int64_t y) -> const Sample& {
    return canvas.samples[static_cast<std::size_t>(y * canvas.columns + x)];
  };
  const std::int64_t left = column * kSamplesPerSide, top = row * kSamplesPerSide;
  std::int64_t along = 0, down = 0;
  for (std::int64_t i = 0; i < kSamplesPerSide; ++i) {
    along += rise_through(left, canvas.columns, [&](std::int64_t x) -> const Sample& { return at(x, top + i); });
    down += rise_through(top, canvas.rows, [&](std::int64_t y) -> const Sample& { return at(left + i, y); });
  }
  return {slope_of(along, canvas.view.texel_m), slope_of(down, canvas.view.texel_m)};
}

bool shines(const Show& show) { return show.emission != decltype(show.emission){}; }

// All that a view shows, and what of it shines, with nothing else before it; empty where nothing does.
struct Seen {
  Canvas all;
  std::vector<Sample> lamps{};
};

// What shines at a sample that shows `front`.
std::array<std::uint16_t, 3> emission_at(const Seen& seen, std::span<const Show> shows, std::size_t at) {
  const Sample& front = seen.all.samples[at];
  if (seen.lamps.empty() || seen.lamps[at].appearance == Sample::kNothing) return shows[front.appearance].emission;
  constexpr auto kAside = static_cast<std::int32_t>(kMinOccluderGap_m / kQuantum_m);
  const Sample& lamp = seen.lamps[at];
  return shows[lamp.depth - front.depth > kAside ? lamp.appearance : front.appearance].emission;
}

// Samples in a row that show the same, as one texel.
struct Alike {
  Texel texel{};
  std::uint32_t appearance = Sample::kNothing;

  bool takes(std::uint32_t other, const std::array<std::uint16_t, 3>& emission) {
    const bool is_same = texel.shown > 0 && appearance == other && texel.emission == emission;
    texel.shown = static_cast<std::uint8_t>(texel.shown + is_same);
    return is_same;
  }
};

// The mean of a texel's samples. Most texels show one coat, and that is theirs.
Texel texel_of(const Seen& seen, std::span<const Show> shows, std::size_t column, std::size_t row) {
  const Canvas& canvas = seen.all;
  TexelSum sum;
  Alike alike;
  for (std::size_t y = row * kSamplesPerSide; y < (row + 1) * kSamplesPerSide; ++y)
    for (std::size_t x = column * kSamplesPerSide; x < (column + 1) * kSamplesPerSide; ++x) {
      const std::size_t at = y * static_cast<std::size_t>(canvas.columns) + x;
      const std::uint32_t appearance = canvas.samples[at].appearance;
      if (appearance == Sample::kNothing) continue;
      const auto emission = emission_at(seen, shows, at);
      if (alike.takes(appearance, emission)) continue;
      sum.add(alike.texel);
      alike = {{shows[appearance].light, shows[appearance].roughness, shows[appearance].metalness, 1, emission},
               appearance};
    }
  if (alike.texel.shown == kSamplesPerTexel) return alike.texel;
  sum.add(alike.texel);
  return sum.mean(1);
}

Picture picture_of(const Seen& seen, std::span<const Show> shows) {
  const Canvas& canvas = seen.all;
  Picture picture{canvas.view.columns, canvas.view.rows, {}};
  picture.texels.reserve(std::size_t{picture.columns} * picture.rows);
  for (std::size_t row = 0; row < picture.rows; ++row)
    for (std::size_t column = 0; column < picture.columns; ++column)
      picture.texels.push_back(texel_of(seen, shows, column, row));
  if (!canvas.view.has_slopes) return picture;
  for (std::size_t i = 0; i < picture.texels.size(); ++i)
    if (picture.texels[i].shown > 0)
      picture.texels[i].slope = slopes_of(canvas, static_cast<std::int64_t>(i % picture.columns),
                                          static_cast<std::int64_t>(i / picture.columns));
  return picture;
}

void count_coats(const Canvas& canvas, const Model& shape, Impostor& impostor) {
  std::vector<std::uint64_t> counts(shape.appearances.size());
  std::uint64_t all = 0;
  for (const Sample& sample : canvas.samples)
    if (sample.appearance != Sample::kNothing) ++counts[sample.appearance], ++all;
  if (all == 0) return;
  const auto most = std::ranges::max_element(counts);
  impostor.dominant = shape.appearances[static_cast<std::size_t>(most - counts.begin())];
  impostor.dominant_share = static_cast<double>(*most) / static_cast<double>(all);
}

Appearance coat_of(const MaterialMesh& mesh) {
  return {mesh.material, mesh.tints.empty() ? mesh.tint : mesh.tints.front()};
}

}  // namespace

Model model_of(std::span<const MaterialMesh> meshes) {
  Model shape;
  for (const MaterialMesh& mesh : meshes) shape.appearances.push_back(coat_of(mesh));
  std::ranges::sort(shape.appearances);
  shape.appearances.erase(std::unique(shape.appearances.begin(), shape.appearances.end()), shape.appearances.end());
  for (const MaterialMesh& mesh : meshes) {
    const auto appearance = static_cast<std::uint32_t>(std::ranges::lower_bound(shape.appearances, coat_of(mesh)) -
                                                       shape.appearances.begin());
    for (const Triangle& t : mesh.mesh.triangles) {
      const Vec3 a = mesh.mesh.positions[t[0]], b = mesh.mesh.positions[t[1]], c = mesh.mesh.positions[t[2]];
      shape.facets.push_back({a, b, c, about(about({a, a}, b), c), appearance});
    }
  }
  for (std::size_t i = 0; i < shape.facets.size(); ++i) {
    if (i % kTrianglesPerBlock == 0) shape.blocks.push_back(shape.facets[i].box);
    shape.blocks.back() = about(shape.blocks.back(), shape.facets[i].box);
  }
  return shape;
}

Impostor render(const Model& shape, const View& view) {
  std::vector<Show> shows;
  for (const Appearance& appearance : shape.appearances) shows.push_back(show_of(appearance));
  Seen seen{drawn(shape, view, [](std::uint32_t) { return true; })};
  View rooms = view;
  rooms.behind_m = std::min(view.behind_m, kMaxRoomDepth_m);
  if (std::ranges::any_of(shows, shines))
    seen.lamps = drawn(shape, rooms, [&](std::uint32_t appearance) { return shines(shows[appearance]); }).samples;
  Impostor impostor{picture_of(seen, shows), {}, 0};
  count_coats(seen.all, shape, impostor);
  return impostor;
}

}  // namespace citykiln::impostor

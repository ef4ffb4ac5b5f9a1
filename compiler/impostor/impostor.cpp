#include "compiler/impostor/impostor.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/contract/tolerance.h"

namespace citykiln::impostor {
namespace {

using materials::MaterialMesh;
using materials::SurfaceMaterial;

// Vertices are rounded to this many steps per sample.
constexpr std::int64_t kSteps = 16;
// Farther vertices would overflow products of two edges.
constexpr double kMaxSteps = static_cast<double>(kSteps * kSamplesPerSide) * (1 << 20);

struct Point {
  std::int64_t x = 0, y = 0;
};

// A sample is drawn with its surface's index alone and looked up here once at the end.
Texel sample_of(const SurfaceMaterial& surface) {
  Texel sample = texel_of(surface);
  sample.shown = 1;
  return sample;
}

// The nearest surface at a sample. The surface with the lesser key is nearer, or has the lower index.
struct Sample {
  std::uint64_t key = ~std::uint64_t{0};  // depth above surface; all ones where there is nothing

  static Sample of(std::int32_t depth, std::uint32_t surface) {
    return {std::uint64_t{static_cast<std::uint32_t>(depth) ^ kSign} << 32 | surface};
  }
  bool is_empty() const { return key == ~std::uint64_t{0}; }
  std::uint32_t surface() const { return static_cast<std::uint32_t>(key); }
  // Behind the rectangle, in kQuantum_m.
  std::int32_t depth() const { return static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> 32) ^ kSign); }

 private:
  static constexpr std::uint32_t kSign = 0x80000000u;
};

// The z-buffer of a view.
struct Canvas {
  const View& view;
  Vec3 out = cross(view.v, view.u);
  std::int64_t columns = std::int64_t{view.columns} * kSamplesPerSide, rows = std::int64_t{view.rows} * kSamplesPerSide;
  std::vector<Sample> samples = std::vector<Sample>(static_cast<std::size_t>(columns * rows));

  double steps_along(Vec3 axis, Vec3 p) const {
    return dot(p - view.corner, axis) * (static_cast<double>(kSteps * kSamplesPerSide) / view.texel_m);
  }
  std::optional<Point> point_of(Vec3 p) const {
    const double x = steps_along(view.u, p), y = steps_along(view.v, p);
    if (!(std::abs(x) <= kMaxSteps && std::abs(y) <= kMaxSteps)) return std::nullopt;
    return Point{static_cast<std::int64_t>(std::floor(x + 0.5)), static_cast<std::int64_t>(std::floor(y + 0.5))};
  }
  double behind_m(Vec3 p) const { return dot(view.corner - p, out); }
  Sample at(std::int64_t x, std::int64_t y) const { return samples[static_cast<std::size_t>(y * columns + x)]; }
};

bool overlap(const Box3& a, const Box3& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

Vec3 lower(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 higher(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

Box3 united(const Box3& box, Vec3 p) { return {lower(box.low, p), higher(box.high, p)}; }
Box3 united(const Box3& a, const Box3& b) { return united(united(a, b.low), b.high); }

Box3 view_box(const Canvas& canvas) {
  const View& view = canvas.view;
  Box3 box{view.corner, view.corner};
  for (const double u : {0.0, view.columns * view.texel_m})
    for (const double v : {0.0, view.rows * view.texel_m})
      for (const double out : {view.before_m, -view.behind_m})
        box = united(box, view.corner + view.u * u + view.v * v + canvas.out * out);
  return box;
}

// Twice the area of the triangle a, b, p: positive if p lies to the right of the edge in image coordinates (rows down).
std::int64_t edge(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Fill rule: of two triangles that share an edge, one owns the samples on it.
bool owns(Point a, Point b) { return a.y != b.y ? a.y > b.y : a.x < b.x; }

// A triangle in image coordinates. Edge functions are positive inside.
struct Projected {
  std::array<Point, 3> at;
  std::array<double, 3> behind_m;  // of each corner, for a unit of its edge function
};

std::optional<Projected> project(const Canvas& canvas, const ModelTriangle& t) {
  const auto a = canvas.point_of(t.a), b = canvas.point_of(t.b), c = canvas.point_of(t.c);
  // counter-clockwise in space is clockwise in the image, where v points down
  if (!a || !b || !c) return std::nullopt;
  const auto area = static_cast<double>(edge(*a, *c, *b));
  if (area <= 0) return std::nullopt;
  return Projected{{*a, *c, *b},
                   {canvas.behind_m(t.a) / area, canvas.behind_m(t.c) / area, canvas.behind_m(t.b) / area}};
}

// The samples whose centres lie between two coordinates, inclusive.
struct SampleRange {
  std::int64_t first, end;
  std::size_t size() const { return static_cast<std::size_t>(end - first); }
};
SampleRange samples_between(std::int64_t low, std::int64_t high, std::int64_t count) {
  constexpr std::int64_t kHalf = kSteps / 2;
  // an arithmetic shift rounds down for negative values too
  const auto steps_down = [](std::int64_t v) { return v >> std::countr_zero(static_cast<std::uint64_t>(kSteps)); };
  const auto clamped = [&](std::int64_t v) { return std::clamp<std::int64_t>(v, 0, count); };
  return {clamped(steps_down(low - kHalf + kSteps - 1)), clamped(steps_down(high - kHalf) + 1)};
}

// Edge functions and depth of a triangle at one sample, with their increments to the next sample.
struct Scan {
  std::array<std::int64_t, 3> inside{}, along{};
  double behind_m = 0, along_m = 0;

  // The samples of a row of so many that are inside: they follow each other, since a triangle is convex.
  SampleRange row_inside(std::int64_t count) const {
    SampleRange range{0, count};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t value = inside[i], step = along[i];
      if (step > 0 && value < 0) range.first = std::max(range.first, (step - 1 - value) / step);
      if (step < 0) range.end = std::min(range.end, value < 0 ? 0 : value / -step + 1);
      if (step == 0 && value < 0) range.end = 0;
    }
    return range;
  }
};

// Samples of a texel's four rows are moved along the row by these steps, so that upright edges meet 16 columns.
constexpr std::array<std::int64_t, kSamplesPerSide> kRowShift = {-6, 2, -2, 6};

Scan scan_from(const Projected& triangle, std::int64_t column, std::int64_t row) {
  const std::int64_t shift = kRowShift[static_cast<std::size_t>(row) % kSamplesPerSide];
  const Point p{column * kSteps + kSteps / 2 + shift, row * kSteps + kSteps / 2};
  Scan scan;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = triangle.at[(i + 1) % 3], b = triangle.at[(i + 2) % 3];
    const std::int64_t weight = edge(a, b, p);
    scan.inside[i] = owns(a, b) ? weight : weight - 1;
    scan.along[i] = (a.y - b.y) * kSteps;
    scan.behind_m += static_cast<double>(weight) * triangle.behind_m[i];
    scan.along_m += static_cast<double>(scan.along[i]) * triangle.behind_m[i];
  }
  return scan;
}

bool is_in_depth(const View& view, double behind_m) { return behind_m >= -view.before_m && behind_m <= view.behind_m; }

std::int32_t depth_at(double behind_m) { return static_cast<std::int32_t>(std::floor(behind_m / kQuantum_m + 0.5)); }

// Draws samples of which `behind_m(i)` is the depth, a function that only rises or only falls: where its ends agree,
// all do.
template <typename Depth>
void draw_samples(const View& view, std::span<Sample> samples, Depth behind_m, std::uint32_t surface) {
  const auto draw = [&](std::size_t i, Sample sample) { samples[i].key = std::min(samples[i].key, sample.key); };
  const double first_m = behind_m(0), last_m = behind_m(samples.size() - 1);
  if (is_in_depth(view, first_m) && is_in_depth(view, last_m) && depth_at(first_m) == depth_at(last_m)) {
    const Sample sample = Sample::of(depth_at(first_m), surface);
    for (std::size_t i = 0; i < samples.size(); ++i) draw(i, sample);
    return;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (is_in_depth(view, behind_m(i))) draw(i, Sample::of(depth_at(behind_m(i)), surface));
}

void draw_row(const View& view, const Scan& scan, std::span<Sample> samples, std::uint32_t surface) {
  const SampleRange range = scan.row_inside(static_cast<std::int64_t>(samples.size()));
  if (range.first >= range.end) return;
  const auto first = static_cast<std::size_t>(range.first);
  const auto behind_m = [&](std::size_t i) { return scan.behind_m + static_cast<double>(first + i) * scan.along_m; };
  draw_samples(view, samples.subspan(first, range.size()), behind_m, surface);
}

// Depths within a rounding error of the range are left to draw_sample().
bool is_out_of_depth(const Canvas& canvas, double least_m, double most_m) {
  return most_m < -canvas.view.before_m - kQuantum_m || least_m > canvas.view.behind_m + kQuantum_m;
}

bool is_out_of_depth(const Canvas& canvas, const ModelTriangle& t) {
  const auto [low, high] = std::minmax({canvas.behind_m(t.a), canvas.behind_m(t.b), canvas.behind_m(t.c)});
  return is_out_of_depth(canvas, low, high);
}

bool is_out_of_depth(const Canvas& canvas, const Box3& box) {
  const double middle_m = canvas.behind_m((box.low + box.high) * 0.5);
  const Vec3 half = (box.high - box.low) * 0.5, out = canvas.out;
  const double extent_m = std::abs(out.x) * half.x + std::abs(out.y) * half.y + std::abs(out.z) * half.z;
  return is_out_of_depth(canvas, middle_m - extent_m, middle_m + extent_m);
}

void draw_triangle(Canvas& canvas, const ModelTriangle& triangle) {
  if (is_out_of_depth(canvas, triangle)) return;
  const std::optional<Projected> projected = project(canvas, triangle);
  if (!projected) return;
  const auto& [a, b, c] = projected->at;
  const SampleRange across =
      samples_between(std::min({a.x, b.x, c.x}) - kSteps, std::max({a.x, b.x, c.x}) + kSteps, canvas.columns);
  const SampleRange down = samples_between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), canvas.rows);
  if (across.first >= across.end || down.first >= down.end) return;
  for (std::int64_t row = down.first; row < down.end; ++row) {
    const Scan scan = scan_from(*projected, across.first, row);
    const auto at = static_cast<std::size_t>(row * canvas.columns + across.first);
    draw_row(canvas.view, scan, std::span(canvas.samples).subspan(at, across.size()), triangle.surface);
  }
}

// False for back faces, and for triangles that are seen from so far aside that they cover no sample.
bool is_facing(const Canvas& canvas, const ModelTriangle& triangle) {
  constexpr double kGrazing = 1e-4;
  return dot(triangle.normal, canvas.out) > kGrazing;
}

// Draws the triangles of those surfaces that `is_drawn`.
template <typename IsDrawn>
Canvas drawn(const Model& model, const View& view, IsDrawn is_drawn) {
  Canvas canvas{view};
  const Box3 visible = view_box(canvas);
  for (std::size_t block = 0; block < model.blocks.size(); ++block) {
    if (!overlap(visible, model.blocks[block]) || is_out_of_depth(canvas, model.blocks[block])) continue;
    const std::size_t first = block * kTrianglesPerBlock;
    const std::size_t end = std::min(first + kTrianglesPerBlock, model.triangles.size());
    for (std::size_t i = first; i < end; ++i)
      if (is_facing(canvas, model.triangles[i]) && is_drawn(model.triangles[i].surface) &&
          overlap(visible, model.triangles[i].box))
        draw_triangle(canvas, model.triangles[i]);
  }
  return canvas;
}

// The rise towards the viewer from one sample to the next; 0 if either is not covered.
std::int64_t rise(Sample from, Sample to) {
  return from.is_empty() || to.is_empty() ? 0 : std::int64_t{from.depth()} - to.depth();
}

// Twice the rise through a texel along a line of `count` samples, of which `first` is the texel's first. The texel's
// borders lie between two samples, so it has half of the rise there.
template <typename At>
std::int64_t twice_rise(std::int64_t first, std::int64_t count, At at) {
  const std::int64_t begin = std::max<std::int64_t>(first, 1),
                     last = std::min<std::int64_t>(first + kSamplesPerSide, count - 1);
  std::int64_t twice = 0;
  for (std::int64_t i = begin; i <= last; ++i)
    twice += rise(at(i - 1), at(i)) * (i == first || i == first + kSamplesPerSide ? 1 : 2);
  return twice;
}

std::int16_t slope_of(std::int64_t twice_rise, double texel_m) {
  const double slope = static_cast<double>(twice_rise) * (kQuantum_m / (2 * kSamplesPerSide * kSlopeUnit)) / texel_m;
  return static_cast<std::int16_t>(std::clamp(std::floor(std::abs(slope) + 0.5), 0.0, 32767.0) * (slope < 0 ? -1 : 1));
}

// True if all samples of a texel and those around it have one depth, as most have.
bool is_level(const Canvas& canvas, std::int64_t left, std::int64_t top) {
  const Sample first = canvas.at(left, top);
  std::uint64_t differs = 0;
  for (std::int64_t y = std::max<std::int64_t>(top - 1, 0); y <= std::min(top + kSamplesPerSide, canvas.rows - 1); ++y)
    for (std::int64_t x = std::max<std::int64_t>(left - 1, 0);
         x <= std::min<std::int64_t>(left + kSamplesPerSide, canvas.columns - 1); ++x)
      differs |= canvas.at(x, y).key ^ first.key;
  return differs >> 32 == 0;
}

std::array<std::int16_t, 2> slopes_of(const Canvas& canvas, std::int64_t column, std::int64_t row) {
  const std::int64_t left = column * kSamplesPerSide, top = row * kSamplesPerSide;
  if (is_level(canvas, left, top)) return {};
  std::int64_t along = 0, down = 0;
  for (std::int64_t i = 0; i < kSamplesPerSide; ++i) {
    along += twice_rise(left, canvas.columns, [&](std::int64_t x) { return canvas.at(x, top + i); });
    down += twice_rise(top, canvas.rows, [&](std::int64_t y) { return canvas.at(left + i, y); });
  }
  return {slope_of(along, canvas.view.texel_m), slope_of(down, canvas.view.texel_m)};
}

// The z-buffers of all surfaces, and of those that emit light; the latter is empty if none do.
struct Buffers {
  Canvas all;
  std::vector<Sample> sources{};
};

// The emission at a covered sample: that of a light source behind its surface, if it is visible past it.
std::array<std::uint16_t, 3> emission_at(const Buffers& buffers, std::span<const Texel> surfaces, std::size_t at) {
  const Sample front = buffers.all.samples[at];
  if (buffers.sources.empty() || buffers.sources[at].is_empty()) return surfaces[front.surface()].emission;
  constexpr auto kGap = static_cast<std::int32_t>(kMinOccluderGap_m / kQuantum_m);
  const Sample source = buffers.sources[at];
  return surfaces[source.depth() - front.depth() > kGap ? source.surface() : front.surface()].emission;
}

// Calls visit(index) for the samples of a texel, row by row.
template <typename Visit>
void each_sample(const Canvas& canvas, std::size_t column, std::size_t row, Visit visit) {
  const auto columns = static_cast<std::size_t>(canvas.columns);
  for (std::size_t y = row * kSamplesPerSide; y < (row + 1) * kSamplesPerSide; ++y)
    for (std::size_t x = column * kSamplesPerSide; x < (column + 1) * kSamplesPerSide; ++x) visit(y * columns + x);
}

// Whether all samples of a texel show one surface, or nothing, and no light source is behind it: most texels.
bool is_uniform(const Buffers& buffers, std::size_t column, std::size_t row, Sample first) {
  std::uint64_t differs = 0, empty = ~std::uint64_t{0};
  each_sample(buffers.all, column, row, [&](std::size_t at) { differs |= buffers.all.samples[at].key ^ first.key; });
  if (static_cast<std::uint32_t>(differs) != 0) return false;
  if (!buffers.sources.empty())
    each_sample(buffers.all, column, row, [&](std::size_t at) { empty &= buffers.sources[at].key; });
  return Sample{empty}.is_empty();
}

// The mean of a texel's samples.
Texel texel_at(const Buffers& buffers, std::span<const Texel> surfaces, std::size_t column, std::size_t row) {
  const Canvas& canvas = buffers.all;
  const Sample first =
      canvas.at(static_cast<std::int64_t>(column * kSamplesPerSide), static_cast<std::int64_t>(row * kSamplesPerSide));
  if (is_uniform(buffers, column, row, first)) {
    if (first.is_empty()) return {};
    Texel texel = surfaces[first.surface()];
    texel.shown = kSamplesPerTexel;
    return texel;
  }
  TexelSum sum;
  each_sample(canvas, column, row, [&](std::size_t at) {
    if (canvas.samples[at].is_empty()) return;
    Texel texel = surfaces[canvas.samples[at].surface()];
    texel.emission = emission_at(buffers, surfaces, at);
    sum.add(texel);
  });
  return sum.mean(1);
}

Picture picture_of(const Buffers& buffers, std::span<const Texel> surfaces) {
  const View& view = buffers.all.view;
  Picture picture{view.columns, view.rows, {}};
  picture.texels.reserve(std::size_t{picture.columns} * picture.rows);
  for (std::size_t row = 0; row < picture.rows; ++row)
    for (std::size_t column = 0; column < picture.columns; ++column) {
      Texel& texel = picture.texels.emplace_back(texel_at(buffers, surfaces, column, row));
      if (view.has_slopes && texel.shown > 0)
        texel.slope = slopes_of(buffers.all, static_cast<std::int64_t>(column), static_cast<std::int64_t>(row));
    }
  return picture;
}

void find_dominant(const Canvas& canvas, const Model& model, Impostor& impostor) {
  std::vector<std::uint64_t> counts(model.surfaces.size());
  std::uint64_t covered = 0;
  // by runs, which are long
  for (std::size_t at = 0, end = 0; at < canvas.samples.size(); at = end) {
    const std::uint32_t surface = canvas.samples[at].surface();
    while (end < canvas.samples.size() && canvas.samples[end].surface() == surface) ++end;
    if (!canvas.samples[at].is_empty()) counts[surface] += end - at, covered += end - at;
  }
  if (covered == 0) return;
  const auto most = std::ranges::max_element(counts);
  impostor.dominant = model.surfaces[static_cast<std::size_t>(most - counts.begin())];
  impostor.dominant_share = static_cast<double>(*most) / static_cast<double>(covered);
}

SurfaceMaterial surface_of(const MaterialMesh& mesh) {
  return {mesh.material, mesh.tints.empty() ? mesh.tint : mesh.tints.front()};
}

}  // namespace

Texel texel_of(const SurfaceMaterial& surface) {
  const materials::MaterialValues& values = values_of(surface.material);
  const auto byte = [](float share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0f, 1.0f) * 255 + 0.5f); };
  const auto word = [](double share) { return static_cast<std::uint16_t>(std::clamp(share, 0.0, 1.0) * 65535 + 0.5); };
  const auto emission = emission_of(surface.material);
  Texel texel{.roughness = byte(values.roughness), .metalness = byte(values.metallic), .shown = kSamplesPerTexel};
  for (std::size_t c = 0; c < texel.light.size(); ++c) {
    texel.light[c] = word(static_cast<double>(values.base_colour[c]) * surface.tint[c] / 255);
    texel.emission[c] = word(static_cast<double>(emission[c]));
  }
  return texel;
}

Model model_of(std::span<const MaterialMesh> meshes) {
  Model model;
  for (const MaterialMesh& mesh : meshes) model.surfaces.push_back(surface_of(mesh));
  std::ranges::sort(model.surfaces);
  model.surfaces.erase(std::unique(model.surfaces.begin(), model.surfaces.end()), model.surfaces.end());
  for (const MaterialMesh& mesh : meshes) {
    const auto surface =
        static_cast<std::uint32_t>(std::ranges::lower_bound(model.surfaces, surface_of(mesh)) - model.surfaces.begin());
    for (const Triangle& t : mesh.mesh.triangles) {
      const Vec3 a = mesh.mesh.positions[t[0]], b = mesh.mesh.positions[t[1]], c = mesh.mesh.positions[t[2]];
      const Vec3 area = cross(b - a, c - a);
      const Vec3 normal = length(area) > 0 ? unit(area) : Vec3{};
      model.triangles.push_back(
          {.a = a, .b = b, .c = c, .normal = normal, .box = united(united({a, a}, b), c), .surface = surface});
    }
  }
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    if (i % kTrianglesPerBlock == 0) model.blocks.push_back(model.triangles[i].box);
    model.blocks.back() = united(model.blocks.back(), model.triangles[i].box);
  }
  return model;
}

Impostor render(const Model& model, const View& view) {
  assert(view.texel_m > 0 && view.columns > 0 && view.rows > 0);
  std::vector<Texel> surfaces;
  for (const SurfaceMaterial& surface : model.surfaces) surfaces.push_back(sample_of(surface));
  Buffers buffers{drawn(model, view, [](std::uint32_t) { return true; })};
  View rooms = view;
  rooms.behind_m = std::min(view.behind_m, kMaxRoomDepth_m);
  if (std::ranges::any_of(surfaces, [](const Texel& surface) { return emits(surface); }))
    buffers.sources = drawn(model, rooms, [&](std::uint32_t s) { return emits(surfaces[s]); }).samples;
  Impostor impostor{picture_of(buffers, surfaces), {}, 0};
  find_dominant(buffers.all, model, impostor);
  return impostor;
}

}  // namespace citykiln::impostor

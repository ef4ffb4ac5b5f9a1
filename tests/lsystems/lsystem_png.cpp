// Draws the plants of an L-system as lines and flat polygons, in parallel projection from the south.
//   lsystem_png OUT.png FILE [key=value …]
// Keys: size (pixels, 320); yaw and pitch of the view (degrees); steps; seed; columns (number of plants, each with its
// own random numbers); line (least line width in pixels, 1); tolerance (metres: draws the shaded mesh instead); zoom
// (1) and up (height of the zoomed view's centre as a share of the picture, 0.5). Other keys replace values of #define.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "compiler/geometry/mathematics.h"
#include "exporters/gltf/pictures/png.h"
#include "lsystems/mesh/tubes.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/read_rpforest.h"
#include "lsystems/rewriting/turtle.h"

namespace {

using namespace citykiln;
using namespace citykiln::lsystems;

constexpr int kFine = 4;  // samples along a pixel's side

/// A filled outline in the picture plane; `depth` grows away from the viewer.
struct Patch {
  std::vector<Vec2> ring;
  std::vector<Vec2> line;  ///< Or two points, as wide as `width`.
  double width = 0, depth = 0;
  materials::TextureImage::Texel colour{};
};

struct View {
  double cos_yaw = 1, sin_yaw = 0, cos_pitch = 1, sin_pitch = 0;

  Vec3 seen(Vec3 p) const {
    const double x = p.x * cos_yaw + p.y * sin_yaw, y = p.y * cos_yaw - p.x * sin_yaw;
    return {x, p.z * cos_pitch + y * sin_pitch, y * cos_pitch - p.z * sin_pitch};
  }
};

materials::TextureImage::Texel wood(std::int32_t order, std::int32_t colour) {
  const int lighter = std::min(order, 4) * 14 + std::clamp(colour, 0, 6) * 10;
  return {static_cast<std::uint8_t>(std::clamp(86 - lighter / 2, 0, 255)),
          static_cast<std::uint8_t>(std::clamp(62 + lighter, 0, 255)), static_cast<std::uint8_t>(44)};
}

materials::TextureImage::Texel leaf(std::int32_t colour) {
  constexpr materials::TextureImage::Texel kGreens[] = {
      {88, 138, 60}, {104, 150, 66}, {78, 128, 58}, {120, 160, 76}, {96, 142, 52}};
  return kGreens[static_cast<std::size_t>(std::abs(colour)) % 5];
}

std::vector<Patch> patches_of(const Skeleton& skeleton, const View& view, Vec3 at) {
  std::vector<Patch> patches;
  for (const Segment& segment : skeleton.segments) {
    const Vec3 a = view.seen(at + segment.start.at), b = view.seen(at + segment.end().at);
    patches.push_back({{},
                       {{a.x, a.y}, {b.x, b.y}},
                       segment.start_radius + segment.end_radius,
                       (a.z + b.z) / 2,
                       wood(segment.order, segment.colour)});
  }
  for (const FlatPolygon& polygon : skeleton.polygons) {
    Patch patch;
    for (std::uint32_t i = 0; i < polygon.count; ++i) {
      const Vec3 p = view.seen(at + skeleton.vertices[polygon.first + i]);
      patch.ring.push_back({p.x, p.y});
      patch.depth += p.z / polygon.count;
    }
    patch.colour = leaf(polygon.colour);
    patches.push_back(patch);
  }
  for (const Instance& instance : skeleton.instances) {
    const TurtleFrame& f = instance.frame;
    Patch patch;
    for (const Vec2 corner : {Vec2{0, 0}, {0.3, 0.4}, {0, 1}, {-0.3, 0.4}}) {
      const Vec3 p = view.seen(at + f.at + (f.left * corner.x + f.heading * corner.y) * instance.size);
      patch.ring.push_back({p.x, p.y});
      patch.depth = p.z;
    }
    patch.colour = leaf(instance.colour);
    patches.push_back(patch);
  }
  return patches;
}

struct Canvas {
  int width = 0, height = 0;  // samples
  std::vector<materials::TextureImage::Texel> samples;

  // even-odd rule
  void fill(const std::vector<Vec2>& ring, materials::TextureImage::Texel colour) {
    double low = ring[0].y, high = ring[0].y;
    for (const Vec2 p : ring) low = std::min(low, p.y), high = std::max(high, p.y);
    std::vector<double> crossings;
    for (int y = std::max(0, static_cast<int>(low - 0.5)); y < std::min<double>(height, high + 0.5); ++y) {
      crossings.clear();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.y <= y + 0.5) != (b.y <= y + 0.5))
          crossings.push_back(a.x + (b.x - a.x) * (y + 0.5 - a.y) / (b.y - a.y));
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        for (int x = std::max(0, static_cast<int>(crossings[i] + 0.5));
             x < std::min<double>(width, crossings[i + 1] - 0.5 + 1e-9) + 0; ++x)
          samples[static_cast<std::size_t>(y) * width + x] = colour;
    }
  }
};

materials::TextureImage pixels_of(const Canvas& canvas) {
  materials::TextureImage sheet;
  sheet.columns = static_cast<std::uint32_t>(canvas.width / kFine);
  sheet.rows = static_cast<std::uint32_t>(canvas.height / kFine);
  for (std::uint32_t y = 0; y < sheet.rows; ++y)
    for (std::uint32_t x = 0; x < sheet.columns; ++x) {
      int sum[3] = {0, 0, 0};
      for (int i = 0; i < kFine * kFine; ++i)
        for (int c = 0; c < 3; ++c)
          sum[c] +=
              canvas.samples[static_cast<std::size_t>(y * kFine + i / kFine) * canvas.width + x * kFine + i % kFine][c];
      const auto mean = [&](int c) { return static_cast<std::uint8_t>(sum[c] / (kFine * kFine)); };
      sheet.texels.push_back({mean(0), mean(1), mean(2)});
    }
  return sheet;
}

materials::TextureImage drawn(std::vector<Patch> patches, int size_px, double least_px) {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Patch& patch : patches)
    for (const auto* points : {&patch.ring, &patch.line})
      for (const Vec2 p : *points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
  const double extent = std::max({high.x - low.x, high.y - low.y, 1e-9});
  const int size = size_px * kFine;
  const double scale = size * 0.94 / extent;
  Canvas canvas{size, size, {}};
  canvas.samples.assign(static_cast<std::size_t>(canvas.width) * canvas.height, {250, 249, 245});
  const Vec2 middle = (low + high) * 0.5;
  const auto at = [&](Vec2 p) {
    return Vec2{(p.x - middle.x) * scale + canvas.width / 2.0, canvas.height / 2.0 - (p.y - middle.y) * scale};
  };
  std::stable_sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.depth > b.depth; });
  for (const Patch& patch : patches) {
    std::vector<Vec2> ring;
    for (const Vec2 p : patch.ring) ring.push_back(at(p));
    if (patch.line.size() == 2) {
      const Vec2 a = at(patch.line[0]), b = at(patch.line[1]);
      const double half = std::max(least_px * kFine, patch.width * scale) / 2;
      const Vec2 along = unit(b - a) * std::min(half, 1.0 * kFine), side = left_of(unit(b - a)) * half;
      ring = {a - along * 0.3 + side, a - along * 0.3 - side, b + along * 0.3 - side, b + along * 0.3 + side};
    }
    if (ring.size() >= 3) canvas.fill(ring, patch.colour);
  }
  return pixels_of(canvas);
}

/// A z-buffer of triangles lit from the upper left, behind the viewer.
struct Shaded {
  Canvas canvas;
  std::vector<double> depths;

  void fill(const std::array<Vec3, 3>& p, const std::array<double, 3>& light, materials::TextureImage::Texel colour) {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area == 0) return;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int y = std::max(0, static_cast<int>(low)); y < std::min<double>(canvas.height, high + 1); ++y)
      for (int x = std::max(0, static_cast<int>(left)); x < std::min<double>(canvas.width, right + 1); ++x) {
        const double b = ((x + 0.5 - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (y + 0.5 - p[0].y)) / area;
        const double c = ((p[1].x - p[0].x) * (y + 0.5 - p[0].y) - (x + 0.5 - p[0].x) * (p[1].y - p[0].y)) / area;
        if (b < 0 || c < 0 || b + c > 1) continue;
        const std::size_t at = static_cast<std::size_t>(y) * canvas.width + x;
        const double depth = p[0].z * (1 - b - c) + p[1].z * b + p[2].z * c;
        if (depth >= depths[at]) continue;
        depths[at] = depth;
        const double lit = light[0] * (1 - b - c) + light[1] * b + light[2] * c;
        for (int i = 0; i < 3; ++i)
          canvas.samples[at][i] = static_cast<std::uint8_t>(std::clamp(colour[i] * lit, 0.0, 255.0));
      }
  }
};

// Renders a mesh, kFine² samples a pixel.
materials::TextureImage shaded(const PlantMesh& mesh, const View& view, int size_px, double zoom, double up) {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const PartMesh* part : {&mesh.bark, &mesh.leaf})
    for (const Vec3 position : part->positions) {
      const Vec3 p = view.seen(position);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const int size = size_px * kFine;
  const double scale = size * 0.94 / std::max({high.x - low.x, high.y - low.y, 1e-9}) * zoom;
  const double middle_x = zoom > 1 ? 0 : (low.x + high.x) / 2, middle_y = low.y + (high.y - low.y) * up;
  Shaded picture{{size, size, {}}, {}};
  picture.canvas.samples.assign(static_cast<std::size_t>(size) * size, {250, 249, 245});
  picture.depths.assign(picture.canvas.samples.size(), 1e300);
  const Vec3 sun = unit(Vec3{-0.6, 0.7, -0.7});
  for (const PartMesh* part : {&mesh.bark, &mesh.leaf})
    for (const Triangle& t : part->triangles) {
      std::array<Vec3, 3> p;
      std::array<double, 3> light;
      for (int i = 0; i < 3; ++i) {
        const Vec3 seen = view.seen(part->positions[t[i]]);
        p[i] = {(seen.x - middle_x) * scale + size / 2.0, size / 2.0 - (seen.y - middle_y) * scale, seen.z};
        const double facing = dot(view.seen(part->normals[t[i]]), sun);
        light[i] = part == &mesh.leaf ? 0.6 + 0.5 * std::abs(facing) : 0.35 + 0.95 * std::max(0.0, facing);
      }
      picture.fill(p, light,
                   part == &mesh.leaf ? materials::TextureImage::Texel{104, 150, 66}
                                      : materials::TextureImage::Texel{168, 142, 116});
    }
  return pixels_of(picture.canvas);
}

void write_png(const char* path, const materials::TextureImage& sheet) {
  const std::vector<std::byte> bytes = exporters::encode_png(sheet);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

double number_of(std::map<std::string, double, std::less<>>& words, const char* key, double otherwise) {
  const auto found = words.extract(key);
  return found.empty() ? otherwise : found.mapped();
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) return std::puts("lsystem_png OUT.png FILE [key=value …]"), 2;
  std::map<std::string, double, std::less<>> given;
  for (int i = 3; i < count; ++i) {
    const std::string word = words[i];
    given[word.substr(0, word.find('='))] = std::stod(word.substr(word.find('=') + 1));
  }
  const double yaw = number_of(given, "yaw", 0), pitch = number_of(given, "pitch", 0),
               columns = number_of(given, "columns", 1);
  const double size = number_of(given, "size", 320), line = number_of(given, "line", 1);
  const double steps = number_of(given, "steps", -1), seed = number_of(given, "seed", 0);
  const double tolerance = number_of(given, "tolerance", -1), zoom = number_of(given, "zoom", 1),
               up = number_of(given, "up", 0.5);
  std::ifstream in(words[2]);
  std::ostringstream text;
  text << in.rdbuf();
  const Result<LSystem> system = is_rpforest(text.str(), words[2]) ? read_rpforest(text.str(), words[2])
                                                                   : read_lsystem(text.str(), words[2], given);
  if (!system) return std::puts(to_string(system.error()).c_str()), 1;
  const View view{cosine(yaw), sine(yaw), cosine(pitch), sine(pitch)};
  std::vector<Patch> patches;
  Vec3 at;
  for (int i = 0; i < columns; ++i) {
    DeriveOptions options;
    if (steps >= 0) options.steps = static_cast<int>(steps);
    options.seed = static_cast<std::uint64_t>(seed);
    options.plant = StableId{static_cast<std::uint64_t>(i)};
    const Plant plant = grow(*system, options);
    if (tolerance >= 0) {
      TubeOptions tubes;
      tubes.tolerance_m = tolerance;
      const PlantMesh mesh = mesh_plant(plant.skeleton, tubes);
      std::puts(fmt::format(
                    "{} segments, {} triangles of bark, {} of leaves, {} joints, {} unjoined, {} left out, error {} m",
                    plant.skeleton.segments.size(), mesh.bark.triangles.size(), mesh.leaf.triangles.size(), mesh.joints,
                    mesh.separate_stems, mesh.left_out, mesh.error_m)
                    .c_str());
      write_png(words[1], shaded(mesh, view, static_cast<int>(size), zoom, up));
      return 0;
    }
    double west = 0, east = 0;
    for (const Segment& s : plant.skeleton.segments) {
      west = std::min({west, s.start.at.x, s.end().at.x});
      east = std::max({east, s.start.at.x, s.end().at.x});
    }
    if (i > 0) at.x -= west * 1.1;
    const std::vector<Patch> more = patches_of(plant.skeleton, view, at);
    patches.insert(patches.end(), more.begin(), more.end());
    at.x += east * 1.1;
    for (const Warning& warning : plant.derivation.warnings) std::puts(warning_line(*system, warning).c_str());
    for (const Warning& warning : plant.skeleton.warnings) std::puts(warning_line(*system, warning).c_str());
    if (plant.derivation.limit_exceeded) std::puts(limit_line(*system, *plant.derivation.limit_exceeded).c_str());
    std::puts(fmt::format("{} modules, {} segments, {} polygons, {} instances", plant.derivation.string.kinds.size(),
                          plant.skeleton.segments.size(), plant.skeleton.polygons.size(),
                          plant.skeleton.instances.size())
                  .c_str());
  }
  if (patches.empty()) return std::puts("nothing to draw"), 1;
  write_png(words[1], drawn(std::move(patches), static_cast<int>(size), line));
}

#include "preview/scene/face_rectangles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace citykiln::preview {
namespace {

// Vertices in sets that grow together (Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", 1975).
class VertexSets {
 public:
  explicit VertexSets(std::size_t vertices) : parent_(vertices) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t first(std::uint32_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = first(a), b = first(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Uvs lie on a grid of eighths of a texel, but for rounding and what is snapped to it.
constexpr double kOff_texels = 1.0 / 16;

TexelRectangle rectangle_of(const Box2& uvs, const materials::TextureImage& image) {
  const auto texel = [&](double at, std::uint32_t side) {
    return static_cast<std::uint16_t>(std::clamp(std::floor(at), 0.0, side - 1.0));
  };
  const auto low = [&](double at_m) { return at_m / image.texel_m + kOff_texels; };
  const auto high = [&](double at_m) { return at_m / image.texel_m - kOff_texels; };
  TexelRectangle of{texel(low(uvs.min.x), image.columns), texel(low(uvs.min.y), image.rows),
                    texel(high(uvs.max.x), image.columns), texel(high(uvs.max.y), image.rows)};
  of.right = std::max(of.left, of.right), of.bottom = std::max(of.top, of.bottom);
  return of;
}

}  // namespace

std::vector<TexelRectangle> face_rectangles(const bake::Primitive& primitive, const materials::TextureImage& image) {
  assert(primitive.uvs.size() == primitive.positions.size() && image.columns > 0 && image.rows > 0);
  VertexSets faces(primitive.uvs.size());
  for (const auto& [a, b, c] : primitive.triangles) faces.join(a, b), faces.join(b, c);
  std::vector<Box2> boxes(primitive.uvs.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) boxes[faces.first(i)].grow(bake::widened(primitive.uvs[i]));
  std::vector<TexelRectangle> rectangles;
  rectangles.reserve(primitive.triangles.size());
  for (const auto& triangle : primitive.triangles)
    rectangles.push_back(rectangle_of(boxes[faces.first(triangle[0])], image));
  return rectangles;
}

}  // namespace citykiln::preview

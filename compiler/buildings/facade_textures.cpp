#include "compiler/buildings/facade_textures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "compiler/buildings/facade_rows.h"
#include "compiler/buildings/meshes/terminal_meshes.h"
#include "compiler/buildings/styles/paint_colour.h"
#include "compiler/contract/detail_tolerances.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using impostor::Impostor;
using impostor::View;
using materials::Material;
using materials::MaterialMesh;
using materials::SurfaceMaterial;

// Balconies and bays stand out this far.
constexpr double kMaxProjection_m = 2;

// Textures contain the colour; the material under them only says how the surface scatters light where viewers ignore
// the roughness texture.
constexpr Material kUnderTextures = Material::kPaint;

// Lengths exceed whole texels by rounding errors.
std::uint32_t texels_in(double length_m, double texel_m) {
  return static_cast<std::uint32_t>(std::clamp(std::ceil(length_m / texel_m - 1e-6), 1.0, 1e6));
}

// The bounding rectangle of a face in its plane, seen from outside: columns along its lower edge, rows downwards.
View view_of(const Face& face, double texel_m) {
  const std::array<Vec3, 3> axis = grammars::axes_of(face);
  const Vec3 first = face.outer.front(), u = axis[0], v = axis[1] * -1;
  Box2 box;
  box.grow({0, 0});
  each_vertex(face, [&](Vec3 p) { box.grow({dot(p - first, u), dot(p - first, v)}); });
  return {.corner = first + u * box.min.x + v * box.min.y,
          .u = u,
          .v = v,
          .texel_m = texel_m,
          .columns = texels_in(box.width(), texel_m),
          .rows = texels_in(box.height(), texel_m),
          .before_m = std::min(texel_m, kMaxProjection_m),
          .behind_m = texel_m};
}

// The share of a face that one material has to cover for the face to take it. On most roofs the only other material is
// the top of a parapet.
double uniform_share(const View& view) {
  constexpr double kVertical = 0.7, kOfRoof = 0.95;
  return std::abs(view.v.z) > kVertical ? 1 : kOfRoof;
}

// A face has the material that covers at least this share of it: a wall with windows would otherwise become glass of
// any colour.
constexpr double kDominant = 0.75;

// True if a wall has windows of its own, such as arched ones, which are no elements: parts much smoother than itself.
bool shows_panes(const Impostor& impostor) {
  constexpr int kSmoother = 60;
  const int wall = impostor::texel_of(impostor.dominant).roughness;
  return std::ranges::any_of(impostor.picture.texels, [&](const impostor::Texel& texel) {
    return texel.shown > 0 && texel.roughness < wall - kSmoother;
  });
}

// The mean colour as a tint of the dominant material, if there is one.
SurfaceMaterial mean_material(const Impostor& impostor) {
  const impostor::Texel texel = mean(impostor.picture);
  const LinearRgb paint{texel.light[0] / 65535.0, texel.light[1] / 65535.0, texel.light[2] / 65535.0};
  const Material most = impostor.dominant_share >= kDominant ? impostor.dominant.material : Material::kPlaster;
  const Material material = tintable_material(paint, {most, Material::kPaint});
  return {material, tint_towards(material, paint)};
}

// Renders with smaller texels and averages them.
Impostor render_supersampled(const impostor::Model& model, View view) {
  const std::uint32_t halvings = halvings_for(view);
  view.texel_m /= 1u << halvings, view.columns <<= halvings, view.rows <<= halvings;
  Impostor impostor = impostor::render(model, view);
  for (std::uint32_t i = 0; i < halvings; ++i) impostor.picture = halved(impostor.picture);
  return impostor;
}

double covered_share(const Impostor& impostor, const View& view, const Face& face) {
  std::uint64_t samples = 0;
  for (const impostor::Texel& texel : impostor.picture.texels) samples += texel.shown;
  const double sample_m2 = view.texel_m * view.texel_m / impostor::kSamplesPerTexel;
  return static_cast<double>(samples) * sample_m2 / std::max(area_m2(face), sample_m2);
}

// A face covered to less than this is a railing.
constexpr double kMaxRailingShare = 0.5;

bool is_rectangle(const Face& face) {
  const auto& p = face.outer;
  if (p.size() != 4 || !face.holes.empty()) return false;
  const bool is_parallelogram = length(p[0] - p[1] + p[2] - p[3]) < 0.01;
  return is_parallelogram && std::abs(dot(unit(p[1] - p[0]), unit(p[2] - p[1]))) < 0.01;
}

// Two rails along the longer sides of a rectangle, which have a share of its area; and half the gap between them.
struct Rails {
  std::array<Face, 2> faces;
  double error_m = 0;
};

Rails rails_of(const Face& face, double share) {
  const auto& p = face.outer;
  const std::size_t i = length(p[1] - p[0]) >= length(p[2] - p[1]) ? 0 : 1;
  const Vec3 a = p[i], b = p[i + 1], across = p[(i + 3) % 4] - a, width = across * (share / 2);
  Rails rails;
  rails.faces[0].outer = {a, b, b + width, a + width};
  rails.faces[1].outer = {a + across - width, b + across - width, b + across, a + across};
  rails.error_m = length(across) * (1 - share) / 2;
  return rails;
}

// The texels of all pictures, where equal ones count once (impostor/atlas.h).
std::uint64_t distinct_texels(std::span<const TexturedFace> faces) {
  const auto is_less = [](const impostor::PackedPicture* a, const impostor::PackedPicture* b) { return *a < *b; };
  std::set<const impostor::PackedPicture*, decltype(is_less)> pictures(is_less);
  std::uint64_t texels = 0;
  for (const TexturedFace& face : faces)
    if (pictures.insert(face.picture.get()).second) texels += std::uint64_t{face.picture->columns} * face.picture->rows;
  return texels;
}

// State while the faces of a derivation are converted.
struct FacadeBuilder {
  const impostor::Model& detailed;
  double texel_m, tolerance_m;
  OsmId feature;
  bool has_rows = false;
  FacadeMeshes result{};
  std::map<SurfaceMaterial, std::vector<DerivedFace>> uniform{};
  std::vector<TexturedFace> textured{};
  std::vector<DerivedFace> textured_parts{};  // the faces of `textured`

  void add_uniform(const Face& face, const SurfaceMaterial& surface) { uniform[surface].push_back({face, 0}); }

  void add_textured(const Face& face, impostor::Picture&& picture) {
    textured.push_back(textured_face(face, std::move(picture)));
    textured_parts.push_back({face, 0});
  }

  TexturedFace textured_face(const Face& face, impostor::Picture&& picture) const {
    const View view = view_of(face, texel_m);
    fill_gaps(picture);
    TexturedFace made = textured_by(impostor::shared(picture), feature);
    add_face(face, made.mesh.mesh);
    for (const Vec3 p : made.mesh.mesh.positions)
      made.mesh.uvs.push_back({dot(p - view.corner, view.u), dot(p - view.corner, view.v)});
    return made;
  }

  // Joined faces take fewer triangles, but parts with equal pictures share one of them. Only faces that are new are
  // rendered: the others stand in the order in which they were added.
  void join_textured() {
    const std::vector<DerivedFace> faces = join_rectangles(textured_parts);
    if (faces.size() == textured.size() || texels_of(faces) > distinct_texels(textured)) return;
    std::vector<TexturedFace> joined;
    auto part = textured_parts.begin();
    for (const auto& [face, distance_m] : faces) {
      const auto same = std::find_if(part, textured_parts.end(),
                                     [&, &outer = face.outer](const auto& p) { return p.face.outer == outer; });
      if (same == textured_parts.end()) {
        joined.push_back(textured_face(face, render_supersampled(detailed, view_of(face, texel_m)).picture));
      } else {
        joined.push_back(std::move(textured[static_cast<std::size_t>(same - textured_parts.begin())]));
        part = same + 1;
      }
    }
    textured = std::move(joined);
  }

  std::uint64_t texels_of(std::span<const DerivedFace> faces) const {
    std::uint64_t texels = 0;
    for (const DerivedFace& derived : faces) {
      const View view = view_of(derived.face, texel_m);
      texels += std::uint64_t{view.columns} * view.rows;
    }
    return texels;
  }

  // Rails with the area of the railing's bars hide as much of what is behind them. Returns false if the face is no
  // railing, or its rails would be farther off than the tolerance.
  bool add_rails(const Face& face, const SurfaceMaterial& own, double share, double terminal_error_m) {
    if (share > kMaxRailingShare || !is_rectangle(face)) return false;
    const Rails rails = rails_of(face, share);
    const double error_m = terminal_error_m + rails.error_m;
    if (error_m > tolerance_m) return false;
    for (const Face& rail : rails.faces) add_uniform(rail, own);
    result.error_m = std::max(result.error_m, error_m);
    return true;
  }

  // True if one surface stands for the face: it has most of it, or the face is too small for texels.
  bool is_plain(const Impostor& impostor, const View& view) const {
    if (has_rows && impostor.dominant_share >= kDominant && !shows_panes(impostor)) return true;
    const bool is_small = view.columns * view.rows < kMinTexels || std::min(view.columns, view.rows) == 1;
    return is_small && !emits(mean(impostor.picture));
  }

  // Returns the colour that the face has, or its mean colour.
  impostor::Texel add(const Face& face, const SurfaceMaterial& own, double terminal_error_m) {
    const auto one = [&](const SurfaceMaterial& surface) {
      add_uniform(face, surface);
      return impostor::texel_of(surface);
    };
    if (face.outer.size() < 3) return {};
    const View view = view_of(face, texel_m);
    if (std::uint64_t{view.columns} * view.rows > kMaxTexelsPerFace) return one(own);
    Impostor impostor = render_supersampled(detailed, view);
    if (impostor.dominant_share == 0) return one(own);
    if (add_rails(face, own, covered_share(impostor, view, face), terminal_error_m)) return impostor::texel_of(own);
    if (impostor.dominant_share >= uniform_share(view)) return one(impostor.dominant);
    if (is_plain(impostor, view)) return one(mean_material(impostor));
    const impostor::Texel colour = mean(impostor.picture);
    add_textured(face, std::move(impostor.picture));
    return colour;
  }

  // Faces are joined when all are known. Faces of one colour stay apart from textured ones, whose
  // pictures would grow.
  FacadeMeshes finish() && {
    join_textured();
    for (TexturedFace& face : textured)
      if (!face.mesh.mesh.triangles.empty()) result.textured_faces.push_back(std::move(face));
    for (auto& [surface, faces] : uniform) {
      MaterialMesh mesh{{}, surface.material, surface.tint, feature};
      for (const DerivedFace& derived : join_rectangles(std::move(faces))) add_face(derived.face, mesh.mesh);
      if (!mesh.mesh.triangles.empty()) result.meshes.push_back(std::move(mesh));
    }
    return std::move(result);
  }
};

struct RowOptions {
  double texel_m, tolerance_m;
  OsmId feature;
};

// Adds the rows of windows on faces of given colours. No row is moved farther than the tolerance.
void add_rows(std::span<const Face> faces, std::span<const impostor::Texel> colours,
              std::span<const PlacedElement> elements, const RowOptions& options, FacadeMeshes& made) {
  const RowSizes sizes = row_sizes(options.texel_m);
  const double reach_m = options.tolerance_m - sizes.before_m - kDetailedModel_m;
  std::vector<std::vector<ElementOnWall>> on_faces = elements_on(faces, elements, reach_m);
  std::vector<WallWithElements> walls;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!on_faces[i].empty()) {
      const std::array<Vec3, 3> axis = grammars::axes_of(faces[i]);
      walls.push_back({{faces[i].outer.front(), axis[0], axis[1], axis[2]}, colours[i], std::move(on_faces[i])});
      for (const ElementOnWall& element : walls.back().elements)
        made.error_m = std::max(made.error_m, element.moved_m + sizes.before_m + kDetailedModel_m);
    }
  for (TexturedFace& row : rows_of(walls, sizes, options.feature)) made.textured_faces.push_back(std::move(row));
}

}  // namespace

TexturedFace textured_by(impostor::SharedPicture picture, OsmId feature) {
  TexturedFace face{std::move(picture), {{}, kUnderTextures, materials::kNoTint, feature}};
  face.mesh.colour_source = materials::ColourSource::kByAtlas;
  return face;
}

std::uint32_t halvings_for(const View& view) {
  constexpr double kMaxSampleSpacing_m = 0.4;
  std::uint64_t texels = std::uint64_t{view.columns} * view.rows * 4;
  double texel_m = view.texel_m;
  std::uint32_t halvings = 0;
  for (; texel_m > kMaxSampleSpacing_m * impostor::kSamplesPerSide && texels <= kMaxTexelsPerFace; ++halvings)
    texel_m /= 2, texels *= 4;
  return halvings;
}

FacadeMeshes texture_facades(const grammars::Derivation& derivation, const DetailedFacades& detailed, double texel_m,
                             double tolerance_m, OsmId feature) {
  assert(texel_m > 0 && tolerance_m >= 0);
  const bool is_without_elements = has_detail(Detail::kFacadeRows, texel_m);
  const bool has_rows = is_without_elements && !detailed.elements.empty();
  FacadeBuilder builder{is_without_elements ? detailed.walls : detailed.whole, texel_m, tolerance_m, feature, has_rows};
  const std::vector<SurfaceMaterial> surfaces = surfaces_of(derivation);
  std::vector<Face> faces;
  std::vector<impostor::Texel> colours;
  for (const grammars::Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) {
      faces.push_back(face);
      colours.push_back(builder.add(face, surfaces[terminal.appearance], terminal.detail_distance_m));
    }
  FacadeMeshes made = std::move(builder).finish();
  if (has_rows) add_rows(faces, colours, detailed.elements, {texel_m, tolerance_m, feature}, made);
  return made;
}

}  // namespace citykiln::buildings

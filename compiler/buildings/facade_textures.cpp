#include "compiler/buildings/facade_textures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "compiler/buildings/paint_colour.h"
#include "compiler/buildings/terminal_meshes.h"
#include "compiler/contract/detail_tolerances.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using impostor::Appearance;
using impostor::Impostor;
using impostor::View;
using materials::Material;
using materials::MaterialMesh;

// Balconies and bays stand out so far.
constexpr double kStandsOut_m = 2;

// Pictures have all colours: the material under them says only what the rest is like that no picture tells.
constexpr Material kUnderPictures = Material::kPaint;

// A little less than a texel more is rounding.
std::uint32_t texels_in(double length_m, double texel_m) {
  return static_cast<std::uint32_t>(std::clamp(std::ceil(length_m / texel_m - 1e-6), 1.0, 1e6));
}

// The face's box in its own plane, as one stands before it: columns along its foot, rows down.
View view_of(const Face& face, double texel_m) {
  const std::array<Vec3, 3> axis = grammars::axes_of(face);
  View view;
  view.u = axis[0], view.v = axis[1] * -1, view.texel_m = texel_m;
  view.before_m = std::min(texel_m, kStandsOut_m), view.behind_m = texel_m;
  view.has_slopes = has_detail(Detail::kFacadeNormals, texel_m);
  const Vec3 first = face.outer.front();
  Vec2 low{}, high{};
  each_vertex(face, [&](Vec3 p) {
    const Vec2 at{dot(p - first, view.u), dot(p - first, view.v)};
    low = {std::min(low.x, at.x), std::min(low.y, at.y)}, high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  });
  view.corner = first + view.u * low.x + view.v * low.y;
  view.columns = texels_in(high.x - low.x, texel_m), view.rows = texels_in(high.y - low.y, texel_m);
  return view;
}

// Of what shows as plain. Roofs are large, and on most the only other thing is the top of a parapet.
double plain_share(const View& view) {
  constexpr double kUpright = 0.7, kOfRoof = 0.95;
  return std::abs(view.v.z) > kUpright ? 1 : kOfRoof;
}

// The mean colour as paint on what most of it is made of. Glass, which stays glass whatever its colour, has to be
// nearly all: of a wall with windows it would make a hole.
Appearance mean_coat(const Impostor& impostor) {
  constexpr double kNearlyAll = 0.75;
  const impostor::Texel texel = mean(impostor.picture);
  const LinearRgb paint{texel.light[0] / 65535.0, texel.light[1] / 65535.0, texel.light[2] / 65535.0};
  const Material most = impostor.dominant_share >= kNearlyAll ? impostor.dominant.material : Material::kPlaster;
  const Material shown = tintable_material(paint, {most, Material::kPaint});
  return {shown, tint_towards(shown, paint)};
}

// Samples no farther apart than this: windows that stand in rows would else be counted by where they happen to stand.
constexpr double kSamplesApart_m = 0.2;

// As seen in texels that are halves of halves, and made of them.
Impostor finely_seen(const impostor::Model& looks, View view) {
  std::uint32_t times = 0;
  for (; view.texel_m > kSamplesApart_m * impostor::kSamplesPerSide; ++times)
    view.texel_m /= 2, view.columns *= 2, view.rows *= 2;
  Impostor seen = impostor::render(looks, view);
  for (; times > 0; --times) seen.picture = halved(seen.picture);
  return seen;
}

// Of the face, what has something before it or near behind it.
double shown_share(const Impostor& seen, const View& view, const Face& face) {
  std::uint64_t samples = 0;
  for (const impostor::Texel& texel : seen.picture.texels) samples += texel.shown;
  const double sample_m2 = view.texel_m * view.texel_m / impostor::kSamplesPerTexel;
  return static_cast<double>(samples) * sample_m2 / std::max(area_m2(face), sample_m2);
}

// Less than this of a face is there: it is a railing, mostly holes, and as a face it would be a box.
constexpr double kMostlyHoles = 0.5;

bool is_rectangle(const Face& face) {
  const auto& p = face.outer;
  if (p.size() != 4 || !face.holes.empty()) return false;
  const bool is_parallelogram = length(p[0] - p[1] + p[2] - p[3]) < 0.01;
  return is_parallelogram && std::abs(dot(unit(p[1] - p[0]), unit(p[2] - p[1]))) < 0.01;
}

// Two rails of it, along its longer sides, and how far what lay between them is from them.
struct Rails {
  std::array<Face, 2> faces;
  double gap_m = 0;
};

Rails rails_of(const Face& face, double share) {
  const auto& p = face.outer;
  const std::size_t i = length(p[1] - p[0]) >= length(p[2] - p[1]) ? 0 : 1;
  const Vec3 a = p[i], b = p[i + 1], across = p[(i + 3) % 4] - a, deep = across * (share / 2);
  Rails rails;
  rails.faces[0].outer = {a, b, b + deep, a + deep};
  rails.faces[1].outer = {a + across - deep, b + across - deep, b + across, a + across};
  rails.gap_m = length(across) * (1 - share) / 2;
  return rails;
}

bool shines(const impostor::Picture& picture) { return mean(picture).emission != std::array<std::uint16_t, 3>{}; }

// Faces on their way to meshes.
struct Dressing {
  const impostor::Model& looks;
  double texel_m, tolerance_m;
  OsmId feature;
  FacadeMeshes dressed{};
  std::map<Appearance, MaterialMesh> plain{};

  void add_plain(const Face& face, const Appearance& appearance) {
    const auto [place, is_new] = plain.try_emplace(appearance);
    MaterialMesh& mesh = place->second;
    if (is_new) mesh = {{}, appearance.material, appearance.tint, feature};
    add_face(face, mesh.mesh);
  }

  void add_imprinted(const Face& face, const View& view, impostor::Picture&& picture) {
    fill_gaps(picture);
    TexturedFace textured_faces{std::move(picture), {{}, kUnderPictures, materials::kNoTint, feature}};
    add_face(face, textured_faces.mesh.mesh);
    for (const Vec3 p : textured_faces.mesh.mesh.positions)
      textured_faces.mesh.uvs.push_back({dot(p - view.corner, view.u), dot(p - view.corner, view.v)});
    textured_faces.mesh.colour_source = materials::ColourSource::kByAtlas;
    if (!textured_faces.mesh.mesh.triangles.empty()) dressed.textured_faces.push_back(std::move(textured_faces));
  }

  // Rails instead of a face that is mostly holes, where that is still within the tolerance: as much of it as is there,
  // so that it darkens what is behind as its bars do. False: it is a face.
  bool add_rails(const Face& face, const Appearance& own, double share, double out_m) {
    if (share > kMostlyHoles || !is_rectangle(face)) return false;
    const Rails rails = rails_of(face, share);
    if (out_m + rails.gap_m > tolerance_m) return false;
    for (const Face& rail : rails.faces) add_plain(rail, own);
    dressed.error_m = std::max(dressed.error_m, out_m + rails.gap_m);
    return true;
  }

  void add(const Face& face, const Appearance& own, double out_m) {
    if (face.outer.size() < 3) return;
    const View view = view_of(face, texel_m);
    const std::uint64_t texels = std::uint64_t{view.columns} * view.rows;
    if (texels > kMaxTexelsPerFace) return add_plain(face, own);
    Impostor seen = finely_seen(looks, view);
    if (seen.dominant_share == 0) return add_plain(face, own);
    if (add_rails(face, own, shown_share(seen, view, face), out_m)) return;
    if (seen.dominant_share >= plain_share(view)) return add_plain(face, seen.dominant);
    const bool is_small = texels < kMinTexels || std::min(view.columns, view.rows) == 1;
    if (is_small && !shines(seen.picture)) return add_plain(face, mean_coat(seen));
    add_imprinted(face, view, std::move(seen.picture));
  }
};

}  // namespace

FacadeMeshes texture_facades(const grammars::Derivation& derivation, const impostor::Model& looks, double texel_m,
                             double tolerance_m, OsmId feature) {
  std::vector<Appearance> own;
  for (const grammars::Appearance& look : derivation.looks) {
    const SurfaceMaterial dress = surface_material_of(look);
    own.push_back({dress.material, dress.tint});
  }
  Dressing dressing{looks, texel_m, tolerance_m, feature};
  for (const grammars::Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) dressing.add(face, own[terminal.look], terminal.out_m);
  for (auto& [appearance, mesh] : dressing.plain)
    if (!mesh.mesh.triangles.empty()) dressing.dressed.meshes.push_back(std::move(mesh));
  return std::move(dressing.dressed);
}

}  // namespace citykiln::buildings

// Writes what rule files make of masses, as a tile on a street.
//   rule_glb OUT.glb TOLERANCE "STYLE x=0 y=0 w=12 d=10 h=9 roof=gabled …" …
// Keys: x y w d (place and size of the footprint), h (to the eaves), plan (rectangle L court), roof, pitch (degrees),
// over (eaves), street and party (edges, as 02), id; others are attributes of the rule: numbers, true, or text.
// STYLE is the name of a file in grammars/rules, or a path. lot=1 begins with the footprint instead of a mass; names=1
// colours terminals without a colour by their names. thing=1 begins with a box whose scope has z up, and STYLE is the
// name of a file in grammars/things, or a path.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "compiler/bake/merge.h"
#include "compiler/buildings/meshes/terminal_meshes.h"
#include "exporters/gltf/glb.h"
#include "grammars/derivation/form_roofs.h"
#include "grammars/language/read_rules.h"
#include "grammars/shapes/round_body.h"
#include "tests/grammars/made_mass.h"
#include "tests/test_files.h"

namespace {

using namespace citykiln;
using namespace citykiln::grammars;
using Words = std::map<std::string, std::string>;

Result<std::string> text_in(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) return Error{path.string(), "cannot be read"};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// One argument of the command line.
struct Order {
  std::string style;
  Words words;

  std::string text(const std::string& key, const std::string& otherwise) {
    const auto found = words.extract(key);
    return found.empty() ? otherwise : found.mapped();
  }
  double number(const std::string& key, double otherwise) { return std::stod(text(key, std::to_string(otherwise))); }
  std::vector<std::size_t> edges(const std::string& key, const std::string& otherwise) {
    std::vector<std::size_t> edges;
    for (const char digit : text(key, otherwise)) edges.push_back(static_cast<std::size_t>(digit - '0'));
    return edges;
  }
};

Order order_of(const std::string& argument) {
  std::istringstream words(argument);
  Order order;
  words >> order.style;
  for (std::string word; words >> word;) order.words[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  return order;
}

Polygon plan_of(const std::string& plan, double x, double y, double w, double d) {
  const auto ring = [&](std::initializer_list<Vec2> points) {
    Ring ring;
    for (const Vec2 p : points) ring.push_back({x + p.x, y + p.y});
    return ring;
  };
  if (plan == "L") return {ring({{0, 0}, {w, 0}, {w, d / 2}, {w / 2, d / 2}, {w / 2, d}, {0, d}}), {}};
  const Ring outer = ring({{0, 0}, {w, 0}, {w, d}, {0, d}});
  const double in = std::min({w, d}) / 3;
  if (plan == "court") return {outer, {ring({{in, in}, {in, d - in}, {w - in, d - in}, {w - in, in}})}};
  return {outer, {}};
}

MadeMass mass_in(Order& order) {
  MadeMass made;
  const double x = order.number("x", 0), y = order.number("y", 0);
  made.footprint = plan_of(order.text("plan", ""), x, y, order.number("w", 12), order.number("d", 10));
  made.height_m = order.number("h", 9);
  made.roof.form = roofs::form_named(order.text("roof", "flat")).value_or(roofs::RoofForm::kFlat);
  made.roof.angle_deg = order.number("pitch", 0);
  made.roof.overhang_m = order.number("over", made.roof.form == roofs::RoofForm::kFlat ? 0 : 0.4);
  made.street = order.edges("street", "0"), made.party = order.edges("party", "");
  made.id = StableId{static_cast<std::uint64_t>(order.number("id", 7 + x * 131 + y))};
  return made;
}

Value value_in(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == 0 ? Value(number) : Value(text);
}

DeriveOptions options_of(const Order& order, const MadeMass& made, roofs::RoofForm became, double tolerance_m) {
  DeriveOptions options;
  options.tolerance_m = tolerance_m;
  options.keep_appearances = true;
  options.roofs = form_roofs(0.02);
  options.attributes["height"] = made.height_m;
  options.attributes["roof"] = std::string(name_of(became));
  options.attributes["levels"] = std::max(1.0, std::floor(made.height_m / 3.1 + 0.3));
  for (const auto& [key, text] : order.words) options.attributes[key] = value_in(text);
  return options;
}

bool has(const std::string& name, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return name.find(w) != std::string::npos; });
}

// Pieces of one name differ a little, so that their borders are visible.
Appearance appearance_by_name(const std::string& name, StableId id) {
  constexpr double kColours[][3] = {{0.80, 0.74, 0.62}, {0.66, 0.58, 0.48}, {0.55, 0.60, 0.62},
                                    {0.72, 0.55, 0.45}, {0.58, 0.62, 0.50}, {0.86, 0.83, 0.76}};
  Appearance appearance;
  appearance.name = has(name, {"Glass", "Window"}) ? "glass" : has(name, {"Roof", "Tiles"}) ? "roof_tile" : "paint";
  if (appearance.name == "glass") return appearance;
  constexpr double kTiles[3] = {0.50, 0.31, 0.25};
  const double* colour =
      appearance.name == "roof_tile"
          ? kTiles
          : kColours[static_cast<std::uint64_t>(stable_id(StableId{}, name.c_str(), 0)) % std::size(kColours)];
  const double shade = 0.82 + 0.18 * static_cast<double>(static_cast<std::uint64_t>(id) % 4) / 3;
  appearance.red = colour[0] * shade, appearance.green = colour[1] * shade, appearance.blue = colour[2] * shade;
  return appearance;
}

void colour_by_names(Derivation& derivation) {
  for (Terminal& terminal : derivation.terminals) {
    if (derivation.appearances[terminal.appearance] != Appearance{}) continue;
    const Appearance appearance = appearance_by_name(terminal.name, terminal.id);
    terminal.appearance = static_cast<std::uint32_t>(derivation.appearances.size());
    derivation.appearances.push_back(appearance);
  }
}

// The box of a thing, with x to the right, y away from the front and z up.
Shape thing_start(Order& order) {
  Shape box;
  box.id = StableId{static_cast<std::uint64_t>(order.number("id", 7))};
  Scope& scope = box.scope;
  scope.axis = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  scope.origin = {order.number("x", 0), order.number("y", 0), order.number("z", 0)};
  scope.size_m = {order.number("w", 1), order.number("d", 1), order.number("h", 1)};
  box.faces = cylinder_in(scope, 2, 1, {.given = 4}).faces;
  box.parent_scope = scope;
  return box;
}

DeriveOptions thing_options(const Order& order, const Scope& scope, double tolerance_m) {
  DeriveOptions options;
  options.tolerance_m = tolerance_m;
  options.keep_appearances = true;
  options.attributes["width"] = scope.size_m[0];
  options.attributes["depth"] = scope.size_m[1];
  options.attributes["height"] = scope.size_m[2];
  for (const auto& [key, text] : order.words) options.attributes[key] = key == "text" ? Value(text) : value_in(text);
  return options;
}

Derivation derived_thing(const Program& program, Order& order, double tolerance_m) {
  const Shape box = thing_start(order);
  return derive(program, box, thing_options(order, box.scope, tolerance_m));
}

Derivation derived_building(const Program& program, Order& order, bool is_lot, double tolerance_m) {
  const MadeMass made = mass_in(order);
  roofs::RoofForm became{};
  Shape start = mass_model_of(made, &became);
  if (is_lot) start = lot(made.footprint, 0, 0, made.id, made.street);
  return derive(program, start, options_of(order, made, became, tolerance_m));
}

bool add_building(bake::PrimitiveMap& merged, Order order, double tolerance_m) {
  std::filesystem::path file = order.style;
  const bool is_thing = !order.text("thing", "").empty();
  const std::string folder = is_thing ? "grammars/things/" : "grammars/rules/";
  if (!file.has_parent_path()) file = source_file(folder + order.style + ".cga");
  const auto program =
      read_rules(file.filename().string(), [&](const std::string& name) { return text_in(file.parent_path() / name); });
  if (!program) return std::fprintf(stderr, "%s\n", to_string(program.error()).c_str()), false;
  const bool is_lot = !order.text("lot", "").empty(), shows_names = !order.text("names", "").empty();
  Derivation derivation =
      is_thing ? derived_thing(*program, order, tolerance_m) : derived_building(*program, order, is_lot, tolerance_m);
  for (const Warning& warning : derivation.warnings)
    std::fprintf(stderr, "%s\n", warning_line(*program, warning).c_str());
  for (const LimitHit& hit : derivation.limits) std::fprintf(stderr, "%s\n", limit_line(*program, hit).c_str());
  if (shows_names) colour_by_names(derivation);
  std::size_t triangles = 0;
  for (const auto& mesh : buildings::terminal_meshes(derivation, {}, 0)) {
    triangles += mesh.mesh.triangles.size();
    bake::merge(merged, {mesh, bake::Layer::kBuildings}, {}, 0);
  }
  std::printf("%s: %zu terminals, %zu triangles, %llu shapes, %llu steps, error %.3f m\n", order.style.c_str(),
              derivation.terminals.size(), triangles, static_cast<unsigned long long>(derivation.shapes),
              static_cast<unsigned long long>(derivation.steps), derivation.error_m);
  return true;
}

void add_floor(bake::PrimitiveMap& merged, materials::Material material, double south, double north, double z) {
  const double far = 400;
  Mesh quad{{{-far, south, z}, {far, south, z}, {far, north, z}, {-far, north, z}}, {}, {{0, 1, 2}, {0, 2, 3}}};
  bake::merge(merged, {{quad, material, materials::kNoTint, {}}, bake::Layer::kGround}, {}, 0);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return std::fputs("usage: rule_glb OUT.glb TOLERANCE \"STYLE KEY=VALUE …\" …\n", stderr), 2;
  bake::PrimitiveMap merged;
  add_floor(merged, materials::Material::kAsphalt, -12, -3, -0.12);
  add_floor(merged, materials::Material::kPaving, -3, 0, 0);
  add_floor(merged, materials::Material::kPaving, -15, -12, 0);
  add_floor(merged, materials::Material::kTownGround, 0, 400, 0);
  add_floor(merged, materials::Material::kGrass, -400, -15, 0);
  for (int i = 3; i < count; ++i)
    if (!add_building(merged, order_of(arguments[i]), std::stod(arguments[2]))) return 1;
  bake::BakedTile tile;
  tile.features = {{}};
  tile.primitives = primitives_of(std::move(merged));
  tile.textures = textures_shown(tile, 0.02, materials::TextureCache(0));
  scene::Header header;
  header.origin = {13.4, 52.5};
  const auto done = exporters::write_glb(tile, header, {}, arguments[1]);
  if (!done) return std::fprintf(stderr, "%s\n", to_string(done.error()).c_str()), 1;
}

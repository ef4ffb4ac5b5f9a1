// Looks at rules: derives a rule file on a rectangle and writes an .obj, one group a terminal, one material a look.
//   derive_obj RULES.cga OUT.obj [WIDTH DEPTH [TOLERANCE [SEED]]]
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compiler/geometry/triangulate.h"
#include "grammars/derive.h"
#include "grammars/form_roofs.h"
#include "grammars/link.h"

namespace {

using namespace citykiln;
using namespace citykiln::grammars;

Result<std::string> text_in(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) return Error{path.string(), "cannot be read"};
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct ObjWriter {
  std::ofstream obj, mtl;
  std::size_t vertices = 0;

  void write(const Face& face) {
    const FaceFrame frame = frame_of(face);
    const PlaneTriangles triangles = triangulate(flat(face, frame));
    for (const Vec2 p : triangles.points) {
      const Vec3 v = frame.to_space(p);
      obj << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    }
    for (const Triangle& t : triangles.triangles)
      obj << "f " << vertices + t[0] + 1 << ' ' << vertices + t[1] + 1 << ' ' << vertices + t[2] + 1 << '\n';
    vertices += triangles.points.size();
  }
};

void write(const Derivation& derivation, const std::filesystem::path& out) {
  const std::filesystem::path mtl = std::filesystem::path(out).replace_extension(".mtl");
  ObjWriter writer{std::ofstream(out), std::ofstream(mtl)};
  writer.obj.precision(10);
  writer.obj << "mtllib " << mtl.filename().string() << '\n';
  for (std::size_t i = 0; i < derivation.looks.size(); ++i) {
    const Look& look = derivation.looks[i];
    writer.mtl << "newmtl look" << i << "\nKd " << look.red << ' ' << look.green << ' ' << look.blue << '\n';
  }
  for (const Terminal& terminal : derivation.terminals) {
    writer.obj << "g " << path_name(derivation, terminal.path) << "\nusemtl look" << terminal.look << '\n';
    for (const Face& face : terminal.faces) writer.write(face);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return std::fputs("usage: derive_obj RULES.cga OUT.obj [WIDTH DEPTH [TOLERANCE [SEED]]]\n", stderr), 2;
  const std::filesystem::path rules = arguments[1];
  const auto program = read_rules(rules.filename().string(),
                                  [&](const std::string& file) { return text_in(rules.parent_path() / file); });
  if (!program) return std::fprintf(stderr, "%s\n", to_string(program.error()).c_str()), 1;
  const double width_m = count > 3 ? std::stod(arguments[3]) : 11, depth_m = count > 4 ? std::stod(arguments[4]) : 9;
  DeriveOptions options;
  options.roofs = form_roofs(0.01);
  options.keep_looks = true;
  options.tolerance_m = count > 5 ? std::stod(arguments[5]) : 0;
  options.seed = count > 6 ? std::stoull(arguments[6]) : 0;
  const Polygon footprint{{{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}}, {}};
  const Derivation derivation = derive(*program, lot(footprint, 0, 0, StableId{1}, {0}), options);
  for (const Trouble& trouble : derivation.troubles)
    std::fprintf(stderr, "%s\n", trouble_line(*program, trouble).c_str());
  for (const LimitHit& hit : derivation.limits) std::fprintf(stderr, "%s\n", limit_line(*program, hit).c_str());
  write(derivation, arguments[2]);
  std::size_t faces = 0;
  for (const Terminal& terminal : derivation.terminals) faces += terminal.faces.size();
  std::printf("%zu terminals, %zu faces, %llu shapes, %llu steps, error %.4f m\n", derivation.terminals.size(), faces,
              static_cast<unsigned long long>(derivation.shapes), static_cast<unsigned long long>(derivation.steps),
              derivation.error_m);
}

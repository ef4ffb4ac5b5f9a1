// made_glb FOLDER writes marked.glb and marked_nodes.glb: tiles with every feature of the format, marking atlases too,
// and both ways of instancing, for other programs to read.
#include <cstdio>

#include "exporters/gltf/glb.h"
#include "tests/exporters/made_tile.h"

int main(int count, char** words) {
  using namespace citykiln;
  using exporters::GlbOptions;
  const std::string folder = count > 1 ? words[1] : ".";
  scene::Header header;
  header.origin = {7.25, 43.5}, header.attributions = {"© OpenStreetMap contributors"};
  const std::pair<const char*, GlbOptions> files[] = {{"/marked.glb", {.target = Target::kThree}},
                                                      {"/marked_nodes.glb", {}}};
  for (const auto& [name, options] : files) {
    const auto done = exporters::write_glb(exporters::made_marked_tile(1), header, options, folder + name);
    if (!done) return std::fprintf(stderr, "%s\n", to_string(done.error()).c_str()), 1;
  }
  return 0;
}

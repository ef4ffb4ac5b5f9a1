// made_glb FOLDER: tiles with all that a tile can have, sheets too, and copies placed either way; for other programs to
// read. marked.glb, marked_nodes.glb.
#include <cstdio>

#include "exporters/gltf/glb.h"
#include "tests/exporters/made_tile.h"

int main(int count, char** words) {
  using namespace citykiln;
  using exporters::Instancing;
  const std::string folder = count > 1 ? words[1] : ".";
  scene::Header header;
  header.origin = {7.25, 43.5}, header.attributions = {"© OpenStreetMap contributors"};
  const std::pair<const char*, Instancing> files[] = {{"/marked.glb", Instancing::kExtension},
                                                      {"/marked_nodes.glb", Instancing::kNodes}};
  for (const auto& [name, instancing] : files) {
    const auto done = exporters::write_glb(exporters::made_marked_tile(1), header, instancing, folder + name);
    if (!done) return std::fprintf(stderr, "%s\n", to_string(done.error()).c_str()), 1;
  }
  return 0;
}

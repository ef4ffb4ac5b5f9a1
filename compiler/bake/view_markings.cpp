#include "compiler/bake/view_markings.h"

#include <set>

#include "compiler/bake/parts/bake_structures.h"

namespace citykiln::bake {
namespace {

using Layouts = std::vector<roads::MarkingLayout>;

void append(Layouts& layouts, const Layouts& more) { layouts.insert(layouts.end(), more.begin(), more.end()); }

}  // namespace

std::shared_ptr<const Markings> markings_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                                  const ViewLevels& view, const std::vector<int>& parts,
                                                  std::span<const TileLevel> levels) {
  Layouts layouts;
  std::set<const scene::LandCover*> covers;
  // columns are numbered as the layouts of the one land cover that has any
  for (const TileLevel& level : levels)
    if (covers.insert(level.cover.get()).second) append(layouts, level.cover->layouts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TilePart part{view, parts, parts[i]};
    BakedTile unused;
    Report repeated;
    append(layouts, layouts_of(generate_structures({header, chunk, levels[i].tolerance_m, unused, &part}, repeated)));
  }
  return std::make_shared<Markings>(lay_out_markings(layouts, tolerance_m_of(view.view, view.finest)));
}

}  // namespace citykiln::bake

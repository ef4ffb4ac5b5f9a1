// Constrained edges of CGAL triangulations.
#pragma once

namespace citykiln {

/// Inserts the constraint a b, a != b, like cdt.insert_constraint(a, b). Faster if the edge exists already, as most do:
/// it is only marked.
template <typename Cdt>
void constrain_edge(Cdt& cdt, typename Cdt::Vertex_handle a, typename Cdt::Vertex_handle b) {
  typename Cdt::Face_handle face;
  int i = 0;
  if (cdt.dimension() < 2 || !cdt.is_edge(a, b, face, i)) return cdt.insert_constraint(a, b);
  const auto [beyond, opposite] = cdt.mirror_edge({face, i});
  face->set_constraint(i, true);
  beyond->set_constraint(opposite, true);
}

}  // namespace citykiln

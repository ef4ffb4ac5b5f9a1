// Constrained edges of CGAL triangulations.
#pragma once

namespace citykiln {

/// Equals cdt.insert_constraint(a, b) for different vertices, but is faster for edges that exist already, as most do:
/// these are only marked.
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

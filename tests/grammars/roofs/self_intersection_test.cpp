// Self-intersections of roof bodies, tested by CGAL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "grammars/roofs/generate_roof.h"
#include "grammars/roofs/outline.h"
#include "tests/grammars/roofs/body.h"
#include "tests/grammars/roofs/footprints.h"
#include "tests/grammars/roofs/real_footprints.h"
#include "tests/test_files.h"

namespace citykiln::roofs {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

// Adds the used vertices and all triangles. Returns false if CGAL refuses a face because the surface would not be a
// manifold.
bool becomes(Surface& surface, const Mesh& body) {
  std::vector<Surface::Vertex_index> vertices(body.positions.size());
  for (const Triangle& t : body.triangles)
    for (const std::uint32_t v : t)
      if (!vertices[v].is_valid())
        vertices[v] = surface.add_vertex({body.positions[v].x, body.positions[v].y, body.positions[v].z});
  for (const Triangle& t : body.triangles)
    if (surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == Surface::null_face()) return false;
  return surface.is_valid() && CGAL::is_closed(surface);
}

// A degenerate footprint of the map may have no body.
void expect_good(const Polygon& footprint, RoofShape shape, const std::string& what, bool may_be_empty = false) {
  Report report;
  Surface surface;
  ASSERT_TRUE(becomes(surface, closed_body(generate_roof(footprint, shape, 0.05, {}, report), -5))) << what;
  EXPECT_TRUE(may_be_empty || surface.number_of_faces() > 0) << what;
  EXPECT_FALSE(pmp::does_self_intersect(surface)) << what;
  EXPECT_TRUE(pmp::is_outward_oriented(surface)) << what;
}

TEST(RoofBody, IsAClosedManifoldThatDoesNotCutItself) {
  for (int form = 0; form < static_cast<int>(RoofForm::kCount); ++form)
    for (const NamedFootprint& footprint : made_footprints())
      for (const double overhang_m : {0.0, 0.5}) {
        // a body touches itself where its footprint does
        if (footprint.name == "self-touching") continue;
        RoofShape shape;
        shape.form = static_cast<RoofForm>(form);
        shape.overhang_m = overhang_m;
        expect_good(footprint.polygon, shape, std::string(name_of(shape.form)) + " on " + footprint.name);
      }
}

// A body touches itself only at the corner where its footprint does.
TEST(RoofBody, TouchesItselfOnlyWhereItsFootprintDoes) {
  for (int form = 0; form < static_cast<int>(RoofForm::kCount); ++form) {
    RoofShape shape;
    shape.form = static_cast<RoofForm>(form);
    Report report;
    const Polygon footprint = made_footprints().back().polygon;
    Surface surface;
    ASSERT_TRUE(becomes(surface, closed_body(generate_roof(footprint, shape, 0.05, {}, report), -5)));
    EXPECT_GT(surface.number_of_faces(), 0u);
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> touching;
    pmp::self_intersections(surface, std::back_inserter(touching));
    const auto touches_corner = [&](Surface::Face_index face) {
      for (const auto v : CGAL::vertices_around_face(surface.halfedge(face), surface))
        if (surface.point(v).x() == 10 && surface.point(v).y() == 10) return true;
      return false;
    };
    for (const auto& [a, b] : touching) EXPECT_TRUE(touches_corner(a) && touches_corner(b)) << name_of(shape.form);
  }
}

// Near the top of a dome, an edge of a centimetre becomes shorter than a grid step.
TEST(RoofBody, IsGoodOverOutlinesWithTinyEdges) {
  Ring ring = circle({0, 0}, 8, 64);
  for (const int corner : {60, 33, 2})
    ring.insert(ring.begin() + corner, ring[corner] + Vec2{0, ring[corner].x < 0 ? 0x1p-6 : -0x1p-6});
  for (const RoofForm form : {RoofForm::kDome, RoofForm::kOnion, RoofForm::kCone}) {
    RoofShape shape;
    shape.form = form;
    Report report;
    expect_good({ring, {}}, shape, std::string(name_of(form)));
    EXPECT_TRUE(has_area_everywhere(closed_body(generate_roof({ring, {}}, shape, 0.001, {}, report), -5)));
  }
}

TEST(RoofBodyReal, DoesNotCutItselfInHelsinki) {
  const std::string path = real_data("helsinki/Helsinki.osm.pbf");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  int form = 0;
  for (const TaggedFootprint& building : footprints_of(path)) {
    RoofShape shape;
    shape.form = static_cast<RoofForm>(form++ % static_cast<int>(RoofForm::kCount));
    shape.overhang_m = form % 2 ? 0.4 : 0;
    // mapped footprints may touch themselves
    if (is_simple_polygon(cleaned(building.footprint)))
      expect_good(building.footprint, shape, to_string(building.id.osm) + " " + std::string(name_of(shape.form)), true);
  }
  EXPECT_GT(form, 100);
}

}  // namespace
}  // namespace citykiln::roofs

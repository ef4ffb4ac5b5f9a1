// roofGable, roofHip, roofPyramid, roofShed, roofMansard: a request to the roof builder for each face.
#include <algorithm>
#include <cmath>

#include "grammars/derivation/form_roofs.h"
#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

RoofRequest request_for(RoofKind kind, Arguments& arguments) {
  RoofRequest request;
  request.kind = kind;
  if (arguments[0].word != nullptr) {
    request.by_height = word_of(arguments[0]) == "byHeight";
    arguments = arguments.subspan(1);
  }
  const double first = metres(arguments[0]);
  (request.by_height ? request.height_m : request.angle_deg) = first;
  return request;
}

Face in_space(const Face& face, const FaceFrame& frame) {
  Face made = face;
  each_vertex(made, [&](Vec3& p) { p = frame.origin + frame.x * p.x + frame.y * p.y + frame.z * p.z; });
  return made;
}

// Over a horizontal face x is east and y north, so the footprint has the coordinates of the map, bit for bit.
FaceFrame roof_frame(const Face& face) {
  const FaceFrame frame = frame_of(face);
  if (frame.z.z < 1 - 1e-9) return frame;
  return {{0, 0, frame.origin.z}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

std::optional<std::vector<Face>> roof_over(const Execution& execution, const Face& face, RoofRequest request) {
  const FaceFrame frame = roof_frame(face);
  request.footprint = flat(face, frame);
  static const RoofBuilder kDefault = form_roofs(0.01);
  const RoofBuilder& builder = execution.run.options.roofs ? execution.run.options.roofs : kDefault;
  auto roof = builder(request);
  if (!roof) return std::nullopt;
  for (Face& part : *roof) part = in_space(part, frame);
  return roof;
}

double highest_over(const Face& base, const std::vector<Face>& roof) {
  const FaceFrame frame = frame_of(base);
  double highest_m = 0;
  for (const Face& part : roof)
    each_vertex(part, [&](Vec3 p) { highest_m = std::max(highest_m, std::abs(dot(frame.z, p - frame.origin))); });
  return highest_m;
}

// Displacement: every point of a roof is over the face or its overhang, and not above the highest point.
void build_roofs(Execution& execution, const Statement& statement, const RoofRequest& request) {
  std::vector<Face> faces;
  double highest_m = 0;
  // a builder may round coordinates, so the result depends on the position
  execution.run.depends_on(0);
  if (!execution.run.spend(64 * vertex_count(execution.shape.faces))) return;
  for (const Face& face : execution.shape.faces) {
    auto roof = roof_over(execution, face, request);
    if (!roof) {
      execution.run.warn(statement.position, "'" + statement.name + "' is not built on this shape; it stays flat");
      return;
    }
    highest_m = std::max(highest_m, highest_over(face, *roof));
    for (Face& part : *roof) faces.push_back(std::move(part));
  }
  const double aside_m = kMostReach * std::abs(request.overhang_m);
  execution.shape.faces = std::move(faces);
  execution.moved = execution.moved + Displacement{std::sqrt(highest_m * highest_m + aside_m * aside_m), 0};
  fit_scope(execution.shape);
}

}  // namespace

void op_roof_gable(Execution& execution, const Statement& statement, Arguments arguments) {
  RoofRequest request = request_for(RoofKind::kGable, arguments);
  request.overhang_m = std::max(number_or(arguments, 1, 0), number_or(arguments, 2, 0));
  build_roofs(execution, statement, request);
}

void op_roof_hip(Execution& execution, const Statement& statement, Arguments arguments) {
  RoofRequest request = request_for(RoofKind::kHip, arguments);
  request.overhang_m = number_or(arguments, 1, 0);
  build_roofs(execution, statement, request);
}

void op_roof_pyramid(Execution& execution, const Statement& statement, Arguments arguments) {
  RoofRequest request = request_for(RoofKind::kPyramid, arguments);
  request.overhang_m = number_or(arguments, 1, 0);
  build_roofs(execution, statement, request);
}

void op_roof_shed(Execution& execution, const Statement& statement, Arguments arguments) {
  RoofRequest request = request_for(RoofKind::kShed, arguments);
  request.edge = static_cast<std::size_t>(std::max(number_or(arguments, 1, 0), 0.0));
  build_roofs(execution, statement, request);
}

void op_roof_mansard(Execution& execution, const Statement& statement, Arguments arguments) {
  RoofRequest request = request_for(RoofKind::kMansard, arguments);
  request.upper_angle_deg = metres(arguments[1]);
  request.height_m = metres(arguments[2]);
  request.overhang_m = number_or(arguments, 3, 0);
  build_roofs(execution, statement, request);
}

}  // namespace citykiln::grammars

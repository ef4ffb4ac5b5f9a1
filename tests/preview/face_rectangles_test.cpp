#include "preview/scene/face_rectangles.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

constexpr double kRectangleTexel_m = 0.5;

const materials::TextureImage kImage{kRectangleTexel_m, 64, 32, {}};

// A face whose picture begins at a texel.
void add_face(bake::Primitive& faces, float width_m, float height_m, std::array<float, 2> first_texel) {
  add_quad(faces, {0, 0, 0}, {width_m, 0, 0}, {width_m, 0, height_m}, {0, 0, height_m});
  const float u = first_texel[0] * 0.5f, v = first_texel[1] * 0.5f;
  const std::array<bake::Float2, 4> corners = {{{0, height_m}, {width_m, height_m}, {width_m, 0}, {0, 0}}};
  for (const bake::Float2& at : corners) faces.uvs.push_back({u + at[0], v + at[1]});
}

TEST(FaceRectangles, AreTheTexelsThatEachFaceTouches) {
  bake::Primitive faces;
  add_face(faces, 10, 3, {1, 1});
  add_face(faces, 2.125f, 4.875f, {33, 5});
  const auto found = face_rectangles(faces, kImage);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0], (TexelRectangle{1, 1, 20, 6}));
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], (TexelRectangle{33, 5, 37, 14}));
  EXPECT_EQ(found[3], found[2]);
}

// A sixteenth of a texel too far, as uvs are snapped.
TEST(FaceRectangles, LeaveOutTexelsThatRoundingTouches) {
  bake::Primitive faces;
  add_face(faces, 2.02f, 4, {3, 3});
  EXPECT_EQ(face_rectangles(faces, kImage)[0], (TexelRectangle{3, 3, 6, 10}));
}

TEST(FaceRectangles, StayWithinTheImage) {
  bake::Primitive faces;
  add_face(faces, 1000, 1000, {-9, -9});
  EXPECT_EQ(face_rectangles(faces, kImage)[1], (TexelRectangle{0, 0, 63, 31}));
}

}  // namespace
}  // namespace citykiln::preview

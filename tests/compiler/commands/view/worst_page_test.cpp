#include "compiler/commands/view/worst_page.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

TEST(WorstPage, EscapesTheTextsOfStrangers) {
  EXPECT_EQ(html_text("<script>alert('x')</script> & \"y\""),
            "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;y&quot;");
  EXPECT_EQ(html_text("a\x01\nb"), "a  b");
  EXPECT_EQ(html_text("Straße"), "Straße");
}

TEST(WorstPage, ShowsUnusualPlacesInsideTheExtent) {
  const Box2 extent{{0, 0}, {100, 50}};
  verify::WorstPlace place;
  EXPECT_FALSE(needs_picture(extent, place));
  place.at = Vec2{90, 40};
  EXPECT_TRUE(needs_picture(extent, place));
  place.is_usual = true;
  EXPECT_FALSE(needs_picture(extent, place));
  place.is_usual = false, place.at = Vec2{40, 90};
  EXPECT_FALSE(needs_picture(extent, place));
}

}  // namespace
}  // namespace citykiln::commands

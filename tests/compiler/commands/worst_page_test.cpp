#include "compiler/commands/worst_page.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

TEST(WorstPage, EscapesTheTextsOfStrangers) {
  EXPECT_EQ(html_text("<script>alert('x')</script> & \"y\""),
            "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;y&quot;");
  EXPECT_EQ(html_text("a\x01\nb"), "a  b");
  EXPECT_EQ(html_text("Straße"), "Straße");
}

}  // namespace
}  // namespace citykiln::commands

#include "compiler/map/tags/tag_values.h"

#include <gtest/gtest.h>

#include <iterator>
#include <utility>

namespace citykiln::map {
namespace {

TEST(TagValues, LengthsComeInMetresFeetAndInches) {
  const struct {
    const char* text;
    double metres;
  } cases[] = {{"12", 12},        {"12.5", 12.5},  {"12,5", 12.5},    {"12 m", 12},      {"12m", 12},
               {" 7 metres ", 7}, {"40'", 12.192}, {"40 ft", 12.192}, {"5'10\"", 1.778}, {"6' 2\"", 1.8796},
               {"0.3 km", 300},   {"2;3", 2},      {"-1", -1},        {"+3", 3},         {"0", 0}};
  for (const auto& c : cases) {
    const auto length = length_m_of(c.text);
    ASSERT_TRUE(length) << c.text;
    EXPECT_NEAR(*length, c.metres, 1e-9) << c.text;
  }
}

TEST(TagValues, InvalidLengthsGiveNothing) {
  for (const char* text : {"", "high", "m", "12 stories", "nan", "inf", "1.2.3", "--5", "99999999", "1e1", "1e999",
                           "12-15", "'", "~10", "3 x 4", ";", "٣"})
    EXPECT_FALSE(length_m_of(text)) << text;
}

TEST(TagValues, UnitsAreReadInAnyCaseAndWithPrimes) {
  const std::pair<const char*, double> rows[] = {{"12.0 M", 12},       {"12 mts", 12},
                                                 {"1200 cm", 12},      {"40\xe2\x80\xb2", 12.192},
                                                 {"480\"", 12.192},    {"480\xe2\x80\xb3", 12.192},
                                                 {"40 FT", 12.192},    {"39'6\"", 12.0396},
                                                 {"12 inches", 0.3048}};
  for (const auto& [text, length] : rows) EXPECT_NEAR(length_m_of(text).value_or(-1), length, 1e-9) << text;
  EXPECT_EQ(bearing_deg_of("180\xc2\xb0"), 180);
  EXPECT_EQ(bearing_deg_of("90 deg"), 90);
}

TEST(TagValues, NumbersTakeTheFirstOfAList) {
  EXPECT_EQ(number_of("3"), 3);
  EXPECT_EQ(number_of("2.5"), 2.5);
  EXPECT_EQ(number_of("4;5"), 4);
  EXPECT_EQ(number_of("-2"), -2);
  for (const char* text : {"", "two", "7-7", "3 lanes", "0x10"}) EXPECT_FALSE(number_of(text)) << text;
}

TEST(TagValues, ColoursAreHexOrNamed) {
  EXPECT_EQ(colour_of("#ff0080"), (Srgb{255, 0, 128}));
  EXPECT_EQ(colour_of("#F08"), (Srgb{255, 0, 136}));
  EXPECT_EQ(colour_of("white"), (Srgb{255, 255, 255}));
  EXPECT_EQ(colour_of("White"), colour_of("white"));
  EXPECT_EQ(colour_of("light_grey"), colour_of("lightgray"));
  EXPECT_EQ(colour_of("red;white"), colour_of("red"));
  EXPECT_EQ(colour_of("c0ffee"), (Srgb{0xc0, 0xff, 0xee}));
  for (const char* text : {"", "#", "#12", "#12345", "#gggggg", "#-1-1-1", "RAL 7016", "colourful", "#ff0080ff0"})
    EXPECT_FALSE(colour_of(text)) << text;
}

TEST(TagValues, ColoursOfCssAreReadByNameByFunctionAndWithOpacity) {
  constexpr const char* kCssNames[] = {"aliceblue",
                                       "antiquewhite",
                                       "aqua",
                                       "aquamarine",
                                       "azure",
                                       "beige",
                                       "bisque",
                                       "black",
                                       "blanchedalmond",
                                       "blue",
                                       "blueviolet",
                                       "brown",
                                       "burlywood",
                                       "cadetblue",
                                       "chartreuse",
                                       "chocolate",
                                       "coral",
                                       "cornflowerblue",
                                       "cornsilk",
                                       "crimson",
                                       "cyan",
                                       "darkblue",
                                       "darkcyan",
                                       "darkgoldenrod",
                                       "darkgray",
                                       "darkgreen",
                                       "darkgrey",
                                       "darkkhaki",
                                       "darkmagenta",
                                       "darkolivegreen",
                                       "darkorange",
                                       "darkorchid",
                                       "darkred",
                                       "darksalmon",
                                       "darkseagreen",
                                       "darkslateblue",
                                       "darkslategray",
                                       "darkslategrey",
                                       "darkturquoise",
                                       "darkviolet",
                                       "deeppink",
                                       "deepskyblue",
                                       "dimgray",
                                       "dimgrey",
                                       "dodgerblue",
                                       "firebrick",
                                       "floralwhite",
                                       "forestgreen",
                                       "fuchsia",
                                       "gainsboro",
                                       "ghostwhite",
                                       "gold",
                                       "goldenrod",
                                       "gray",
                                       "green",
                                       "greenyellow",
                                       "grey",
                                       "honeydew",
                                       "hotpink",
                                       "indianred",
                                       "indigo",
                                       "ivory",
                                       "khaki",
                                       "lavender",
                                       "lavenderblush",
                                       "lawngreen",
                                       "lemonchiffon",
                                       "lightblue",
                                       "lightcoral",
                                       "lightcyan",
                                       "lightgoldenrodyellow",
                                       "lightgray",
                                       "lightgreen",
                                       "lightgrey",
                                       "lightpink",
                                       "lightsalmon",
                                       "lightseagreen",
                                       "lightskyblue",
                                       "lightslategray",
                                       "lightslategrey",
                                       "lightsteelblue",
                                       "lightyellow",
                                       "lime",
                                       "limegreen",
                                       "linen",
                                       "magenta",
                                       "maroon",
                                       "mediumaquamarine",
                                       "mediumblue",
                                       "mediumorchid",
                                       "mediumpurple",
                                       "mediumseagreen",
                                       "mediumslateblue",
                                       "mediumspringgreen",
                                       "mediumturquoise",
                                       "mediumvioletred",
                                       "midnightblue",
                                       "mintcream",
                                       "mistyrose",
                                       "moccasin",
                                       "navajowhite",
                                       "navy",
                                       "oldlace",
                                       "olive",
                                       "olivedrab",
                                       "orange",
                                       "orangered",
                                       "orchid",
                                       "palegoldenrod",
                                       "palegreen",
                                       "paleturquoise",
                                       "palevioletred",
                                       "papayawhip",
                                       "peachpuff",
                                       "peru",
                                       "pink",
                                       "plum",
                                       "powderblue",
                                       "purple",
                                       "rebeccapurple",
                                       "red",
                                       "rosybrown",
                                       "royalblue",
                                       "saddlebrown",
                                       "salmon",
                                       "sandybrown",
                                       "seagreen",
                                       "seashell",
                                       "sienna",
                                       "silver",
                                       "skyblue",
                                       "slateblue",
                                       "slategray",
                                       "slategrey",
                                       "snow",
                                       "springgreen",
                                       "steelblue",
                                       "tan",
                                       "teal",
                                       "thistle",
                                       "tomato",
                                       "turquoise",
                                       "violet",
                                       "wheat",
                                       "white",
                                       "whitesmoke",
                                       "yellow",
                                       "yellowgreen"};
  for (const char* name : kCssNames) EXPECT_TRUE(colour_of(name)) << name;
  EXPECT_EQ(std::size(kCssNames), 148u);
  EXPECT_EQ(colour_of("IndianRed"), (Srgb{205, 92, 92}));
  const std::pair<const char*, Srgb> rows[] = {{"rgb(178, 50, 40)", {178, 50, 40}},
                                               {"rgb(178 50 40)", {178, 50, 40}},
                                               {"RGB(100%,50%,0%)", {255, 128, 0}},
                                               {"rgba(178, 50, 40, 0.5)", {178, 50, 40}},
                                               {"rgba(178 50 40 / 50%)", {178, 50, 40}},
                                               {"rgb(300, 0, 0)", {255, 0, 0}},
                                               {"#f08c", {255, 0, 136}},
                                               {"#ff008080", {255, 0, 128}}};
  for (const auto& [text, srgb] : rows) EXPECT_EQ(colour_of(text), srgb) << text;
  EXPECT_EQ(colour_of("red/white"), colour_of("red"));
  for (const char* text : {"rgb(", "rgb()", "rgb(1,2)", "rgb(1,2,3", "rgb(1,2,3,4,5)", "rgb(a,b,c)", "rgb(-1,0,0)",
                           "#ff0080g0", "7016", "cinza"})
    EXPECT_FALSE(colour_of(text)) << text;
}

TEST(TagValues, WordsAreInSmallLettersAndSeparate) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(words_of("Gabled"), Words{"gabled"});
  EXPECT_EQ(words_of("Natural stone; half-hipped"), (Words{"natural_stone", "half_hipped"}));
  EXPECT_EQ(words_of("dirt/sand,_metal "), (Words{"dirt", "sand", "metal"}));
  EXPECT_EQ(words_of(" ;, -"), Words{});
}

TEST(TagValues, BearingsAreDegreesOrWinds) {
  const std::pair<const char*, double> rows[] = {{"0", 0},     {"225", 225},      {"360", 0},          {"-90", 270},
                                                 {"N", 0},     {"ssw", 202.5},    {"South-West", 225}, {"12.5", 12.5},
                                                 {"north", 0}, {"north east", 45}};
  for (const auto& [text, degrees] : rows) EXPECT_EQ(bearing_deg_of(text), degrees) << text;
  for (const char* text : {"", "up", "400", "across", "NNN", "northish"}) EXPECT_FALSE(bearing_deg_of(text)) << text;
}

TEST(TagValues, YearsAreReadAsTheyAreWritten) {
  const std::pair<const char*, int> rows[] = {{"1898", 1898},        {"1898-05-01", 1898}, {"~1900", 1900},
                                              {"before 1850", 1850}, {"C19", 1850},        {"late C18", 1750},
                                              {"1920s", 1925},       {"1890..1900", 1890}, {"987", 987}};
  for (const auto& [text, year] : rows) EXPECT_EQ(year_of(text), year) << text;
  for (const char* text : {"", "old", "12", "99999", "C99", "C", "1899999999999"}) EXPECT_FALSE(year_of(text)) << text;
}

TEST(TagValues, EveryValueExceptNoIsYes) {
  for (const char* text : {"yes", "1", "true", "-1", "viaduct"}) EXPECT_TRUE(says_yes(text)) << text;
  for (const char* text : {"", "no", "0", "false"}) EXPECT_FALSE(says_yes(text)) << text;
}

}  // namespace
}  // namespace citykiln::map

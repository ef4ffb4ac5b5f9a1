#include "compiler/source/format/mended_xml.h"

#include <gtest/gtest.h>

#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

constexpr const char* kHouse =
    R"(<node id="1" lat="52" lon="10"/><node id="2" lat="52" lon="10.0003"/><node id="3" lat="52.0002" lon="10.0003"/>)"
    R"(<way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="1"/><tag k="building" v="b&#228;r"/></way>)";

std::string utf16(std::string_view ascii, bool is_big) {
  std::string bytes = is_big ? "\xfe\xff" : "\xff\xfe";
  for (const char c : ascii) bytes += is_big ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

OsmData read_bytes(std::string_view bytes, Report& report) {
  const ScratchFolder folder;
  const Result<OsmData> data = read_osm(folder.write("map.osm", bytes), 1, report);
  EXPECT_TRUE(data) << (data ? "" : data.error().message);
  return data ? *data : OsmData{};
}

TEST(MendedXml, Utf16IsReadAsUtf8Is) {
  std::string text = osm(kHouse);
  Report report;
  const std::string expected = text_of(read_bytes(text, report));
  if (const std::size_t at = text.find("UTF-8"); at != std::string::npos) text.replace(at, 5, "UTF-16");
  EXPECT_EQ(text_of(read_bytes(utf16(text, false), report)), expected);
  EXPECT_EQ(text_of(read_bytes(utf16(text, true), report)), expected);
}

TEST(MendedXml, Utf16PairsAreOneCharacter) {
  EXPECT_EQ(utf8_of_utf16({"\xff\xfe<\0\x3d\xd8\x00\xde\xe4\0", 10}), "<\xf0\x9f\x98\x80\xc3\xa4");
  EXPECT_EQ(utf8_of_utf16({"\xff\xfe<\0\x3d\xd8<\0", 8}), "<\xef\xbf\xbd<");
  EXPECT_FALSE(utf8_of_utf16("<osm></osm>"));
}

TEST(MendedXml, ElementsThatAnEditorDeletesAreDeleted) {
  for (const std::string mark : {"action='delete' visible='true'", "action=\"delete\""}) {
    Report report;
    const OsmData data =
        read_bytes(osm(std::string(kHouse) + "<way id='-2' " + mark + "><nd ref='1'/><nd ref='2'/></way>" +
                       "<way id='-3' action='modify'><nd ref='1'/><nd ref='2'/></way>"),
                   report);
    EXPECT_EQ(data.ways.size(), 2u) << mark;
    EXPECT_EQ(report.counts()[Code::kDeletedElement], 1u) << mark;
  }
}

TEST(MendedXml, PlacesInWaysAndMembersAreRead) {
  const std::string text =
      "<osm version='0.6' generator='Overpass API'><note>a > b</note><meta osm_base='x'/>"
      "<way id='1'><bounds minlat='52' minlon='10' maxlat='52.1' maxlon='10.1'/><center lat='52' lon='10'/>"
      "<nd ref='1' lat='52.0' lon='10.0'/><nd ref='2' lat='52.0' lon='10.0003'/>"
      "<nd ref='3' lat='52.0002' lon='10.0003'/><nd ref='1' lat='52.0' lon='10.0'/>"
      "<tag k='building' v='yes'/></way>"
      "<relation id='5'><member type='way' ref='8' role='outer'><nd lat='52.1' lon='10.1'/>"
      "<nd lat='52.1' lon='10.2'/><nd lat='52.2' lon='10.2'/><nd lat='52.1' lon='10.1'/></member>"
      "<member type='way' ref='1' role='outer'><nd lat='52.0' lon='10.0'/></member>"
      "<tag k='type' v='multipolygon'/><tag k='natural' v='water'/></relation></osm>";
  Report report;
  const OsmData data = read_bytes(text, report);
  ASSERT_EQ(data.ways.size(), 2u);
  EXPECT_EQ(data.ways[0].nodes.count, 4u);
  ASSERT_EQ(data.areas.size(), 2u);
  EXPECT_EQ(data.areas[1].rings.count, 2u);
  EXPECT_NEAR(data.node_box.north, 52.2, 1e-6);
  EXPECT_EQ(report.counts()[Code::kMissingNode] + report.counts()[Code::kMissingMember], 0u);
}

TEST(MendedXml, PlainDocumentsStayAsTheyAre) {
  EXPECT_FALSE(mended_elements(osm(kHouse)));
  EXPECT_FALSE(mended_elements("<osm><way id='1' action='modify'><nd ref='1'/></way></osm>"));
}

TEST(MendedXml, ElementsThatTheFormatDoesNotHaveAreSkipped) {
  Report report;
  const std::string expected = text_of(read_bytes(osm(kHouse), report));
  const std::string count = R"(<count id="0"><tag k="nodes" v="7"/><tag k="ways" v="2"/></count>)";
  const std::string deep = R"(<tile><row><cell/><!-- x --></row></tile><remark> runtime error </remark>)";
  EXPECT_EQ(text_of(read_bytes(osm(count + kHouse + deep), report)), expected);
}

TEST(MendedXml, AByteOrderMarkIsNoText) {
  Report report;
  EXPECT_EQ(text_of(read_bytes("\xef\xbb\xbf" + osm(kHouse), report)), text_of(read_bytes(osm(kHouse), report)));
}

}  // namespace
}  // namespace citykiln::source

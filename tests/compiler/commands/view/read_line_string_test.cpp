#include "compiler/commands/view/read_line_string.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/scratch_folder.h"

namespace citykiln::commands {
namespace {

class ReadLineString : public testing::Test {
 protected:
  Result<std::vector<LonLatHeight>> read(const std::string& text) const {
    std::ofstream(folder_.at("a.geojson")) << text;
    return read_line_string(folder_.at("a.geojson"));
  }
  const ScratchFolder folder_;
};

constexpr const char* kLine = R"({"type": "LineString", "coordinates": [[7.4, 43.7], [7.5, 43.8, 12.5]]})";

TEST_F(ReadLineString, IsTheFirstOfAGeometryAFeatureOrACollection) {
  const std::string feature = std::string(R"({"type": "Feature", "properties": null, "geometry": )") + kLine + "}";
  const std::string point = R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]}})";
  const std::string collection = R"({"type": "FeatureCollection", "features": [)" + point + ", " + feature + "]}";
  for (const std::string& text : {std::string(kLine), feature, collection}) {
    const auto line = read(text);
    ASSERT_TRUE(line) << to_string(line.error());
    ASSERT_EQ(line->size(), 2u);
    EXPECT_EQ((*line)[0].lon_deg, 7.4);
    EXPECT_FALSE((*line)[0].height_m);
    EXPECT_EQ((*line)[1].lat_deg, 43.8);
    EXPECT_EQ((*line)[1].height_m, 12.5);
  }
}

TEST_F(ReadLineString, AnythingElseIsOneClearLine) {
  for (const char* text :
       {"", "{", "[]", "7", R"({"type": "Point", "coordinates": [1, 2]})", R"({"type": "LineString"})",
        R"({"type": "LineString", "coordinates": []})", R"({"type": "LineString", "coordinates": [[1, 2]]})",
        R"({"type": "LineString", "coordinates": [[1, 2], [1]]})",
        R"({"type": "LineString", "coordinates": [[1, 2], ["x", 3]]})",
        R"({"type": "LineString", "coordinates": [[1, 2], [3, 91]]})", R"({"features": {"a": 1}})"}) {
    const auto line = read(text);
    ASSERT_FALSE(line) << text;
    EXPECT_EQ(line.error().message.find('\n'), std::string::npos) << text;
  }
  EXPECT_FALSE(read_line_string(folder_.at("absent")));
}

}  // namespace
}  // namespace citykiln::commands

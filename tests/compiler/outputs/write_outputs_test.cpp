#include "compiler/outputs/write_outputs.h"

#include <gtest/gtest.h>

#include "compiler/pipeline.h"
#include "tests/scratch_folder.h"

namespace citykiln::outputs {
namespace {

constexpr auto kSilent = [](auto&&...) {};

scene::Scene scene_of_two_lamps(const ScratchFolder& scratch) {
  CompileSpec spec;
  spec.map_path = scratch.write("map.osm", R"(<osm version="0.6">
    <bounds minlat="0" minlon="0" maxlat="0.001" maxlon="0.001"/>
    <node id="1" lat="0.0004" lon="0.0004"><tag k="highway" v="street_lamp"/></node>
    <node id="2" lat="0.0006" lon="0.0006"><tag k="highway" v="street_lamp"/></node>
  </osm>)");
  Result<CompileResult> compiled = compile(spec, kSilent);
  EXPECT_TRUE(compiled);
  return compiled ? std::move(compiled->scene) : scene::Scene{};
}

Account lamps_counted(const scene::Scene& scene, const ScratchFolder& scratch, Outputs outputs) {
  outputs.manifest = false, outputs.tolerances_m = {1, 12.5};
  Result<exporters::OutputFolder> folder = exporters::OutputFolder::open(scratch.at("out"));
  EXPECT_TRUE(folder);
  Report report;
  const auto written = write_outputs(scene, outputs, 1, *folder, report, kSilent);
  EXPECT_TRUE(written) << to_string(written.error());
  return report.account("bake", "lamp");
}

TEST(WriteOutputs, CountsTheObjectsOfBakingOnceForAllForms) {
  const ScratchFolder scratch;
  const scene::Scene scene = scene_of_two_lamps(scratch);
  ASSERT_EQ(scene.chunks.size(), 1U);
  const Account usd = lamps_counted(scene, scratch, {.glb = false, .usd = true});
  EXPECT_EQ(usd.in, 4U) << "two levels";
  const Account with_tiles = lamps_counted(scene, scratch, {.glb = false, .usd = true, .tiles3d = true});
  EXPECT_EQ(with_tiles.in, usd.in);
  EXPECT_EQ(with_tiles.dropped, usd.dropped);
  EXPECT_EQ(lamps_counted(scene, scratch, {.glb = true, .tiles3d = true}).in, usd.in);
  EXPECT_EQ(lamps_counted(scene, scratch, {.glb = false, .tiles3d = true}).in, usd.in);
}

}  // namespace
}  // namespace citykiln::outputs

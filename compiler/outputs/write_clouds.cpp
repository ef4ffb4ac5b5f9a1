#include "compiler/outputs/write_clouds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exporters/gltf/write/encode_clouds.h"
#include "exporters/run_files.h"
#include "exporters/usd/encode_cloud_layer.h"
#include "exporters/vdb/encode_vdb.h"

namespace citykiln::outputs {
namespace {

// Clouds are seen from farther away than tiles are.
constexpr double kCellsOfTolerance = 4, kFinestCell_m = 40, kCoarsestCell_m = 400;
constexpr double kMostTriangles = 400000, kMostVoxels = 4e6;

// Each cell of surface has two triangles.
double cell_m(const sky::CloudMeasures& clouds, double tolerance_m) {
  const double wanted_m = std::clamp(kCellsOfTolerance * tolerance_m, kFinestCell_m, kCoarsestCell_m);
  return std::max(wanted_m, std::sqrt(2 * clouds.area_m2 / kMostTriangles));
}

// The size of voxels in whole metres, doubled until they are few enough.
double voxel_m(const sky::CloudMeasures& clouds, double cell_m) {
  double voxel = std::round(cell_m);
  while (clouds.volume_m3 / (voxel * voxel * voxel) > kMostVoxels) voxel *= 2;
  return voxel;
}

class CloudWriter {
 public:
  CloudWriter(exporters::OutputFolder& folder, std::vector<WrittenFile>& files) : folder_(folder), files_(files) {}

  Result<Done> write(const char* name, const std::vector<std::byte>& bytes) {
    if (const Result<Done> done = folder_.write(name, bytes); !done) return done;
    files_.push_back({name, bytes.size()});
    return Done{};
  }

 private:
  exporters::OutputFolder& folder_;
  std::vector<WrittenFile>& files_;
};

std::vector<exporters::CloudMeshes> meshes_of(std::span<const sky::LayerParticles> layers, double cell_m, int threads) {
  std::vector<exporters::CloudMeshes> meshes;
  for (const sky::LayerParticles& layer : layers)
    meshes.push_back({layer.layer, layer.clouds, sky::cloud_surfaces(layer, cell_m, threads)});
  std::erase_if(meshes, [](const exporters::CloudMeshes& layer) { return layer.parts.empty(); });
  return meshes;
}

Result<Done> write_usd_clouds(std::span<const sky::LayerParticles> layers, Vec3 origin, double voxel_m,
                              CloudWriter& writer, std::vector<std::string>& notes) {
  const auto vdb = exporters::encode_vdb(sky::cloud_voxels(layers, origin, voxel_m));
  if (!vdb) notes.push_back(fmt::format("note: no {}: {}", exporters::kVdbName, to_string(vdb.error())));
  if (vdb)
    if (const Result<Done> done = writer.write(exporters::kVdbName, *vdb); !done) return done;
  return writer.write(exporters::kUsdCloudsName, exporters::encode_cloud_layer(layers, bool(vdb)));
}

}  // namespace

Result<Done> write_clouds(const scene::Scene& scene, const Outputs& outputs, int threads,
                          exporters::OutputFolder& folder, std::vector<WrittenFile>& files,
                          std::vector<std::string>& notes) {
  const auto& layers = scene.header.sky.clouds;
  const Box2& extent = scene.header.extent;
  if (layers.empty() || extent.is_empty() || !(outputs.glb || outputs.usd)) return Done{};
  const sky::CloudMeasures measures = sky::measures_over(layers, extent);
  const double cell = cell_m(measures, outputs.tolerances_m.back());
  const std::vector<sky::LayerParticles> particles = sky::clouds_over(layers, extent, cell / 2, threads);
  CloudWriter writer(folder, files);
  if (outputs.glb) {
    const std::vector<exporters::CloudMeshes> meshes = meshes_of(particles, cell, threads);
    if (!meshes.empty()) {
      const auto glb = exporters::encode_clouds(meshes, scene.header, cell, cell / 2);
      if (const Result<Done> done = writer.write(exporters::kGlbCloudsName, glb); !done) return done;
    }
  }
  if (!outputs.usd) return Done{};
  const Vec2 middle = extent.centre();
  return write_usd_clouds(particles, {std::round(middle.x), std::round(middle.y), 0}, voxel_m(measures, cell), writer,
                          notes);
}

}  // namespace citykiln::outputs

// unpack_glb.mjs IN OUT [IN OUT …]: reads compressed .glb files with glTF Transform and the decoders of Draco and meshoptimizer, and
// writes them without compression.
import { NodeIO } from "@gltf-transform/core";
import { ALL_EXTENSIONS } from "@gltf-transform/extensions";
import draco3d from "draco3dgltf";
import { MeshoptDecoder } from "meshoptimizer";

await MeshoptDecoder.ready;
const io = new NodeIO()
  .registerExtensions(ALL_EXTENSIONS)
  .registerDependencies({ "draco3d.decoder": await draco3d.createDecoderModule(), "meshopt.decoder": MeshoptDecoder });
const paths = process.argv.slice(2);
for (let i = 0; i + 1 < paths.length; i += 2) {
  const document = await io.read(paths[i]);
  for (const extension of document.getRoot().listExtensionsUsed())
    if (["KHR_draco_mesh_compression", "EXT_meshopt_compression"].includes(extension.extensionName)) extension.dispose();
  await io.write(paths[i + 1], document);
}

# The vertex colours of a .glb. Godot 3.2 reads colours in normalised bytes as white and does not show vertex colours; this
# puts them into an imported mesh again and switches them on.
tool
extends Reference

const UNSIGNED_BYTE = 5121

var file = File.new()
var gltf = {}
var binary_at = 0


func open(path):
	file.open(path, File.READ)
	file.seek(12)
	var length = file.get_32()
	file.seek(20)
	gltf = parse_json(file.get_buffer(length).get_string_from_utf8())
	binary_at = 20 + length + 8
	return self


# Gives a mesh the colours of the file's mesh with its name. A mesh whose vertices Godot did not keep stays as it is.
func apply(mesh):
	var colours = colours_of(mesh.resource_name)
	if colours.size() != mesh.get_surface_count():
		return
	var surfaces = []
	for i in mesh.get_surface_count():
		surfaces.append({"arrays": mesh.surface_get_arrays(i), "material": mesh.surface_get_material(i)})
		if colours[i] != null and mesh.surface_get_array_len(i) != colours[i].size():
			return
	for surface in surfaces:
		mesh.surface_remove(0)
	for i in surfaces.size():
		surfaces[i]["arrays"][Mesh.ARRAY_COLOR] = colours[i]
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, surfaces[i]["arrays"])
		mesh.surface_set_material(i, surfaces[i]["material"])
		surfaces[i]["material"].vertex_color_use_as_albedo = true


# The colours of each primitive of a mesh, null where all are white; an empty list without such a mesh.
func colours_of(mesh_name):
	for mesh in gltf["meshes"]:
		if mesh["name"] == mesh_name:
			var colours = []
			for primitive in mesh["primitives"]:
				if "COLOR_0" in primitive["attributes"]:
					colours.append(colours_in(gltf["accessors"][primitive["attributes"]["COLOR_0"]]))
				else:
					colours.append(null)
			return colours
	return []


func colours_in(accessor):
	var colours = PoolColorArray()
	if accessor["componentType"] != UNSIGNED_BYTE or accessor["type"] != "VEC4":
		return colours
	var view = gltf["bufferViews"][accessor["bufferView"]]
	var count = int(accessor["count"])
	file.seek(binary_at + int(view.get("byteOffset", 0)) + int(accessor.get("byteOffset", 0)))
	var bytes = file.get_buffer(4 * count)
	colours.resize(count)
	for i in count:
		colours[i] = Color8(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3])
	return colours

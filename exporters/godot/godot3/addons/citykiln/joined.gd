# Draws a layer of a tile in few calls. Surfaces without pictures become one, with the colours of their materials in the
# vertices; objects that share a mesh become one MultiMesh, or, where they have few triangles in all, part of one mesh.
tool
extends Reference

const Copies = preload("copies.gd")

# Copies with more triangles than this in all stay copies.
const COPIED_TRIANGLES = 2000
# Colours of vertices are kept as floats: in bytes dark ones would have few steps.
const COMPRESS = Mesh.ARRAY_COMPRESS_DEFAULT & ~Mesh.ARRAY_COMPRESS_COLOR

# the look of a surface -> {"tool": SurfaceTool, "material": its material}
var groups = {}
var plain_materials = {}
# mesh -> {look: SurfaceTool of that mesh alone}
var prepared = {}


# Joins what a layer draws itself and by its children.
func join(layer, scene):
	var objects = {}
	for child in layer.get_children():
		if child is MeshInstance and child.get_child_count() == 0:
			objects[child.mesh] = objects.get(child.mesh, []) + [child]
	groups = {}
	if layer is MeshInstance:
		append(layer.mesh, [Transform()])
	for mesh in objects:
		var places = []
		for object in objects[mesh]:
			places.append(object.transform)
			layer.remove_child(object)
			object.free()
		if places.size() > 1 and triangles_of(mesh) * places.size() > COPIED_TRIANGLES:
			add_copies(mesh, places, layer, scene)
		else:
			append(mesh, places)
	add_joined(layer, scene)


static func triangles_of(mesh):
	var count = 0
	for i in mesh.get_surface_count():
		count += mesh.surface_get_array_index_len(i) / 3
	return count


func append(mesh, places):
	for i in mesh.get_surface_count():
		var material = mesh.surface_get_material(i)
		var look = look_of(material)
		if not look in groups:
			groups[look] = new_group(material)
		var coloured = with_colours(mesh, i)
		for place in places:
			groups[look]["tool"].append_from(coloured, 0, place)


func new_group(material):
	var surface = SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	return {"tool": surface, "material": shown_material(material)}


# Surfaces of one look can be joined: those without pictures look alike but for their colour.
func look_of(material):
	return "plain %d %s" % [material.params_cull_mode, material.metallic > 0.5] if is_plain(material) else material


static func is_plain(material):
	return not (material.albedo_texture or material.normal_texture or material.emission_enabled or material.flags_transparent)


func shown_material(material):
	var look = look_of(material)
	if not is_plain(material):
		material.vertex_color_use_as_albedo = true
		return material
	if not look in plain_materials:
		var plain = material.duplicate()
		plain.resource_name = look
		plain.albedo_color = Color(1, 1, 1)
		plain.vertex_color_use_as_albedo = true
		plain_materials[look] = plain
	return plain_materials[look]


# A mesh of one surface that has colours, in which the colour of a plain material is.
func with_colours(mesh, i):
	if not [mesh, i] in prepared:
		var arrays = mesh.surface_get_arrays(i)
		var material = mesh.surface_get_material(i)
		var base = linear(material.albedo_color) if is_plain(material) else Color(1, 1, 1)
		arrays[Mesh.ARRAY_COLOR] = tinted(arrays[Mesh.ARRAY_COLOR], base, arrays[Mesh.ARRAY_VERTEX].size())
		if is_plain(material):
			arrays[Mesh.ARRAY_TEX_UV] = null
		for unused in [Mesh.ARRAY_TANGENT, Mesh.ARRAY_TEX_UV2]:
			arrays[unused] = null
		var single = ArrayMesh.new()
		single.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], COMPRESS)
		prepared[[mesh, i]] = single
	return prepared[[mesh, i]]


static func tinted(colours, base, count):
	var result = PoolColorArray()
	result.resize(count)
	for i in count:
		result[i] = base * colours[i] if colours else base
	return result


# Godot's colours of materials are sRGB, those of vertices are linear.
static func linear(colour):
	return Color(linear_value(colour.r), linear_value(colour.g), linear_value(colour.b), colour.a)


static func linear_value(v):
	return v / 12.92 if v <= 0.04045 else pow((v + 0.055) / 1.055, 2.4)


# One mesh of all surfaces of a mesh, those without pictures joined.
func drawn_mesh():
	var mesh = ArrayMesh.new()
	for look in groups:
		groups[look]["tool"].commit(mesh, COMPRESS)
		mesh.surface_set_material(mesh.get_surface_count() - 1, groups[look]["material"])
	return mesh


func add_copies(mesh, places, layer, scene):
	var of_layer = groups
	groups = {}
	append(mesh, [Transform()])
	var instance = Copies.new()
	var multi = MultiMesh.new()
	multi.transform_format = MultiMesh.TRANSFORM_3D
	multi.mesh = drawn_mesh()
	groups = of_layer
	instance.places = places
	instance.name = mesh.resource_name
	instance.multimesh = multi
	layer.add_child(instance)
	instance.owner = scene


func add_joined(layer, scene):
	if groups.empty():
		return
	var mesh = drawn_mesh()
	mesh.resource_name = layer.name
	if layer is MeshInstance:
		layer.mesh = mesh
		return
	var instance = MeshInstance.new()
	instance.name = "joined"
	instance.mesh = mesh
	layer.add_child(instance)
	instance.owner = scene

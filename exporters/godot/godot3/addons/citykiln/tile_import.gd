# Runs when Godot imports a tile: leaves out layers that were not chosen, puts vertex colours in again, draws objects that
# share a mesh as one MultiMesh, and adds collision shapes. The choices are in city.json beside the tile.
tool
extends EditorScenePostImport

const TileColours = preload("tile_colours.gd")
const Copies = preload("copies.gd")

# Fewer objects of a mesh than this stay single objects.
const LEAST_COPIES = 2

var choices
var colours
var coloured = {}


func post_import(scene):
	var file = File.new()
	file.open(get_source_folder().plus_file("city.json"), File.READ)
	choices = parse_json(file.get_as_text())
	colours = TileColours.new().open(get_source_file())
	for tile in scene.get_children():
		for layer in tile.get_children():
			if layer.name in choices["layers"]:
				take_layer(layer, scene)
			else:
				tile.remove_child(layer)
				layer.free()
	scene.set_meta("box", box_of(scene, Transform()))
	return scene


func take_layer(layer, scene):
	var copies = {}
	for node in [layer] + layer.get_children():
		if node is MeshInstance:
			show_colours(node.mesh)
	for child in layer.get_children():
		if child is MeshInstance and child.get_child_count() == 0:
			copies[child.mesh] = copies.get(child.mesh, []) + [child]
	for mesh in copies:
		if copies[mesh].size() >= LEAST_COPIES:
			join(copies[mesh], mesh, layer, scene)
	if layer is MeshInstance and layer.name in choices["collision"] and is_finest():
		add_collision(layer, scene)


func show_colours(mesh):
	if not mesh in coloured:
		coloured[mesh] = true
		colours.apply(mesh)


# Replaces objects that share a mesh by one MultiMeshInstance.
func join(objects, mesh, layer, scene):
	var multi = MultiMesh.new()
	multi.transform_format = MultiMesh.TRANSFORM_3D
	multi.mesh = mesh
	var instance = Copies.new()
	# an exported array is one for all objects until another is assigned
	instance.places = []
	for object in objects:
		instance.places.append(object.transform)
		layer.remove_child(object)
		object.free()
	instance.name = mesh.resource_name
	instance.multimesh = multi
	layer.add_child(instance)
	instance.owner = scene


# Shapes are of the finest chosen level only: those of coarser levels would stand in the same place.
func is_finest():
	var level = int(get_source_file().get_basename().split("_L")[-1])
	return level == int(choices["levels"].min())


func add_collision(layer, scene):
	var body = StaticBody.new()
	var shape = CollisionShape.new()
	body.name = "collision"
	shape.shape = layer.mesh.create_trimesh_shape()
	layer.add_child(body)
	body.owner = scene
	body.add_child(shape)
	shape.owner = scene


func box_of(node, above):
	var here = above * node.transform if node is Spatial else above
	var box = here.xform(node.get_aabb()) if node is VisualInstance and not node is Light else AABB()
	for child in node.get_children():
		var of_child = box_of(child, here)
		if not of_child.has_no_area():
			box = of_child if box.has_no_area() else box.merge(of_child)
	return box

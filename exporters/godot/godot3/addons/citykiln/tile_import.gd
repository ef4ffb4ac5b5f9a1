# Runs when Godot imports a tile: leaves out layers that were not chosen, puts vertex colours in again, draws each layer in
# few calls, adds collision shapes, and notes what city.gd has to know of the tile: "box" (its extent), "calls" and
# "triangles" (what drawing it costs), "lamps" (places). The choices are in city.json beside the tile.
tool
extends EditorScenePostImport

const TileColours = preload("tile_colours.gd")
const Joined = preload("joined.gd")

var choices
var colours
var coloured = {}
var joined = Joined.new()
var lamps = []


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
	scene.set_meta("lamps", lamps)
	var cost = cost_of(scene)
	scene.set_meta("calls", cost[0])
	scene.set_meta("triangles", cost[1])
	return scene


func take_layer(layer, scene):
	for node in [layer] + layer.get_children():
		if node is MeshInstance:
			show_colours(node.mesh)
	if layer is MeshInstance and layer.name in choices["collision"] and is_finest():
		add_collision(layer, scene)
	lamps += lamps_of(layer)
	joined.join(layer, scene)
	if is_coarsest():
		cast_no_shadows(layer)


# The coarsest level is shown beyond the reach of shadows.
func cast_no_shadows(node):
	if node is GeometryInstance:
		node.cast_shadow = GeometryInstance.SHADOW_CASTING_SETTING_OFF
	for child in node.get_children():
		cast_no_shadows(child)


# The places of the lamps of streets and doors: the middle of each at its upper end.
func lamps_of(layer):
	var places = []
	var above = layer.get_parent().transform * layer.transform
	for child in layer.get_children():
		if child is MeshInstance and child.mesh.resource_name.ends_with("Lamp"):
			var box = child.mesh.get_aabb()
			var middle = box.position + box.size / 2
			places.append((above * child.transform).xform(Vector3(middle.x, box.end.y, middle.z)))
	return places


func show_colours(mesh):
	if not mesh in coloured:
		coloured[mesh] = true
		colours.apply(mesh)


# Shapes are of the finest chosen level only: those of coarser levels would stand in the same place.
func is_finest():
	return level() == int(choices["levels"].min())


func is_coarsest():
	return level() == int(choices["levels"].max()) and not is_finest()


func level():
	return int(get_source_file().get_basename().split("_L")[-1])


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


# The draw calls and triangles of a node and all below it.
func cost_of(node):
	var cost = [0, 0]
	if node is MeshInstance:
		cost = [node.mesh.get_surface_count(), Joined.triangles_of(node.mesh)]
	elif node is MultiMeshInstance:
		var mesh = node.multimesh.mesh
		cost = [mesh.get_surface_count(), Joined.triangles_of(mesh) * node.places.size()]
	for child in node.get_children():
		var of_child = cost_of(child)
		cost = [cost[0] + of_child[0], cost[1] + of_child[1]]
	return cost

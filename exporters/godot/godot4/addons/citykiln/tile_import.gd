# Runs when Godot imports a tile: leaves out layers that were not chosen, draws objects that share a mesh as one MultiMesh,
# adds collision shapes, and sets the distances between which the level is visible. The choices are in city.json beside the
# tile.
@tool
extends EditorScenePostImport

# Fewer objects of a mesh than this stay single objects.
const LEAST_COPIES := 2

var choices: Dictionary


func _post_import(scene: Node) -> Object:
	var path := get_source_file().get_base_dir().path_join("city.json")
	choices = JSON.parse_string(FileAccess.get_file_as_string(path))
	for tile in scene.get_children():
		for layer in tile.get_children():
			if String(layer.name) in choices["layers"]:
				take_layer(layer, scene)
			else:
				tile.remove_child(layer)
				layer.free()
		if tile is Node3D:
			set_ranges(tile)
	return scene


func take_layer(layer: Node, scene: Node) -> void:
	var copies := {}
	for child in layer.get_children():
		if child is MeshInstance3D and child.get_child_count() == 0:
			copies[child.mesh] = copies.get(child.mesh, []) + [child]
	for mesh: Mesh in copies:
		if copies[mesh].size() >= LEAST_COPIES:
			join(copies[mesh], mesh, layer, scene)
	if layer is MeshInstance3D and String(layer.name) in choices["collision"] and level() == finest():
		add_collision(layer, scene)


# Replaces objects that share a mesh by one MultiMeshInstance3D.
func join(objects: Array, mesh: Mesh, layer: Node, scene: Node) -> void:
	var multi := MultiMesh.new()
	multi.transform_format = MultiMesh.TRANSFORM_3D
	multi.mesh = mesh
	multi.instance_count = objects.size()
	for i in objects.size():
		var object: MeshInstance3D = objects[i]
		multi.set_instance_transform(i, object.transform)
		layer.remove_child(object)
		object.free()
	var instance := MultiMeshInstance3D.new()
	instance.name = mesh.resource_name
	instance.multimesh = multi
	layer.add_child(instance)
	instance.owner = scene


# Shapes are of the finest chosen level only: those of coarser levels would stand in the same place.
func add_collision(layer: MeshInstance3D, scene: Node) -> void:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	body.name = "collision"
	shape.shape = layer.mesh.create_trimesh_shape()
	layer.add_child(body)
	body.owner = scene
	body.add_child(shape)
	shape.owner = scene


func level() -> int:
	return get_source_file().get_basename().get_slice("_L", 1).to_int()


func finest() -> int:
	return int(choices["levels"].min())


# Makes all geometry of the tile visible between the same two distances. Godot measures from the middle of a box, so all
# levels get boxes with one middle: the middle of the tile at the height of its origin.
func set_ranges(tile: Node3D) -> void:
	var half: float = choices["tile_m"] / 2
	var middle := Vector3(half, 0, -half)
	var step: int = choices["levels"].map(func(number: float) -> int: return int(number)).find(level())
	for found in tile.find_children("*", "GeometryInstance3D"):
		var geometry := found as GeometryInstance3D
		var to_tile := transform_below(tile, geometry)
		var box := box_about(middle, to_tile * geometry.get_aabb())
		geometry.custom_aabb = to_tile.affine_inverse() * box
		geometry.visibility_range_begin = switch_m(step)
		geometry.visibility_range_end = switch_m(step + 1)


# The distance from a tile's middle at which a level takes over from the finer one; 0, no limit, before the first and after
# the last.
func switch_m(step: int) -> float:
	var errors: Array = choices["errors_m"]
	if step <= 0 or step >= errors.size():
		return 0.0
	var pixels_at_1_m: float = choices["screen_px"] / (2 * tan(deg_to_rad(choices["fov_deg"]) / 2))
	return errors[step] * pixels_at_1_m / choices["pixel_error"] + choices["tile_m"] * sqrt(0.5)


func transform_below(tile: Node3D, node: Node3D) -> Transform3D:
	var all := Transform3D()
	var at: Node = node
	while at != tile:
		if at is Node3D:
			all = at.transform * all
		at = at.get_parent()
	return all


# The smallest box with this middle that contains a box.
func box_about(middle: Vector3, box: AABB) -> AABB:
	var far := (box.position - middle).abs().max((box.end - middle).abs())
	return AABB(middle - far, 2 * far)

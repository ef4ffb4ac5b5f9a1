# Runs inside Godot 3: loads a city that exporters/godot/godot3 made, writes facts about it as JSON, and draws pictures. The
# environment variable JOB names a JSON file: "scene", "facts", "pictures" (out, eye, look, fov_deg, size), "rays" (from).
extends SceneTree

var job
var city


func _init():
	var file = File.new()
	file.open(OS.get_environment("JOB"), File.READ)
	job = parse_json(file.get_as_text())
	city = load(job["scene"]).instance()
	get_root().add_child(city)
	light_and_camera()
	var facts = {"tiles": {}, "shown": [], "hits": []}
	for tile in city.get_children():
		if tile is Light or tile is WorldEnvironment:
			continue
		facts["tiles"][tile.name] = {}
		for level in tile.get_children():
			facts["tiles"][tile.name][level.name] = facts_of(level)
	for picture in job["pictures"]:
		yield(draw(picture), "completed")
		facts["shown"].append(shown_levels())
	# shapes of hidden levels would be hit too
	yield(self, "physics_frame")
	for ray in job["rays"]:
		facts["hits"].append(hit_below(ray))
	file.open(job["facts"], File.WRITE)
	file.store_string(to_json(facts))
	file.close()
	quit()


func below(node):
	var found = [node]
	for child in node.get_children():
		found += below(child)
	return found


func facts_of(level):
	var facts = {"layers": [], "objects": 0, "multis": 0, "copies": 0, "places": 0, "triangles": 0, "shapes": []}
	for layer in level.get_child(0).get_children():
		facts["layers"].append(layer.name)
	for node in below(level):
		if node is MeshInstance:
			facts["objects"] += 1
			facts["triangles"] += triangles_of(node.mesh)
		elif node is MultiMeshInstance:
			facts["multis"] += 1
			facts["copies"] += node.multimesh.instance_count
			facts["places"] += places_of(node.multimesh)
			facts["triangles"] += triangles_of(node.multimesh.mesh) * node.multimesh.instance_count
		elif node is CollisionShape:
			facts["shapes"].append(node.get_parent().get_parent().name)
	return facts


# The number of different places of copies.
func places_of(multimesh):
	var places = {}
	for i in multimesh.instance_count:
		places[multimesh.get_instance_transform(i).origin] = true
	return places.size()


func triangles_of(mesh):
	var count = 0
	for i in mesh.get_surface_count():
		count += mesh.surface_get_array_index_len(i) / 3
	return count


func shown_levels():
	var shown = {}
	for tile in city.get_children():
		for level in tile.get_children():
			if level.visible:
				shown[tile.name] = shown.get(tile.name, []) + [level.name]
	return shown


func hit_below(place):
	var from = Vector3(place[0], place[1], place[2])
	var hit = get_root().world.direct_space_state.intersect_ray(from, from - Vector3(0, 1000, 0))
	if hit.empty():
		return null
	return {"height_m": hit["position"].y, "layer": hit["collider"].get_parent().name}


func light_and_camera():
	var camera = Camera.new()
	camera.name = "camera"
	camera.far = 6000
	camera.near = 1
	get_root().add_child(camera)
	camera.make_current()
	camera.environment = Environment.new()
	camera.environment.background_mode = Environment.BG_SKY
	camera.environment.background_sky = ProceduralSky.new()
	camera.environment.ambient_light_energy = 0.9
	camera.environment.tonemap_mode = Environment.TONE_MAPPER_FILMIC
	var sun = DirectionalLight.new()
	get_root().add_child(sun)
	sun.look_at_from_position(Vector3(-0.816, 0.574, 0.3), Vector3(0, 0, 0), Vector3(0, 1, 0))
	sun.shadow_enabled = true
	sun.directional_shadow_max_distance = 900
	sun.light_energy = 1.3


func draw(picture):
	var size = Vector2(picture["size"][0], picture["size"][1])
	OS.window_size = size
	get_root().size = size
	var camera = get_root().get_node("camera")
	camera.fov = picture["fov_deg"]
	var eye = picture["eye"]
	var look = picture["look"]
	camera.look_at_from_position(Vector3(eye[0], eye[1], eye[2]), Vector3(look[0], look[1], look[2]), Vector3(0, 1, 0))
	city.choose_levels()
	for i in 4:
		yield(self, "idle_frame")
	var image = get_root().get_texture().get_data()
	image.flip_y()
	image.save_png(picture["out"])
